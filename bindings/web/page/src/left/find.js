// SPDX-License-Identifier: GPL-3.0-or-later
// "R for a safety of 2": the input that gives it, and a button that takes it into the form.
import { html } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { options, remembered } from "../parts.js";
import { findInput } from "../answers/solution.js";
import { factors, findable, setter, state, typed, written } from "../state.js";
import { inputs } from "../answers/words.js";
import { put } from "./form.js";
import { isMoving } from "./slider.js";

const findFor = remembered(({ texts }, name, safety, on) => {
    const value = typed(safety);
    return value > 0 ? findInput(texts, state.sign, name, value, on) : { complaint: "the factor must be above 0" };
});

/** A factor on the stress takes many trials: not while a slider moves. */
const stale = { complaint: "\u2026" };
const answerFor = (model, name, safety, on) => (on !== "P" && isMoving() ? stale : findFor(model, name, safety, on));

/** Two cylinders have two radii: none of them is looked for. */
const offered = () =>
    state.pad === "cylinders" ? Object.fromEntries(Object.entries(findable).filter(([name]) => name !== "radius" && name !== "a")) : findable;

/** P of the whole contact, where it has a width. */
const asTyped = ({ shares }, name, value) => value * (shares[name] ?? 1);

export function finder(model) {
    const { safety, factor } = state,
        choices = offered(),
        name = state.find in choices ? state.find : "P",
        { complaint, value } = answerFor(model, name, safety, factor);
    const use = () => put(name, written(asTyped(model, name, value), 15));
    return html`<fieldset class="find"><legend>Find an input</legend>
        <p class="tools"><select id="find-input" aria-label="What is looked for" @change=${setter("find")}>${options(choices, name)}</select>
            for a factor <select id="find-factor" aria-label="On what" @change=${setter("factor")}>${options(factors, factor)}</select> of
            <input id="find-safety" type="text" size="5" aria-label="Factor" .value=${live(safety)} @input=${setter("safety")}>:
            <output id="find-answer">${complaint ?? `${model.write(value)} ${model.unit[inputs[name].unit]}`}</output>
            <button type="button" ?hidden=${Boolean(complaint)} @click=${use}>Take it</button></p></fieldset>`;
}
