// SPDX-License-Identifier: GPL-3.0-or-later
// The page: its state, its parts, and when they are drawn.
import { readAddress, writeAddress } from "./address.js";
import { rwedge } from "./library.js";
import { asCommand, asPython } from "./export.js";
import { copyButton, download, element } from "./elements.js";
import { makeForm } from "./left/form.js";
import { makeFinder } from "./left/find.js";
import { drawingOf } from "./left/drawing.js";
import { makeModel } from "./model.js";
import { padOf, pads } from "./pads.js";
import { narrow } from "./plot/axes.js";
import { measures } from "./stresses.js";
import { makeTabs } from "./tabs/tabs.js";
import { makeVerdict } from "./verdict.js";
import { conversion, unitsRemark, unitSystems } from "./units.js";
import { readNumber, writeNumber } from "./number.js";
import { criteria, inputNames, inputs } from "./words.js";

/** Two steel bodies, as in the workbook. */
const example = { E1: "210000", nu1: "0.3", theta: "0.01", a: "0.05", P: "190", Q: "20", f: "0.2", k: "400" };
const settings = {
    name: "",
    pad: "",
    units: "mm",
    digits: "4",
    sign: ".",
    tab: "contact",
    measure: "von_mises",
    probe_x: "0",
    probe_y: "0.05",
    loads: "",
    cycles: "3",
    criterion: "swt",
    plane: "",
    material: "",
    batch: "",
};
const LONGEST = 20000; // characters of an address that every browser takes

const state = { texts: {}, way: {} };

function take(texts) {
    const anything = inputNames.some((name) => name in texts);
    state.texts = Object.fromEntries(
        [...inputNames, "hull"].filter((name) => (texts[name] ?? "") !== "").map((name) => [name, texts[name]]),
    );
    if (!anything) state.texts = { ...example };
    state.way = Object.fromEntries(
        ["theta_deg", "radius", "yield_stress"].filter((name) => state.texts[name]).map((name) => [name, true]),
    );
    for (const [name, usual] of Object.entries(settings)) state[name] = texts[name] ?? usual;
    if (!Object.hasOwn(pads, state.pad)) state.pad = padOf(state.texts);
    if (!Object.hasOwn(unitSystems, state.units)) state.units = settings.units;
    if (!Object.hasOwn(measures, state.measure)) state.measure = settings.measure;
    if (!Object.hasOwn(criteria, state.criterion)) state.criterion = settings.criterion;
    state.digits = [4, 6, 10, 14].includes(Number(state.digits)) ? Number(state.digits) : 4;
    state.sign = state.sign === "," ? "," : ".";
}

function wholeAddress() {
    const changed = Object.keys(settings).filter((name) => String(state[name]) !== settings[name]);
    return writeAddress({ ...state.texts, ...Object.fromEntries(changed.map((name) => [name, String(state[name])])) });
}

/** What is pasted may be too long for it. */
function address() {
    const text = wholeAddress();
    return text.length <= LONGEST ? text : writeAddress({ ...state.texts, tab: state.tab });
}

let waiting = 0;
/** The address follows a little later: browsers refuse many changes a second. */
function remember() {
    clearTimeout(waiting);
    tooLong.hidden = wholeAddress().length <= LONGEST;
    waiting = setTimeout(() => {
        if (location.hash !== address()) history.replaceState(null, "", address());
    }, 250);
}

let model;
const form = makeForm(state, () => render());
const tabs = makeTabs(
    state,
    () => model,
    () => {
        verdict.show(model, state.tab);
        remember();
    },
);
const finder = makeFinder(form.take);
const drawing = element("div", { class: "drawing" });
const verdict = makeVerdict();
const exports = element("div", {});
const printed = element("p", { class: "printed" }); // seen on paper alone
const tooLong = element(
    "p",
    { class: "note bad", id: "too-long", role: "status", hidden: true },
    "The pasted rows are too long for a link: it leaves them out, and they are gone when the page is loaded again. ",
    element("button", { type: "button", onclick: saveCase }, "Save all of it as a file"),
);

function saveCase() {
    download("rounded-wedge-case.txt", new Blob([wholeAddress()], { type: "text/plain" }));
}

/** A file that was saved here. */
async function openCase({ target }) {
    const [file] = target.files;
    if (!file) return;
    show(readAddress((await file.text()).trim()));
    target.value = "";
}

function showExports() {
    const whole = Boolean(model.results);
    exports
        .querySelectorAll("pre")
        .forEach(
            (pre, i) =>
                (pre.textContent = whole ? [asCommand, asPython][i](model) : "The status says what is missing."),
        );
}

