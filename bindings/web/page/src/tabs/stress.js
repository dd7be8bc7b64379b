// SPDX-License-Identifier: GPL-3.0-or-later
// The tab Stress: contours below the surface, the values at a place, and where the material yields first under these loads.
import { element } from "../elements.js";
import { fieldText } from "../plot/field.js";
import { savedPlot } from "../plot/save.js";
import { fieldOf, gridOf, measures } from "../stresses.js";
import { withUnit } from "../model.js";
import { isMoving } from "../left/slider.js";
import { Probe } from "./probe.js";
import { noResults } from "./table.js";

/** Where the von Mises stress is largest, in words; nothing where it is infinite. */
function hardestText({ hardest, setup, unit, write }) {
    if (!hardest) return "";
    const place = `x = ${write(hardest.x)}, y = ${write(hardest.y)} ${unit.length}`;
    const text = `Largest von Mises stress: ${write(hardest.von_mises)} ${unit.stress} at ${place}`;
    return Number.isNaN(setup.k)
        ? `${text}.`
        : `${text}; it yields there first, at ${write(hardest.factor)} times these stresses.`;
}

/** Above the frame: the contact, and the zone that sticks. */
function surfaceOf({ left, right, stick_left: from, stick_right: to }) {
    const contact = { from: left, to: right, style: "curve one", name: "contact" };
    return from !== null && to > from ? [contact, { from, to, style: "curve three", name: "sticks" }] : [contact];
}

function plotOf(model, grid, field, measure) {
    const { hardest, unit } = model;
    const values = { ...grid, values: field.values };
    return fieldText(values, {
        title: `${measures[measure].name} below the surface`,
        xLabel: withUnit("x", unit.length),
        yLabel: withUnit("depth y", unit.length),
        unit: unit.stress,
        points: hardest ? [{ x: hardest.x, y: hardest.y, name: hardestText(model) }] : [],
        surface: surfaceOf(model.results),
    });
}

function tableOf(unit, grid, field, measure) {
    const columns = [grid.x, grid.y, field.sxx, field.syy, field.txy, field.values];
    return {
        names: ["x", "y", "sxx", "syy", "txy", measure],
        units: columns.map((_, i) => (i < 2 ? unit.length : unit.stress)),
        rows: Array.from(grid.x, (_, i) => columns.map((column) => column[i])),
    };
}

function chooser() {
    const options = Object.entries(measures).map(([key, { name }]) => element("option", { value: key }, name));
    return element("select", { id: "measure" }, ...options);
}

export function makeStress(state, changed) {
    let model, grid, field;
    const plot = savedPlot("stress", () => tableOf(model.unit, grid, field, state.measure));
    const yields = element("p");
    const choice = chooser();
    const probe = new Probe(state, changed, plot.plot);
    const show = (present) => {
        model = present;
        choice.value = state.measure;
        yields.textContent = model.results ? hardestText(model) : "";
        if (model.results) {
            grid = gridOf(model.results, isMoving());
            field = fieldOf(model, grid, state.measure);
        }
        plot.draw(model.results ? plotOf(model, grid, field, state.measure) : noResults);
        probe.show(model, grid);
    };
    choice.addEventListener("change", () => {
        state.measure = choice.value;
        show(model);
        changed();
    });
    const choose = element("p", { class: "tools" }, element("label", { for: "measure" }, "Contours of"), choice);
    return { panel: element("div", {}, choose, ...plot.parts, yields, probe.box), show };
}
