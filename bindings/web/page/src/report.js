// SPDX-License-Identifier: GPL-3.0-or-later
// The case on one page of paper, by the template of "rwedge report": what the browser prints. It is filled when that begins.
import { rwedge } from "./answers/library.js";
import { isOffCentre } from "./answers/solution.js";
import { inputs, measures, resultKinds } from "./answers/words.js";
import { drawingOf } from "./left/drawing.js";
import { escaped } from "./parts.js";
import { styleOfFile } from "./plot/save.js";
import { state, written } from "./state.js";
import { tractionsText } from "./tabs/contact.js";
import { cycleSeen, worstPlace } from "./tabs/cycle.js";
import { stressText } from "./tabs/stress.js";
import { ofEdges } from "./tabs/symbols.js";
import { unitSystems } from "./units.js";
import { texts } from "texts";

const LOADS_SHOWN = 8,
    INPUT_DIGITS = 8;

const signed = (text) => escaped(text).replace(/^-/, "\u2212");
/** Without remarks, and what is of the command line. */
const short = (meaning) => escaped(meaning.split(/;|, or --|, in place of --| \(default| instead|, in radians|, whose|, 0 to /)[0]);
const line = (meaning, name, value, unit = "") =>
    `<div><span>${short(meaning)} <span class="meaning">${escaped(name)}</span></span><b>${signed(value)}</b><i>${escaped(unit)}</i></div>`;
const items = (list = []) => list.map((text) => `<li>${escaped(text)}</li>`).join("");
const equationText = ({ unit, write }, { name, symbols, numbers, value, unit: dimension }) =>
    `<p><b>${escaped(name)}</b> = ${escaped(symbols)} = <code>${escaped(numbers)}</code> = <b>${escaped(write(value))}</b> ${escaped(unit[dimension] ?? "")}</p>`;
const row = (cells, tag = "td") => `<tr>${cells.map((cell) => `<${tag}>${signed(cell)}</${tag}>`).join("")}</tr>`;

const inputLines = ({ inputs: numbers, unit }) =>
    Object.entries(numbers).map(([name, value]) =>
        name === "profile" ? line("Profile", name, `${value} places`) : line(inputs[name].meaning, name, written(value, INPUT_DIGITS), unit[inputs[name].unit]));

function resultLines({ results, setup, unit, write }) {
    const isShown = (name) => !["warnings", "safety_strength"].includes(name) && (isOffCentre(setup) || !ofEdges.includes(name));
    return Object.entries(resultKinds)
        .filter(([name]) => isShown(name) && write(results[name]) !== "")
        .map(([name, kind]) => line(kind.meaning, name, write(results[name]), unit[kind.unit]));
}

/** What the template asks of the last cycle of pasted loads. */
function cycleParts({ loads, worst, criterion, limit, safety, life }, { unit, write }) {
    const named = ["P", "M", "Q", "sigma"],
        verdictOf = (name) => (name === criterion.name ? [limit, safety, life] : [null, null, null]);
    return {
        loads_caption: `${loads.length} loads${loads.length > LOADS_SHOWN ? `, of which the first ${LOADS_SHOWN} are shown` : ""}`,
        loads: row(["load", ...named], "th") + loads.slice(0, LOADS_SHOWN).map((load, i) => row([i + 1, ...named.map((name) => write(load[name]))])).join(""),
        cycle_caption: `Where each measure is largest along the surface, in the last of ${escaped(state.cycles)} passes of the loads`,
        cycle:
            row(["measure", "largest", "", "at x", "allowable", "safety", "life, passes"], "th") +
            Object.entries(worst).map(([name, { value, x }]) =>
                row([name, write(value), unit[measures[name].unit] ?? "", write(x), ...verdictOf(name).map(write)])).join(""),
        shakedown: "",
    };
}

/** By the names of the template. */
function partsOf(model) {
    const { verdict, results } = model,
        cycle = cycleSeen();
    return {
        name: escaped(state.name || "Contact"),
        made: escaped(`rwedge ${rwedge.version()}, the page; units ${unitSystems[state.units].name}; ${new Date().toLocaleDateString()}`),
        colour: verdict.colour,
        state: escaped(verdict.text),
        strength: escaped(verdict.strength ?? ""),
        inputs: inputLines(model).join(""),
        results: results ? resultLines(model).join("") : "",
        assumed: items(model.assumed),
        errors: items(model.told),
        ...(document.getElementById("equations")?.open && { equations: (model.equations ?? []).map((each) => equationText(model, each)).join("") }),
        ...(results && { pictures: "", picture_contact: drawingOf(model, worstPlace()), picture_tractions: tractionsText(model), picture_stress: stressText(model) }),
        ...(cycle && results && { history: "", ...cycleParts(cycle, model) }),
    };
}

/** The body of the template: lines between {{if NAME}} and {{end}} are there where the part is. */
function filled(template, parts) {
    const [, body] = template.match(/<body>([^]*)<\/body>/),
        there = body.replace(/^\{\{if (\w+)\}\}\n([^]*?)^\{\{end\}\}\n/gm, (_, name, lines) => (name in parts ? lines : ""));
    return there.replace(/\{\{(\w+)\}\}/g, (_, name) => parts[name] ?? "");
}

/** The template's own style, in a tree of its own, which the page's does not reach. */
function styleOf(template) {
    const [, style] = template.match(/<style>([^]*)<\/style>/);
    return style.replace(/@page \{[^}]*\}/, "").replaceAll(":root", ":host").replace(/(^|\s)body \{/g, "$1.sheet {");
}

let shadow;
/** Puts the report of the present case into the element that is printed. */
export function fillReport(element, model) {
    if (!shadow) {
        shadow = element.attachShadow({ mode: "open" });
        shadow.adoptedStyleSheets = [styleOf(texts.report), styleOfFile()].map((text) => {
            const sheet = new CSSStyleSheet();
            sheet.replaceSync(text);
            return sheet;
        });
    }
    shadow.innerHTML = `<div class="sheet">${filled(texts.report, partsOf(model))}</div>`;
}
