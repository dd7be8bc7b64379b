// SPDX-License-Identifier: GPL-3.0-or-later
// The page: its parts, and when they are drawn.
import { html, nothing, render } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { asCommand, asPython } from "./export.js";
import { copyButton, download, fileName, options, remembered } from "./parts.js";
import { form } from "./left/form.js";
import { finder } from "./left/find.js";
import { drawingOf } from "./left/drawing.js";
import { readCase, writtenCase } from "./answers/case_file.js";
import { inputTexts, makeModel } from "./model.js";
import { narrow } from "./plot/axes.js";
import { carry } from "./plot/save.js";
import { aside as history, worstPlace } from "./tabs/cycle.js";
import { linesOf as shippedLines } from "./tabs/material.js";
import { tabList, tabPanels } from "./tabs/tabs.js";
import { fillReport } from "./report.js";
import { isSilent, verdict } from "./verdict.js";
import { unitsNamed, unitsRemark, unitSystems } from "./units.js";
import * as states from "./state.js";

const { state, setter } = states;

/** The loads of the Cycle tab are the case's, where it is seen and has some. */
function loadsOfCycle() {
    const { loads, tilts, displacements } = (state.tab === "cycle" && state.loads.trim() !== "" && history.answer) || {};
    const given = (i) => ({ ...(tilts && { tilt: tilts[i] }), ...(displacements && { displacement: displacements[i] }) });
    return loads?.map((load, i) => ({ ...load, ...given(i) }));
}

function saveCase() {
    const { name, sign, material, shipped, compliance } = state;
    const told = { name, texts: present.value.texts, sign, material, shipped, compliance, loads: loadsOfCycle(), settings: states.shownSettings() };
    download(`${fileName("") || "case"}.json`, writtenCase(told), "application/json");
}

/** A file that was saved here, or by the tool; of older pages an address. */
async function openCase({ target }) {
    const [file] = target.files;
    if (!file) return;
    const text = (await file.text()).trim();
    target.value = "";
    try {
        const texts = text.startsWith("#") ? states.readAddress(text) : readCase(text, states.shortNumber);
        if (texts.shipped) texts.material = shippedLines(texts.shipped);
        states.take({ ...texts, ...(!text.startsWith("#") && { units: unitsNamed(texts.units) }) });
        fault = "";
    } catch (error) {
        fault = `${file.name}: ${error.message}`;
    }
    states.redraw();
}
let fault = ""; // of a file that was opened last

const converts = () => document.getElementById("convert").checked;
/** Of a page that is a file on this machine, no one else has the link. */
const canLink = location.protocol.startsWith("http");
const link = () => location.href.replace(/#.*/, "") + states.address();

function choice(name, label, titles, change) {
    const id = `set-${name}`;
    return html`<span><label for=${id}>${label}</label><select id=${id} @change=${change}>${options(titles, state[name])}</select></span>`;
}

const settings = () => html`
    <span><label for="case-name">Name</label><input type="text" id="case-name" size="14" autocomplete="off"
        .value=${live(state.name)} @input=${setter("name")}></span>
    ${choice("units", "Units", unitSystems, ({ target }) => states.setUnits(target.value, converts()))}
    ${choice("digits", "Digits", states.digits, setter("digits"))}
    ${choice("sign", "Decimal sign", states.signs, ({ target }) => states.setSign(target.value))}
    <span><input type="checkbox" id="convert" checked><label for="convert">convert numbers with the units</label></span>
    <span><button type="button" id="save-case" @click=${saveCase}>Save the case</button>
        <input type="file" id="open-case" class="hidden" accept=".json,.txt,application/json,text/plain" @change=${openCase}><label
        for="open-case" class="button">Open a case</label>
        <button type="button" id="undo" ?disabled=${!states.canUndo()} @click=${states.undo}>Undo</button>
        <button type="button" id="redo" ?disabled=${!states.canRedo()} @click=${states.redo}>Redo</button></span>
    ${canLink ? copyButton("Copy a link to this case", link, () => (states.isTooLong() ? "Copied without the pasted rows" : "Copied")) : nothing}
    <p class="note bad" id="open-fault" role="alert" ?hidden=${fault === ""}>${fault}</p>`;

/** The case as a text for elsewhere. */
function exported(name, model, write) {
    const text = () => (model.results ? write(model) : "The status says what is missing.");
    return html`<p class="tools">${name}${copyButton(`Copy ${name}`, text)}</p>
        <pre id="as-${name.toLowerCase()}" tabindex="0">${text()}</pre>`;
}

const drawing = remembered(drawingOf);

const theCase = (model) => html`
    <div class="drawing ${model.pictured === model ? "" : "old"}" .innerHTML=${drawing(model.pictured, worstPlace())}></div>
    ${form(model)} ${finder(model)}
    <p class="note">${unitsRemark}</p>
    <details>
        <summary>This case as a command and in Python</summary>
        ${exported("Command", model, asCommand)} ${exported("Python", model, asPython)}
    </details>
`;

const above = (model) => verdict(model, state.tab);

const answers = (model) => html`
    <p class="note bad" id="too-long" role="status" ?hidden=${!states.isTooLong()}>
        The pasted rows are too long for the address: they are gone when the page is loaded again.
        <button type="button" @click=${saveCase}>Save all of it as a file</button>
    </p>
    ${tabList()} ${tabPanels(model)}
`;

let waiting = 0;
/** The address follows a little later: browsers refuse many changes a second. */
function remember() {
    clearTimeout(waiting);
    waiting = setTimeout(() => {
        if (location.hash !== states.address()) window.history.replaceState(null, "", states.address());
    }, 250);
}

const model = remembered(() => makeModel(state)),
    present = { value: null };
const TITLE = document.title;
const put = (part, id) => render(part, document.getElementById(id));

/** The answers come first: the drawing shows what of them is worst. */
function draw() {
    const began = performance.now();
    const { texts, pad, units, width, section, plane, body, rotation, digits, sign, name } = state,
        drawn = model(JSON.stringify([texts, pad, units, width, section, plane, body, rotation, digits, sign, name]));
    present.value = drawn;
    states.keep();
    carry([...(name ? [name] : []), ...inputTexts(drawn)]);
    document.title = name ? `${name} \u2013 ${TITLE}` : TITLE;
    put(answers(drawn), "answers");
    put(theCase(drawn), "case");
    put(above(drawn), "verdict");
    document.getElementById("verdict").classList.toggle("silent", isSilent(drawn, state.tab));
    put(settings(), "settings");
    document.body.dataset.milliseconds = (performance.now() - began).toFixed(1);
    remember();
}

const begin = () => states.take(states.readAddress(location.hash));

states.drawWith(draw);
document.getElementById("case").replaceChildren();
begin();
narrow.addEventListener("change", draw);
window.addEventListener("beforeprint", () => fillReport(document.getElementById("report"), present.value));
window.addEventListener("hashchange", () => {
    if (location.hash !== states.address()) begin();
});
