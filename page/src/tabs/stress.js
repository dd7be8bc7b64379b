// SPDX-License-Identifier: GPL-3.0-or-later
// The tab Stress: contours below the surface, the values at a place, and where the material yields first under these loads.
import { element } from "../elements.js";
import { rwedge, status } from "../library.js";
import { measures } from "../measures.js";
import { readNumber, writeNumber } from "../number.js";
import { fieldText, placeAt, probeText } from "../plot/field.js";
import { saveButtons } from "../plot/save.js";
import { withUnit } from "../model.js";
import { noResults, tableText } from "./table.js";

const NX = 200, NY = 150;

/** The grid, square cells: as wide as 3.2 half-widths of the contact. */
function gridOf({ left, right }) {
    const half = (right - left) / 2, middle = (left + right) / 2, depth = (3.2 * half * (NY - 1)) / (NX - 1);
    const x = new Float64Array(NX * NY), y = new Float64Array(NX * NY);
    const [x0, x1] = [middle - 1.6 * half, middle + 1.6 * half];
    for (let j = 0, n = 0; j < NY; j++)
        for (let i = 0; i < NX; i++, n++) {
            x[n] = x0 + ((x1 - x0) * i) / (NX - 1);
            y[n] = (depth * j) / (NY - 1);
        }
    return { x, y, x0, x1, depth };
}

/** NX is even: no point of the grid is the apex of a sharp wedge that stands upright. A tilted one may meet it by chance. */
function fieldOf({ contact, what }, grid, measure) {
    const s = contact.stresses(grid.x, grid.y), values = new Float64Array(NX * NY), { of } = measures[measure];
    for (let i = 0; i < values.length; i++) values[i] = of(s.sxx[i], s.syy[i], s.txy[i], what.nu1);
    return { ...s, values };
}

function valuesAt({ contact, what }, place) {
    const s = status.orNull(() => contact.stresses(place.x, place.y));
    if (!s) return null;
    const { s1, s2, angle } = rwedge.principal_stresses(s.sxx, s.syy, s.txy);
    return {
        ...s, szz: rwedge.out_of_plane_stress(s.sxx, s.syy, what.nu1), s1, s2, angle: (angle * 180) / Math.PI,
        tau_max: rwedge.largest_shear(s.sxx, s.syy, s.txy, what.nu1), von_mises: rwedge.von_mises(s.sxx, s.syy, s.txy, what.nu1),
    };
}

const meanings = {
    sxx: "along the surface, tension positive", syy: "across the surface", txy: "shear", szz: "across the plane of the drawing",
    s1: "larger principal stress in the plane", s2: "smaller one", angle: "from the surface\u2019s normal to that of s1\u2019s plane", tau_max: "largest shear on any plane", von_mises: "von Mises\u2019 equivalent stress",
};

export function makeStress(state, changed) {
    const plot = element("div", { class: "stage" }), values = element("div", { "aria-live": "off" }), yields = element("p", {});
    const choice = element("select", { id: "measure" }, ...Object.entries(measures).map(([key, { name }]) => element("option", { value: key }, name)));
    const fields = ["x", "y"].map((name) => element("input", { type: "text", id: `probe-${name}`, size: 9, autocomplete: "off" }));
    let model, grid, field;

    const place = () => ({ x: readNumber(state.probe_x), y: readNumber(state.probe_y) });
    const showValues = () => {
        const at = place(), found = at.y >= 0 && Number.isFinite(at.x) ? valuesAt(model, at) : null;
        values.innerHTML = found
            ? tableText("Stresses at the place", Object.entries(meanings).map(([name, meaning]) => ({ name, meaning, value: model.write(found[name]), unit: name === "angle" ? "\u00b0" : model.unit.stress })))
            : "<p>x must be a number, y a number not below 0; the apex of a sharp wedge has no stresses.</p>";
        const probe = plot.querySelector(".probe");
        if (probe) probe.innerHTML = found ? probeText(at, grid) : "";
    };
    const probeAt = (at) => {
        [state.probe_x, state.probe_y] = [writeNumber(at.x, 5), writeNumber(at.y, 5)];
        fields.forEach((input, i) => (input.value = [state.probe_x, state.probe_y][i]));
        showValues();
    };
    const underPointer = (event) => {
        const svg = plot.querySelector("svg"), rect = svg?.getBoundingClientRect();
        if (!rect || !model.results) return null;
        const [, , width, height] = svg.getAttribute("viewBox").split(" ").map(Number);
        return placeAt(((event.clientX - rect.left) / rect.width) * width, ((event.clientY - rect.top) / rect.height) * height, grid);
    };
    const follow = (event) => {
        const at = underPointer(event);
        if (at) probeAt(at);
    };
    plot.addEventListener("pointermove", follow);
    plot.addEventListener("pointerdown", follow);
    plot.addEventListener("pointerleave", changed);
    fields.forEach((input, i) => input.addEventListener("input", () => {
        state[["probe_x", "probe_y"][i]] = input.value;
        if (model.results) showValues();
        changed();
    }));
    choice.addEventListener("change", () => {
        state.measure = choice.value;
        show(model);
        changed();
    });

    const draw = () => {
        const { hardest } = model, { stick_left: from, stick_right: to, left, right } = model.results;
        const text = hardest && `Largest von Mises stress: ${model.write(hardest.von_mises)} ${model.unit.stress} at x = ${model.write(hardest.x)}, y = ${model.write(hardest.y)} ${model.unit.length}` +
            (Number.isNaN(model.what.k) ? "." : `; it yields there first, at ${model.write(hardest.factor)} times these stresses.`);
        yields.textContent = text ?? "";
        return fieldText({
            ...grid, title: `${measures[state.measure].name} below the surface`, values: field.values, nx: NX, ny: NY,
            xLabel: withUnit("x", model.unit.length), yLabel: withUnit("depth y", model.unit.length), unit: model.unit.stress,
            points: hardest ? [{ x: hardest.x, y: hardest.y, name: text }] : [],
            surface: [{ from: left, to: right, style: "curve one", name: "contact" }, ...(to > from && from !== null ? [{ from, to, style: "curve three", name: "sticks" }] : [])],
        });
    };
    const show = (present) => {
        model = present;
        panel.classList.toggle("empty", !model.results);
        choice.value = state.measure;
        fields.forEach((input, i) => (input.value = [state.probe_x, state.probe_y][i]));
        if (!model.results) {
            plot.innerHTML = noResults;
            values.textContent = yields.textContent = "";
            return;
        }
        grid = gridOf(model.results);
        field = fieldOf(model, grid, state.measure);
        plot.innerHTML = draw();
        showValues();
    };
    const table = () => ({
        names: ["x", "y", "sxx", "syy", "txy", state.measure],
        rows: Array.from(field.values, (v, i) => [grid.x[i], grid.y[i], field.sxx[i], field.syy[i], field.txy[i], v]),
    });
    const panel = element("div", {},
        element("p", { class: "tools" }, element("label", { for: "measure" }, "Contours of"), choice), plot,
        saveButtons("stress", () => plot.querySelector("svg"), table), yields,
        element("h2", {}, "At a place"),
        element("p", { class: "tools" }, element("label", { for: "probe-x" }, "x"), fields[0], element("label", { for: "probe-y" }, "y"), fields[1], "or point into the drawing"), values);
    return { panel, show };
}
