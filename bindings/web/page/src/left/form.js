// SPDX-License-Identifier: GPL-3.0-or-later
// The inputs of the case: fields with units, complaints and sliders.
import { element } from "../elements.js";
import { rwedge } from "../library.js";
import { writeNumber } from "../number.js";
import { ofShapes, pads } from "../pads.js";
import { alternatives, inputs } from "../words.js";
import { PadChoice } from "./pad_choice.js";
import { slider } from "./slider.js";

const groups = [
    { title: "Loads", names: ["P", "Q", "M"] },
    { title: "Pad", names: ["theta", "flat", "a", "profile", "E2", "nu2"] },
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
    flat: "Half-width of the flat a",
    profile: "Profile: x and height, or x and slope",
    E1: "Young\u2019s modulus E\u2081",
    nu1: "Poisson\u2019s ratio \u03bd\u2081",
    E2: "Young\u2019s modulus E\u2082",
    nu2: "Poisson\u2019s ratio \u03bd\u2082",
    k: "Yield stress in shear k",
    yield_stress: "Yield stress in tension Y",
};
const choiceTexts = { theta: "rad", theta_deg: "deg", a: "a", radius: "R", k: "k", yield_stress: "Y" };
const hints = { E2: "as body 1", nu2: "as body 1", Q: "0", M: "0", sigma: "0", k: "none", yield_stress: "none" };

/** The same input the other way: radians or degrees, a or radius, k or Y. */
function converted(from, numbers) {
    const value = numbers[from],
        angle = numbers.theta ?? (numbers.theta_deg * Math.PI) / 180;
    return {
        theta: (value * 180) / Math.PI,
        theta_deg: (value * Math.PI) / 180,
        a: rwedge.radius(angle, value),
        radius: rwedge.rounding(angle, value),
        k: value * Math.sqrt(3),
        yield_stress: value / Math.sqrt(3),
    }[from];
}

/** One field. It reads and writes texts; change() is called after each change. */
class Field {
    constructor(name, state, change) {
        this.ways = alternatives[name] ? [name, alternatives[name]] : [name];
        this.state = state;
        this.change = change;
        const id = `in-${name}`;
        this.input = element(name === "profile" ? "textarea" : "input", {
            id,
            type: "text",
            rows: 6,
            inputmode: "text",
            autocomplete: "off",
            spellcheck: "false",
            size: 10,
            "aria-describedby": `${id}-note`,
        });
        this.label = element("label", { for: id });
        this.unit = element("span", { class: "unit" });
        this.note = element("p", { id: `${id}-note`, class: "note", "aria-live": "polite" });
        this.input.addEventListener("input", () => this.type(this.input.value));
        this.slider = slider(name, (text) => this.type(text));
        const row = element(
            "div",
            { class: "row" },
            this.input,
            this.ways.length > 1 ? this.chooser(name) : "",
            this.unit,
        );
        this.box = element("div", { class: "field" }, this.label, row, this.slider?.box ?? "", this.note);
    }

    /** The ways that the pad has. */
    get open() {
        const { names } = pads[this.state.pad];
        return this.ways.filter((way) => !ofShapes.has(way) || names.includes(way));
    }

    get name() {
        const open = this.open;
        return open.find((way) => this.state.way[way]) ?? open[0] ?? this.ways[0];
    }

    type(text) {
        for (const way of this.ways) delete this.state.texts[way];
        if (text.trim() !== "") this.state.texts[this.name] = text;
        this.change();
    }

    /** The text of one of its ways, which is chosen. */
    put(way, text) {
        for (const each of this.ways) this.state.way[each] = each === way;
        this.type(text);
    }

    chooser(name) {
        this.choice = element(
            "select",
            { "aria-label": `${labels[name]}, given as` },
            ...this.ways.map((way) => element("option", { value: way }, choiceTexts[way])),
        );
        this.choice.addEventListener("change", () => this.choose(this.choice.value));
        return this.choice;
    }

    /** To 15 digits; what is no number stays as it is. */
    choose(way) {
        const from = this.name,
            other = from in this.numbers ? converted(from, this.numbers) : NaN,
            text = Number.isFinite(other) ? writeNumber(other, 15, this.state.sign) : (this.state.texts[from] ?? "");
        this.put(way, text);
    }

    show(model) {
        this.numbers = model.inputs;
        this.box.hidden = this.open.length === 0;
        if (this.choice) this.choice.hidden = this.open.length < 2;
        const text = this.state.texts[this.name] ?? "";
        if (this.input.value.trim() !== text.trim()) this.input.value = text;
        this.label.textContent = labels[this.name];
        this.label.title = inputs[this.name].meaning;
        const isHalf =
            this.name === "nu2" ? Number.isFinite(model.inputs.E2) : this.name === "E2" && "nu2" in model.inputs;
        this.input.placeholder = isHalf ? "needed too" : (hints[this.name] ?? "");
        if (this.choice) this.choice.value = this.name;
        this.unit.textContent =
            this.choice && inputs[this.name].unit.match(/rad|deg/) ? "" : model.unit[inputs[this.name].unit];
        const wrong = model.faults.filter((fault) => this.ways.includes(fault.input));
        this.input.setAttribute("aria-invalid", wrong.length > 0);
        this.note.className = wrong.length > 0 ? "note bad" : "note";
        this.note.textContent =
            wrong.map((fault) => fault.text).join("; ") || (this.name === "profile" ? model.remark : "");
        this.slider?.show(this.name, model);
    }
}

/** The form, take(name, text) for one of its fields, and show(model). */
export function makeForm(state, change) {
    const box = element("div", { class: "groups" });
    const fields = [];
    const choice = new PadChoice(state, change);
    for (const { title, names } of groups) {
        const made = names.map((name) => new Field(name, state, change));
        fields.push(...made);
        const boxes = [...(title === "Pad" ? [choice.box] : []), ...made.map((field) => field.box)];
        box.append(element("fieldset", {}, element("legend", {}, title), ...boxes));
    }
    const take = (name, text) => fields.find((field) => field.ways.includes(name)).put(name, text);
    return { box, take, show: (model) => [choice, ...fields].forEach((part) => part.show(model)) };
}
