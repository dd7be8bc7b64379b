// SPDX-License-Identifier: GPL-3.0-or-later
// The tab Stress: contours below the surface, the values at a place, and where the material yields first under these loads.
import { html } from "lit-html";
import { narrow } from "../plot/axes.js";
import { fieldText, viewBox } from "../plot/field.js";
import { noResults } from "../plot/live.js";
import { saveButtons } from "../plot/save.js";
import { options, remembered } from "../parts.js";
import { setter, state } from "../state.js";
import { fieldOf, gridOf, measures } from "../answers/stresses.js";
import { withUnit } from "../model.js";
import { isMoving } from "../left/slider.js";
import { crossOf, follow, probe } from "./probe.js";

/** Where the von Mises stress is largest, in words; nothing where it is infinite. */
function hardestText({ hardest, setup, unit, write }) {
    if (!hardest) return "";
    const place = `x = ${write(hardest.x)}, y = ${write(hardest.y)} ${unit.length}`;
    const text = `Largest von Mises stress: ${write(hardest.von_mises)} ${unit.stress} at ${place}`;
    return setup.k === null
        ? `${text}.`
        : `${text}; it yields there first, at ${write(hardest.factor)} times these stresses.`;
}

const isOfPad = ({ setup }) => setup?.body === 2;

/** Above the frame: the contact, and the zones that stick. */
function surfaceOf({ results: { left, right }, setup, zones }) {
    const sticks = setup.f === 0 ? [] : zones.filter(({ slip }) => slip === 0);
    return [
        { from: left, to: right, style: "curve one", name: "contact" },
        ...sticks.map(({ from, to }) => ({ from, to, style: "curve three", name: "sticks" })),
    ];
}

function plotOf(model, { grid, field }) {
    const { hardest, unit } = model;
    return fieldText(
        { ...grid, values: field.values },
        {
            xLabel: withUnit("x", unit.length),
            yLabel: withUnit(isOfPad(model) ? "height y in the pad, body 2" : "depth y", unit.length),
            unit: unit.stress,
            points: hardest ? [{ x: hardest.x, y: Math.abs(hardest.y), name: hardestText(model) }] : [],
            surface: surfaceOf(model),
        },
    );
}

function columnsOf({ unit }, { grid: { x, y }, field }, measure) {
    const stresses = ["sxx", "syy", "txy"].map((name) => ({ name, numbers: field[name] }));
    const all = [...stresses, { name: measure, numbers: field.values }].map((each) => ({ ...each, unit: unit.stress }));
    return [{ name: "x", unit: unit.length, numbers: x }, { name: "y", unit: unit.length, numbers: y }, ...all];
}

const seenOf = remembered((model, measure, isFine) => {
    const grid = gridOf(model.results, !isFine),
        field = fieldOf(model, grid, measure);
    return { grid, field };
});
const textOf = remembered(plotOf);

const titleOf = (model, measure) => `${measures[measure].name} ${isOfPad(model) ? "in the pad, body 2" : "below the surface"}`;

/** As a picture of a report: of what is chosen. */
export const stressText = (model) =>
    `<svg class="plot field" viewBox="${viewBox()}" role="img" aria-label="${titleOf(model, state.measure)}">${textOf(model, seenOf(model, state.measure, true), narrow.matches)}</svg>`;

export function stress(model) {
    const { measure } = state,
        seen = model.results && seenOf(model, measure, !isMoving()),
        title = titleOf(model, measure);
    const point = (event) => follow(event, seen.grid);
    const plot =
        seen &&
        html`<svg class="plot field" viewBox=${viewBox()} role="img" aria-label=${title} @pointermove=${point} @pointerdown=${point}
            ><title .textContent=${title}></title><g .innerHTML=${textOf(model, seen, narrow.matches)}></g>
            <g class="probe" .innerHTML=${crossOf(model, seen.grid)}></g></svg>`;
    return html`<p class="tools"><label for="measure">Contours of</label>
            <select id="measure" @change=${setter("measure")}>${options(measures, measure)}</select></p>
        <div id="plot-stress">${plot ?? html`<p>${noResults}</p>`}</div>
        ${saveButtons("stress", () => columnsOf(model, seen, measure), Boolean(seen))}
        <p>${seen && hardestText(model)}</p>
        ${probe(model)}`;
}
