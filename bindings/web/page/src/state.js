// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the page: texts, as they are typed, and choices. It is the part of the address behind #: a case can be sent as a link.
import { readNumber, writeNumber } from "./number.js";
import { makingNames, padOf, pads } from "./pads.js";
import { measures } from "./answers/stresses.js";
import { unitSystems, wordsOf } from "./units.js";
import { constantFactorOf, factorOf } from "./answers/library.js";
import { criteria, inputNames, inputs } from "./answers/words.js";
import { convertedMaterial, convertedTable } from "./convert.js";

/** Two steel bodies, as in the workbook. */
const example = { E1: "210000", nu1: "0.3", theta: "0.01", a: "0.05", P: "190", Q: "20", f: "0.2", k: "400" };
const settings = {
    name: "",
    pad: "",
    units: "mm",
    width: "",
    section: "",
    digits: "4",
    sign: ".",
    tab: "contact",
    measure: "von_mises",
    probe_x: "0",
    probe_y: "0.05",
    loads: "",
    compliance: "",
    cycles: "3",
    criterion: "swt",
    plane: "",
    body: "",
    rotation: "",
    material: "",
    crack_edge: "left",
    crack_angle: "0",
    crack_from: "",
    crack_to: "",
    shipped: "",
    wanted: "",
    batch: "",
    find: "radius",
    factor: "P",
    safety: "2",
};
export const tabs = {
    contact: "Contact",
    stress: "Stress",
    strength: "Strength",
    cycle: "Cycle",
    batch: "Batch",
    compare: "Compare",
    about: "About",
};
export const signs = { ".": "point", ",": "comma" };
export const edges = { left: "left", right: "right" };
/** What can be found for a safety. */
export const findable = { radius: "Radius R", a: "Half-width of rounding a", P: "Load P", f: "Friction f" };
/** On which factor that is. */
export const factors = { stress: "on the stress, under these loads", sliding: "on the stress, if it slid", P: "on P, in full sliding" };
export const digits = { 4: "4", 6: "6", 10: "10", 14: "14" };
/** Whose strength is asked, and whose k is given. */
export const strengths = { "": "of the half-plane, body 1", 2: "of the pad, body 2" };
/** Of unlike bodies with friction: whether the pad may turn. The last one neglects what friction then does. */
export const rotations = { "": "not said", held: "held by the rig", free: "free to tilt", similar: "as of similar bodies" };
/** What a setting may be; another word is the usual one. */
const allowed = {
    units: unitSystems,
    digits,
    sign: signs,
    body: strengths,
    rotation: rotations,
    tab: tabs,
    measure: measures,
    criterion: criteria,
    crack_edge: edges,
    find: findable,
    factor: factors,
};
/** Those that a case file has in words of its own. */
const ofFile = ["name", "units", "width", "section", "plane", "body", "rotation", "material", "shipped", "compliance"];
const LONGEST = 20000; // characters of an address that every browser takes

/** texts: of the inputs, by name; way: which of the ways to give an input is chosen. */
export const state = { texts: {}, way: {} };

let draw;
/** What is done after each change. */
export const drawWith = (f) => (draw = f);
export const redraw = () => draw();

// ---- Undo and redo: states as they were, the present one last; those that were undone ----

const done = [],
    undone = [];
const PAUSE = 700, // milliseconds: keys that are typed faster are one change
    KEPT = 200;
let lastChange = -Infinity;

/** The state as an address; whatever was typed first, the same state has the same. */
function ordered() {
    const all = new URLSearchParams(wholeAddress().slice(1));
    all.sort();
    return `#${all}`;
}

/** To be called when it is drawn: the present state is kept. */
export function keep() {
    const present = ordered(),
        now = performance.now();
    if (present === done.at(-1)) return;
    if (now - lastChange < PAUSE && done.length > 1) done.pop();
    else if (done.length >= KEPT) done.shift();
    lastChange = now;
    done.push(present);
    undone.length = 0;
}

const go = (from, to) => () => {
    to.push(from.pop());
    const texts = readAddress(done.at(-1));
    lastChange = -Infinity;
    take({ ...noInputs, ...texts });
};
/** Their functions, and whether there is something to undo or redo. */
export const undo = go(done, undone),
    redo = go(undone, done);
export const canUndo = () => done.length > 1;
export const canRedo = () => undone.length > 0;

export function set(changes) {
    Object.assign(state, changes);
    draw();
}

/** For an input or a choice of the page: what is typed becomes this part of the state. */
export const setter =
    (name) =>
    ({ target }) =>
        set({ [name]: target.value });

/** An address without inputs begins with the example; a state without any stays so. */
const noInputs = { E1: "" };

