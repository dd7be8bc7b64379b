// SPDX-License-Identifier: GPL-3.0-or-later
// A slider beside a field. Where the number has a sign or a limit it runs between limits; else by a factor of ten to both sides.
import { element } from "../elements.js";
import { isGiven, readInput } from "../case/inputs.js";
import { writeNumber } from "../number.js";

const steps = 200;
const valueOf = (texts, name) => (isGiven(texts, name) ? (readInput(name, texts[name]).value ?? NaN) : NaN);

/** From -1 to 1 and back, about the number from which the drag began. */
const byFactor = { to: (base, share) => base * 10 ** share, from: (base, value) => Math.log10(value / base) };
const ways = {
    P: byFactor,
    theta: byFactor,
    a: byFactor,
    k: byFactor,
    f: { to: (_, share) => (share + 1) / 2, from: (_, value) => 2 * value - 1 },
    Q: { to: (limit, share) => limit * share, from: (limit, value) => (limit > 0 ? value / limit : 0) },
};

/** Nothing where the input has no slider. state() has the texts; type(text) takes what is dragged to. */
export function slider(field, state, type) {
    const way = ways[field];
    if (!way) return null;
    const input = element("input", {
        type: "range",
        min: -steps,
        max: steps,
        step: 1,
        "aria-label": `${field}, slider`,
    });
    let name = field,
        base = NaN;
    const begin = () => {
        const { texts } = state();
        base = field === "Q" ? (valueOf(texts, "f") || 0) * valueOf(texts, "P") : valueOf(texts, name);
    };
    const isUsed = () => document.activeElement === input && input.dataset.moving === "yes";
    input.addEventListener("input", () => {
        if (input.dataset.moving !== "yes") begin();
        input.dataset.moving = "yes";
        const value = way.to(base, input.valueAsNumber / steps);
        if (Number.isFinite(value)) type(writeNumber(value, 4));
    });
    input.addEventListener("change", () => {
        input.dataset.moving = "no";
        show(name);
    });
    const show = (present) => {
        name = present;
        if (isUsed()) return;
        begin();
        const share = way.from(base, valueOf(state().texts, name) || (field === "Q" || field === "f" ? 0 : NaN));
        input.value = Number.isFinite(share) ? Math.round(Math.max(-1, Math.min(1, share)) * steps) : 0;
        input.setAttribute("aria-valuetext", state().texts[name] ?? "empty");
    };
    return { input, show };
}
