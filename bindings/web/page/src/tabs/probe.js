// SPDX-License-Identifier: GPL-3.0-or-later
// The stresses at a place: typed in, or pointed at in the drawing.
import { element } from "../elements.js";
import { readNumber, writeNumber } from "../number.js";
import { inViewBox } from "../plot/live.js";
import { placeAt, probeText } from "../plot/field.js";
import { valuesAt } from "../stresses.js";
import { tableText } from "./table.js";

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
const keys = ["probe_x", "probe_y"];

/** The place is in the state; the plot is the element that holds the drawing. */
export class Probe {
    constructor(state, changed, plot) {
        Object.assign(this, { state, plot, values: element("div") });
        this.fields = ["x", "y"].map((name) =>
            element("input", { type: "text", id: `probe-${name}`, size: 9, autocomplete: "off" }),
        );
        this.fields.forEach((input, i) =>
            input.addEventListener("input", () => {
                state[keys[i]] = input.value;
                this.showValues();
                changed();
            }),
        );
        plot.addEventListener("pointermove", (event) => this.follow(event));
        plot.addEventListener("pointerdown", (event) => this.follow(event));
        plot.addEventListener("pointerleave", changed);
        this.box = element("div", {}, element("h2", {}, "At a place"), this.form(), this.values);
    }

    form() {
        const labelled = this.fields.flatMap((input) => [element("label", { for: input.id }, input.id.at(-1)), input]);
        return element("p", { class: "tools" }, ...labelled, "or point into the drawing");
    }

    follow(event) {
        const svg = this.plot.querySelector("svg");
        if (!svg || !this.model.results) return;
        const at = placeAt(...inViewBox(svg, event), this.grid);
        if (!at) return;
        [this.state.probe_x, this.state.probe_y] = [at.x, at.y].map((value) => writeNumber(value, 5, this.state.sign));
        this.showFields();
        this.showValues();
    }

    showFields() {
        this.fields.forEach((input, i) => {
            if (input.value !== this.state[keys[i]]) input.value = this.state[keys[i]];
        });
    }

    showValues() {
        if (!this.model.results) {
            this.values.textContent = "";
            return;
        }
        const [x, y] = keys.map((key) => readNumber(this.state[key], this.state.sign));
        const stresses = Number.isFinite(x) && y >= 0 ? valuesAt(this.model, { x, y }) : null;
        this.values.innerHTML = stresses
            ? tableText("Stresses at the place", this.rows(stresses))
            : "<p>x must be a number, y a number not below 0; the apex of a sharp wedge has no stresses.</p>";
        this.plot.querySelector(".probe").innerHTML = stresses ? probeText({ x, y }, this.grid) : "";
    }

    rows(stresses) {
        const unitOf = (name) => (name === "angle" ? "\u00b0" : this.model.unit.stress);
        return Object.entries(meanings).map(([name, meaning]) => ({
            name,
            meaning,
            value: this.model.write(stresses[name]),
            unit: unitOf(name),
        }));
    }

    show(model, grid) {
        Object.assign(this, { model, grid });
        this.showFields();
        this.showValues();
    }
}