function render() {
    const began = performance.now();
    model = makeModel(state);
    form.show(model);
    finder.show(model);
    if (model.results || drawing.innerHTML === "") drawing.innerHTML = drawingOf(model);
    drawing.classList.toggle("old", !model.results && drawing.dataset.kind === "case");
    if (model.results) drawing.dataset.kind = "case";
    tabs.show(model);
    verdict.show(model, state.tab);
    if (exports.querySelector("details").open) showExports();
    document.body.dataset.milliseconds = (performance.now() - began).toFixed(1);
    printed.textContent = [state.name, new Date().toLocaleDateString(), `rwedge ${rwedge.version()}`]
        .filter(Boolean)
        .join(", ");
    remember();
}

/** What is typed has the chosen decimal sign too. */
function rewriteNumbers() {
    const [from, to] = state.sign === "," ? [".", ","] : [",", "."];
    const rewritten = (text) => (text.split(from).length === 2 && !text.includes(to) ? text.replace(from, to) : text);
    for (const [name, text] of Object.entries(state.texts)) if (name !== "profile") state.texts[name] = rewritten(text);
    for (const name of ["probe_x", "probe_y"]) state[name] = rewritten(state[name]);
}

/** The numbers of the form and the place that is looked at; pasted tables stay. */
function convertNumbers(from, to) {
    const converted = (text, dimension) => {
        const factor = conversion(from, to, dimension),
            value = readNumber(text, state.sign);
        return factor === 1 || Number.isNaN(value) ? text : writeNumber(value * factor, 12, state.sign);
    };
    for (const [name, text] of Object.entries(state.texts)) state.texts[name] = converted(text, inputs[name]?.unit);
    for (const name of ["probe_x", "probe_y"]) state[name] = converted(state[name], "length");
}

const converts = element("input", { type: "checkbox", id: "convert" });
const caseName = element("input", { type: "text", id: "case-name", size: 14, autocomplete: "off" });
caseName.addEventListener("input", () => {
    state.name = caseName.value;
    render();
});

function setting(name, label, options) {
    const select = element(
        "select",
        { id: `set-${name}` },
        ...Object.entries(options).map(([value, text]) => element("option", { value }, text)),
    );
    select.addEventListener("change", () => {
        if (name === "units" && converts.checked) convertNumbers(state.units, select.value);
        state[name] = name === "digits" ? Number(select.value) : select.value;
        if (name === "sign") rewriteNumbers();
        render();
    });
    return {
        select,
        parts: [element("label", { for: `set-${name}` }, label), select],
        show: () => (select.value = String(state[name])),
    };
}

const chosen = [
    setting("units", "Units", Object.fromEntries(Object.entries(unitSystems).map(([key, { name }]) => [key, name]))),
    setting("digits", "Digits", { 4: "4", 6: "6", 10: "10", 14: "14" }),
    setting("sign", "Decimal sign", { ".": "point", ",": "comma" }),
];

function build() {
    document.getElementById("settings").append(
        element("span", {}, element("label", { for: "case-name" }, "Name"), caseName),
        ...chosen.map(({ parts }) => element("span", {}, ...parts)),
        element("span", {}, converts, element("label", { for: "convert" }, "convert numbers with the units")),
        copyButton(
            "Copy a link to this case",
            () => location.href.replace(/#.*/, "") + address(),
            () => (tooLong.hidden ? "Copied" : "Copied without the pasted rows"),
        ),
        element(
            "span",
            {},
            element("input", {
                type: "file",
                id: "open-case",
                class: "hidden",
                accept: ".txt,text/plain",
                onchange: openCase,
            }),
            element("label", { for: "open-case", class: "button" }, "Open a saved case"),
        ),
    );
    const details = element(
        "details",
        {},
        element("summary", {}, "This case as a command and in Python"),
        ...["Command", "Python"].flatMap((name) => {
            const pre = element("pre", { id: `as-${name.toLowerCase()}`, tabindex: "0" });
            return [
                element(
                    "p",
                    { class: "tools" },
                    name,
                    copyButton(`Copy ${name}`, () => pre.textContent),
                ),
                pre,
            ];
        }),
    );
    details.addEventListener("toggle", showExports);
    exports.append(details);
    document
        .getElementById("case")
        .replaceChildren(drawing, form.box, finder.box, element("p", { class: "note" }, unitsRemark), exports);
    document.getElementById("verdict").append(printed, verdict.box);
    document.getElementById("answers").append(tooLong, tabs.list, ...tabs.panels);
}

function show(texts) {
    take(texts);
    if (state.sign === ",") rewriteNumbers();
    for (const each of chosen) each.show();
    caseName.value = state.name;
    render();
}

const begin = () => show(readAddress(location.hash));

build();
begin();
narrow.addEventListener("change", render);
window.addEventListener("hashchange", () => {
    if (location.hash !== address()) begin();
});
