// SPDX-License-Identifier: GPL-3.0-or-later
// The stresses at a place: typed in, or pointed at in the drawing.
import { html } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { inViewBox } from "../plot/live.js";
import { placeAt, probeText } from "../plot/field.js";
import { set, setter, state, typed, written } from "../state.js";
import { valuesAt } from "../answers/stresses.js";
import { table } from "./table.js";

const meanings = {
    sxx: "along the surface, tension positive",
    syy: "across the surface",
    txy: "shear",
    szz: "across the plane of the drawing",
    s1: "larger principal stress in the plane",
    s2: "smaller one",
    angle: "from the surface\u2019s normal to that of s1\u2019s plane",
    tau_max: "largest shear on any plane",
    von_mises: "von Mises\u2019 equivalent stress",
};

const place = () => ({ x: typed(state.probe_x), y: typed(state.probe_y) });

/** null where there are none. */
function stressesOf(model) {
    const { x, y } = place();
    return Number.isFinite(x) && y >= 0 ? valuesAt(model, { x, y }) : null;
}

/** The place that is pointed at in a drawing of this grid. */
export function follow(event, grid) {
    const at = placeAt(...inViewBox(event.currentTarget, event), grid);
    if (!at) return;
    const [probe_x, probe_y] = [at.x, at.y].map((value) => written(value, 5));
    set({ probe_x, probe_y });
}

export const crossOf = (model, grid) => (stressesOf(model) ? probeText(place(), grid) : "");

function values(model) {
    const stresses = stressesOf(model);
    if (!stresses)
        return html`<p>x must be a number, y a number not below 0; the apex of a sharp wedge has no stresses.</p>`;
    const rows = Object.entries(meanings).map(([name, meaning]) => ({
        name,
        meaning,
        value: model.write(stresses[name]),
        unit: name === "angle" ? "\u00b0" : model.unit.stress,
    }));
    return table("Stresses at the place", rows);
}

const entry = (axis, name) => html`<label for="probe-${axis}">${axis}</label>
    <input type="text" id="probe-${axis}" size="9" autocomplete="off" .value=${live(state[name])} @input=${setter(name)}>`;

export const probe = (model) => html`<h2>At a place</h2>
    <p class="tools">${entry("x", "probe_x")} ${entry("y", "probe_y")} or point into the drawing${model.setup?.body === 2 ? "; y is the height in the pad" : ""}</p>
    <div>${model.results ? values(model) : ""}</div>`;