/** All of it anew. */
export function take(texts) {
    const filled = [...inputNames, ...makingNames].filter((name) => (texts[name] ?? "") !== "");
    state.texts = inputNames.some((name) => name in texts)
        ? Object.fromEntries(filled.map((name) => [name, texts[name]]))
        : { ...example };
    state.way = { ...state.texts };
    for (const [name, usual] of Object.entries(settings)) {
        const text = texts[name] ?? usual;
        state[name] = !allowed[name] || Object.hasOwn(allowed[name], text) ? text : usual;
    }
    if (!Object.hasOwn(pads, state.pad)) state.pad = padOf(state.texts);
    if (state.sign === ",") rewriteNumbers();
    draw();
}

/** A number as it is typed and shown: with the chosen decimal sign. */
export const typed = (text) => readNumber(text, state.sign);
export const written = (value, digits) => writeNumber(value, digits, state.sign);

/** As short as it is, for ticks and files. */
export const shortNumber = (value) => String(value).replace(".", state.sign);

const lengths = ["width", "probe_x", "probe_y", "crack_from", "crack_to"];

/** The dimension of a load as it is typed: with a width P, Q and M are those of the whole contact, with a section a tension is a force. */
export function typedDimension(name) {
    const { unit } = inputs[name] ?? {};
    if (name === "displacement") return "length";
    if (name === "sigma") return state.section.trim() === "" ? unit : "force";
    return state.width.trim() === "" ? unit : ({ "force/length": "force", force: "force*length" }[unit] ?? unit);
}

/** That of a rig's compliance: with a width it is the one under the force on the whole contact. */
export const complianceDimension = () => (state.width.trim() === "" ? "area/force" : "length/force");

/** Changes the numbers of the form, the place that is looked at and the lengths of a crack, by their dimensions. */
function changeNumbers(changed) {
    for (const [name, text] of Object.entries(state.texts))
        if (name !== "profile") state.texts[name] = changed(text, typedDimension(name));
    for (const name of lengths) state[name] = changed(state[name], "length");
    state.section = changed(state.section, "area");
    state.compliance = changed(state.compliance, complianceDimension());
}

function rewriteNumbers() {
    const [from, to] = state.sign === "," ? [".", ","] : [",", "."];
    changeNumbers((text) => (text.split(from).length === 2 && !text.includes(to) ? text.replace(from, to) : text));
}

/** What is typed has the chosen decimal sign too. */
export function setSign(sign) {
    state.sign = sign;
    rewriteNumbers();
    draw();
}

const ofProfile = { x: "length", height: "length" };

/** The pasted tables in other units. factor(dimension), ofConstant(name, exponent) */
function convertTables(factor, ofConstant) {
    const { sign, texts } = state,
        ofInputs = (name) => factor(typedDimension(name));
    if (texts.profile) texts.profile = convertedTable(texts.profile, ["x", "height"], (name) => factor(ofProfile[name]), sign);
    state.loads = convertedTable(state.loads, [], ofInputs, sign);
    state.batch = convertedTable(state.batch, [], ofInputs, sign);
    state.material = convertedMaterial(state.material, ofConstant, sign);
}

/** Other units: all numbers go with them, or the labels alone change. */
export function setUnits(units, converts) {
    const [from, to] = [state.units, converts ? units : state.units].map(wordsOf),
        factor = (dimension = "") => dimension.split("*").reduce((product, part) => product * factorOf(from, to, part), 1),
        ofConstant = (name, exponent) => constantFactorOf(from, to, name, exponent);
    changeNumbers((text, dimension) => {
        const value = typed(text);
        return factor(dimension) === 1 || Number.isNaN(value) ? text : written(value * factor(dimension), 12);
    });
    try {
        convertTables(factor, ofConstant);
    } catch {
        // constants that are no JSON yet stay as they are; the tab says what is wrong with them
    }
    set({ units });
}

/** What is empty is left out. */
const asAddress = (texts) =>
    "#" + new URLSearchParams(Object.entries(texts).filter(([, text]) => text !== undefined && text !== ""));

export const readAddress = (text) => Object.fromEntries(new URLSearchParams(text.replace(/^#/, "")));

const changedSettings = () => Object.fromEntries(Object.entries(settings).filter(([name, usual]) => state[name] !== usual).map(([name]) => [name, state[name]]));

/** What the page shows, beside the case itself. */
export const shownSettings = () => Object.fromEntries(Object.entries(changedSettings()).filter(([name]) => !ofFile.includes(name)));

export const wholeAddress = () => asAddress({ ...state.texts, ...changedSettings() });

/** What is pasted may be too long for a link. */
export const isTooLong = () => wholeAddress().length > LONGEST;
export const address = () => (isTooLong() ? asAddress({ ...state.texts, tab: state.tab }) : wholeAddress());
