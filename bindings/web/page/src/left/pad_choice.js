// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of the pad.
import { element } from "../elements.js";
import { writeNumber } from "../number.js";
import { beginning, pads } from "../pads.js";
import { alternatives } from "../words.js";

/** Which pad it is; a pad without sizes begins with those of the one before. */
export class PadChoice {
    constructor(state, change) {
        this.state = state;
        this.change = change;
        const options = Object.entries(pads).map(([value, { title }]) => element("option", { value }, title));
        this.select = element("select", { id: "pad" }, ...options);
        this.select.addEventListener("change", () => this.choose(this.select.value));
        this.hull = element("input", { id: "hull", type: "checkbox" });
        this.hull.addEventListener("change", () => this.takeHull());
        this.ofHull = element(
            "p",
            { class: "tools" },
            this.hull,
            element("label", { for: "hull" }, "take the convex hull"),
        );
        this.box = element(
            "div",
            { class: "field" },
            element("label", { for: "pad" }, "Shape"),
            this.select,
            this.ofHull,
        );
    }

    choose(pad) {
        const { state, model } = this,
            write = (value) => writeNumber(value, 4, state.sign),
            start = beginning(pad, model.setup?.radius, model.results?.b, write);
        state.pad = pad;
        if ("radius" in start && "a" in state.texts && pad !== "wedge") delete state.texts.a;
        if (pad !== "wedge") state.way.radius = true;
        for (const [name, text] of Object.entries(start)) if (!this.has(name)) state.texts[name] = text;
        this.change();
    }

    /** An input, or its other way. */
    has(name) {
        return [
            name,
            alternatives[name] ?? Object.keys(alternatives).find((other) => alternatives[other] === name),
        ].some((way) => way in this.state.texts && pads[this.state.pad].names.includes(way));
    }

    takeHull() {
        if (this.hull.checked) this.state.texts.hull = "yes";
        else delete this.state.texts.hull;
        this.change();
    }

    show(model) {
        this.model = model;
        this.select.value = this.state.pad;
        this.ofHull.hidden = this.state.pad !== "profile";
        this.hull.checked = "hull" in this.state.texts;
    }
}
