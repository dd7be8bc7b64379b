// SPDX-License-Identifier: GPL-3.0-or-later
// A slider beside a field. Where the number has a sign or a limit it runs between limits; else by a factor of ten to both sides of a power of ten.
import { html, nothing } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { written } from "../state.js";

const steps = 200;

/** From -1 to 1 and back, about a number. */
const byFactor = { to: (base, share) => base * 10 ** share, from: (base, value) => Math.log10(value / base) };
const ways = {
    ...Object.fromEntries(["P", "theta", "a", "flat", "k"].map((field) => [field, byFactor])),
    f: { to: (_, share) => (share + 1) / 2, from: (_, value) => 2 * value - 1 },
    Q: { to: (limit, share) => limit * share, from: (limit, value) => (limit > 0 ? value / limit : 0) },
};

/** The number in the middle, or the limit: shear runs as far as the friction. */
const baseOf = (field, value, { f = 0, P }) => (field === "Q" ? f * P : 10 ** Math.round(Math.log10(value)));

/** The numbers as they are typed: of the whole contact, where it has a width. */
const asTyped = (inputs, shares) => Object.fromEntries(Object.entries(inputs).map(([name, value]) => [name, value * (shares[name] ?? 1)]));

let dragged = null; // { field, base }: the base stays while it moves
export const isMoving = () => dragged !== null;

/** Nothing where the input has none. name: of the input as it is given now; type(text) takes what is dragged to. */
export function slider(field, name, { inputs: numbers, shares, texts }, type) {
    if (!ways[field]) return nothing;
    const inputs = asTyped(numbers, shares);
    const { to, from } = ways[field],
        base = dragged?.field === field ? dragged.base : baseOf(field, inputs[name], inputs),
        share = from(base, inputs[name] || (field === "Q" || field === "f" ? 0 : NaN));
    const place = Number.isFinite(share) ? Math.round(Math.max(-1, Math.min(1, share)) * steps) : 0,
        ends = [-1, 1].map((end) => written(to(base, end), 4));
    const drag = ({ target }) => {
        dragged ??= { field, base };
        const value = to(base, target.valueAsNumber / steps);
        if (Number.isFinite(value)) type(written(value, 4));
    };
    const letGo = () => {
        dragged = null;
        type(texts[name] ?? ""); // drawn anew, with all its detail
    };
    return html`<div class="slider">
        <input type="range" min=${-steps} max=${steps} step="1" aria-label="${field}, slider"
            aria-valuetext=${texts[name] ?? "empty"} .value=${live(String(place))} @input=${drag} @change=${letGo}>
        <span class="ends" aria-hidden="true">${ends[1] === "" ? "" : ends.join(" \u2026 ")}</span></div>`;
}
