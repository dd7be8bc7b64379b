// SPDX-License-Identifier: GPL-3.0-or-later
// The inputs of the case: fields with units, complaints and sliders.
import { html, nothing } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { rwedge } from "../answers/library.js";
import { ofShapes, pads } from "../pads.js";
import { options } from "../parts.js";
import { rotations, set, setter, state, strengths, typedDimension, written } from "../state.js";
import { percentOf } from "../answers/solution.js";
import { inputs, waysOf } from "../answers/words.js";
import { padChoice } from "./pad_choice.js";
import { slider } from "./slider.js";

const groups = [
    { title: "Loads", names: ["P", "Q", "M"] },
    { title: "Pad", names: ["theta", "flat", "a", "radius1", "radius2", "profile", "E2", "nu2"] },
    { title: "Between the bodies", names: ["f"] },
    { title: "Half-plane", names: ["E1", "nu1", "k", "sigma"] },
];
const labels = {
    P: "Normal load P",
    Q: "Tangential load Q",
    M: "Moment M",
    sigma: "Bulk tension \u03c3",
    f: "Friction f",
    theta: "Angle of the flank \u03b8",
    theta_deg: "Angle of the flank \u03b8",
    a: "Half-width of rounding a",
    radius: "Radius R",
    radius1: "Radius of the half-plane\u2019s body R\u2081",
    radius2: "Radius of the pad R\u2082",
    tilt: "Tilt of a pad that is held",
    flat: "Half-width of the flat a",
    profile: "Profile: x and height, or x and slope",
    E1: "Young\u2019s modulus E\u2081",
    nu1: "Poisson\u2019s ratio \u03bd\u2081",
    E2: "Young\u2019s modulus E\u2082",
    nu2: "Poisson\u2019s ratio \u03bd\u2082",
    k: "Yield stress in shear k",
    yield_stress: "Yield stress in tension Y",
};
const choices = {
    theta: { theta: "rad", theta_deg: "deg" },
    a: { a: "a", radius: "R" },
    k: { k: "k", yield_stress: "Y" },
    M: { M: "M", tilt: "tilt" },
};
const hints = { E2: "as body 1", nu2: "as body 1", Q: "0", M: "0", sigma: "0", k: "none", yield_stress: "none" };

/** The same input the other way: radians or degrees, a or radius, k or Y, the moment or the tilt that it leads to. */
function converted(from, numbers, results, shares) {
    const value = numbers[from],
        angle = numbers.theta ?? (numbers.theta_deg * Math.PI) / 180;
    return {
        theta: (value * 180) / Math.PI,
        theta_deg: (value * Math.PI) / 180,
        a: rwedge.radius(angle, value),
        radius: rwedge.rounding(angle, value),
        k: value * Math.sqrt(3),
        yield_stress: value / Math.sqrt(3),
        M: results?.tilt ?? NaN,
        tilt: (results?.moment ?? NaN) * (shares.M ?? 1),
    }[from];
}

/** Those that the pad has. */
const openWays = (field) => waysOf(field).filter((way) => !ofShapes.has(way) || pads[state.pad].names.includes(way));

/** Of the way that is chosen. */
function nameOf(field) {
    const open = openWays(field);
    return open.find((way) => state.way[way]) ?? (open.includes(field) ? field : (open[0] ?? field));
}

function type(field, text) {
    const texts = { ...state.texts };
    for (const way of waysOf(field)) delete texts[way];
    if (text.trim() !== "") texts[nameOf(field)] = text;
    set({ texts });
}

/** The text of one of the ways, which is chosen. */
export function put(way, text) {
    for (const each of waysOf(way)) state.way[each] = each === way;
    type(waysOf(way)[0], text);
}

/** To 15 digits; what is no number stays as it is. */
function choose(way, from, { inputs: numbers, results, shares }) {
    const other = from in numbers ? converted(from, numbers, results, shares) : NaN;
    put(way, Number.isFinite(other) ? written(other, 15) : (state.texts[from] ?? ""));
}

function chooser(field, name, model) {
    if (!choices[field]) return nothing;
    return html`<select aria-label="${labels[field]}, given as" ?hidden=${openWays(field).length < 2}
        @change=${({ target }) => choose(target.value, name, model)}>${options(choices[field], name)}</select>`;
}

