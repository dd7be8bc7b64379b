// SPDX-License-Identifier: GPL-3.0-or-later
// The page: its parts, and when they are drawn.
import { html, render } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { rwedge } from "./answers/library.js";
import { asCommand, asPython } from "./export.js";
import { copyButton, download, options, remembered } from "./parts.js";
import { form } from "./left/form.js";
import { finder } from "./left/find.js";
import { drawingOf } from "./left/drawing.js";
import { makeModel } from "./model.js";
import { narrow } from "./plot/axes.js";
import { worstPlace } from "./tabs/cycle.js";
import { tabList, tabPanels } from "./tabs/tabs.js";
import { isSilent, verdict } from "./verdict.js";
import { unitsRemark, unitSystems } from "./units.js";
import * as states from "./state.js";

const { state, setter } = states;

const saveCase = () => download("rounded-wedge-case.txt", states.wholeAddress(), "text/plain");

/** A file that was saved here. */
async function openCase({ target }) {
    const [file] = target.files;
    if (!file) return;
    states.take(states.readAddress((await file.text()).trim()));
    target.value = "";
}

const converts = () => document.getElementById("convert").checked;
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
    ${copyButton("Copy a link to this case", link, () => (states.isTooLong() ? "Copied without the pasted rows" : "Copied"))}
    <span><input type="file" id="open-case" class="hidden" accept=".txt,text/plain" @change=${openCase}><label
        for="open-case" class="button">Open a saved case</label></span>`;

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

const onPaper = () =>
    [state.name, new Date().toLocaleDateString(), `rwedge ${rwedge.version()}`].filter(Boolean).join(", ");

const above = (model) => html`<p class="printed">${onPaper()}</p>
    ${verdict(model, state.tab)}`;

const answers = (model) => html`
    <p class="note bad" id="too-long" role="status" ?hidden=${!states.isTooLong()}>
        The pasted rows are too long for a link: it leaves them out, and they are gone when the page is loaded again.
        <button type="button" @click=${saveCase}>Save all of it as a file</button>
    </p>
    ${tabList()} ${tabPanels(model)}
`;

let waiting = 0;
/** The address follows a little later: browsers refuse many changes a second. */
function remember() {
    clearTimeout(waiting);
    waiting = setTimeout(() => {
        if (location.hash !== states.address()) history.replaceState(null, "", states.address());
    }, 250);
}

const present = remembered(() => makeModel(state));
const put = (part, id) => render(part, document.getElementById(id));

/** The answers come first: the drawing shows what of them is worst. */
function draw() {
    const began = performance.now();
    const model = present(JSON.stringify([state.texts, state.pad, state.units, state.digits, state.sign, state.name]));
    put(answers(model), "answers");
    put(theCase(model), "case");
    put(above(model), "verdict");
    document.getElementById("verdict").classList.toggle("silent", isSilent(model, state.tab));
    put(settings(), "settings");
    document.body.dataset.milliseconds = (performance.now() - began).toFixed(1);
    remember();
}

const begin = () => states.take(states.readAddress(location.hash));

states.drawWith(draw);
document.getElementById("case").replaceChildren();
begin();
narrow.addEventListener("change", draw);
window.addEventListener("hashchange", () => {
    if (location.hash !== states.address()) begin();
});
