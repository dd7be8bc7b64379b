// SPDX-License-Identifier: GPL-3.0-or-later
// A slider beside a field. Where the number has a sign or a limit it runs between limits; else by a factor of ten to both sides of a power of ten.
import { element } from "../elements.js";
import { writeNumber } from "../number.js";

const steps = 200;

/** From -1 to 1 and back, about a number. */
const byFactor = { to: (base, share) => base * 10 ** share, from: (base, value) => Math.log10(value / base) };
const ways = {
    P: byFactor,
    theta: byFactor,
    a: byFactor,
    flat: byFactor,
    k: byFactor,
    f: { to: (_, share) => (share + 1) / 2, from: (_, value) => 2 * value - 1 },
    Q: { to: (limit, share) => limit * share, from: (limit, value) => (limit > 0 ? value / limit : 0) },
};

class Slider {
    /** name: of the input as it is given now; base: the number in the middle, or the limit. */
    constructor(field, type) {
        Object.assign(this, { field, type, name: field, base: NaN });
        const label = `${field}, slider`;
        this.input = element("input", { type: "range", min: -steps, max: steps, step: 1, "aria-label": label });
        this.ends = element("span", { class: "ends", "aria-hidden": "true" });
        this.box = element("div", { class: "slider" }, this.input, this.ends);
        this.input.addEventListener("input", () => this.drag());
        this.input.addEventListener("change", () => this.letGo());
    }

    begin() {
        const { inputs } = this.model;
        const isShear = this.field === "Q"; // which runs as far as the friction
        const value = inputs[this.name] ?? NaN;
        if (isShear) this.base = (inputs.f ?? 0) * inputs.P;
        else this.base = 10 ** Math.round(Math.log10(value));
    }

    drag() {
        if (this.input.dataset.moving !== "yes") this.begin();
        this.input.dataset.moving = "yes";
        const value = ways[this.field].to(this.base, this.input.valueAsNumber / steps);
        if (Number.isFinite(value)) this.type(writeNumber(value, 4, this.model.sign));
    }

    letGo() {
        this.input.dataset.moving = "no";
        this.type(this.model.texts[this.name] ?? ""); // drawn anew, with all its detail
    }

    show(name, model) {
        Object.assign(this, { name, model });
        if (document.activeElement === this.input && this.input.dataset.moving === "yes") return;
        this.begin();
        const ifEmpty = this.field === "Q" || this.field === "f" ? 0 : NaN;
        const share = ways[this.field].from(this.base, model.inputs[name] || ifEmpty);
        this.input.value = Number.isFinite(share) ? Math.round(Math.max(-1, Math.min(1, share)) * steps) : 0;
        const ends = [-1, 1].map((end) => writeNumber(ways[this.field].to(this.base, end), 4, model.sign));
        this.ends.textContent = ends[1] === "" ? "" : ends.join(" \u2026 ");
        this.input.setAttribute("aria-valuetext", model.texts[name] ?? "empty");
    }
}

/** Whether one of them is dragged. */
export const isMoving = () => document.querySelector('[data-moving="yes"]') !== null;

/** Nothing where the input has no slider. type(text) takes what is dragged to. */
export const slider = (field, type) => (ways[field] ? new Slider(field, type) : null);