function entry(field, text, isWrong, hint) {
    const id = `in-${field}`,
        input = ({ target }) => type(field, target.value);
    return field === "profile"
        ? html`<textarea id=${id} rows="6" autocomplete="off" spellcheck="false" aria-describedby="${id}-note"
              aria-invalid=${isWrong} .value=${live(text)} @input=${input}></textarea>`
        : html`<input id=${id} type="text" autocomplete="off" spellcheck="false" size="10" aria-describedby="${id}-note"
              aria-invalid=${isWrong} placeholder=${hint} .value=${live(text)} @input=${input}>`;
}

const unitOf = (name, unit) => unit[typedDimension(name)];

/** E2 and nu2 are given both or not at all. */
const isHalf = (name, { E2, nu2 }) => (name === "nu2" ? Number.isFinite(E2) : name === "E2" && nu2 !== undefined);

/** What is to be known of a profile, and how well it is resolved. */
function remarkOf({ remark, resolution, write, unit }) {
    if (!resolution) return remark;
    const { left, right, arcs, noise, change } = resolution;
    return [
        remark,
        left !== undefined && `${left} and ${right} measured places lie between the highest pressure and the edges`,
        arcs > 0 && `the noise is ${write(noise)} ${unit.length} by a fit of ${arcs} arc${arcs > 1 ? "s" : ""}`,
        change !== null && `without every second place p0 changes by ${percentOf(change)}`,
    ]
        .filter(Boolean)
        .join("; ");
}

function fieldPart(field, model) {
    const name = nameOf(field),
        unit = field === "theta" || name === "tilt" ? (name === "tilt" ? "rad" : "") : unitOf(name, model.unit);
    const wrong = model.faults.filter((fault) => waysOf(field).includes(fault.input)).map((fault) => fault.text);
    const hint = isHalf(name, model.inputs) ? "needed too" : (hints[name] ?? "");
    return html`<div class="field" ?hidden=${openWays(field).length === 0}>
        <label for="in-${field}" title=${inputs[name].meaning}>${labels[name]}</label>
        <div class="row">${entry(field, state.texts[name] ?? "", wrong.length > 0, hint)}${chooser(field, name, model)}
            <span class="unit">${unit}</span></div>
        ${slider(field, name, model, (text) => type(field, text))}
        <p id="in-${field}-note" class="note ${wrong.length > 0 ? "bad" : ""}" aria-live="polite"
            >${wrong.join("; ") || (name === "profile" ? remarkOf(model) : "")}</p></div>`;
}

/** Of a total force; empty where forces are per unit length. */
const width = (model) => html`<div class="field"><label for="in-width">Width of the contact</label>
    <div class="row"><input id="in-width" type="text" autocomplete="off" spellcheck="false" size="10" placeholder="forces per length"
        .value=${live(state.width)} @input=${setter("width")}><span class="unit">${model.unit.length}</span></div></div>`;

/** Of a tension that is given as a force: there where forces are whole ones, or the tension is refused as it stands. */
const needsSection = ({ faults }) => state.width || state.section || faults.some(({ input }) => input === "sigma");

const section = (model) => html`<div class="field" ?hidden=${!needsSection(model)}><label for="in-section">Section under the tension</label>
    <div class="row"><input id="in-section" type="text" autocomplete="off" spellcheck="false" size="10" placeholder="\u03c3 is a stress"
        .value=${live(state.section)} @input=${setter("section")}><span class="unit">${model.unit.area}</span></div></div>`;

const body = () => html`<div class="field"><label for="strength-of">k, stresses and yield are</label>
    <div class="row"><select id="strength-of" @change=${setter("body")}>${options(strengths, state.body)}</select></div></div>`;

const rotation = () => html`<div class="field" ?hidden=${!state.texts.E2}>
    <label for="rotation" title="Friction of unlike bodies changes the pressure: a pad that is held and one that is free swing to opposite sides"
        >Rotation of the pad</label>
    <div class="row"><select id="rotation" @change=${setter("rotation")}>${options(rotations, state.rotation)}</select></div></div>`;

const plane = () => html`<p class="tools"><input id="plane" type="checkbox" .checked=${live(state.plane === "stress")}
    @input=${({ target }) => set({ plane: target.checked ? "stress" : "" })}><label for="plane">plane stress</label></p>`;

const more = {
    Loads: { below: width },
    Pad: { above: padChoice },
    "Between the bodies": { below: rotation },
    "Half-plane": { below: (model) => [section(model), body(), plane()] },
};

const group = ({ title, names }, model) => html`<fieldset><legend>${title}</legend>
    ${more[title]?.above?.(model)} ${names.map((name) => fieldPart(name, model))} ${more[title]?.below?.(model)}</fieldset>`;

export const form = (model) => html`<div class="groups">${groups.map((each) => group(each, model))}</div>`;
