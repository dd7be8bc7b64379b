// SPDX-License-Identifier: GPL-3.0-or-later
// "R for a safety of 2": the input that gives it, and a button that takes it into the form.
import { html } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { options, remembered } from "../parts.js";
import { findInput } from "../answers/solution.js";
import { findable, setter, state, typed, written } from "../state.js";
import { inputs } from "../answers/words.js";
import { put } from "./form.js";

const findFor = remembered(({ texts }, name, safety) => {
    const value = typed(safety);
    return value > 0 ? findInput(texts, state.sign, name, value) : { complaint: "the safety must be above 0" };
});

export function finder(model) {
    const { find: name, safety } = state,
        { complaint, value } = findFor(model, name, safety);
    const use = () => put(name, written(value, 15));
    return html`<fieldset class="find"><legend>Find an input</legend>
        <p class="tools"><select id="find-input" aria-label="What is looked for" @change=${setter("find")}>${options(findable, name)}</select>
            for a safety, in full sliding, of
            <input id="find-safety" type="text" size="5" aria-label="Safety" .value=${live(safety)} @input=${setter("safety")}>:
            <output id="find-answer">${complaint ?? `${model.write(value)} ${model.unit[inputs[name].unit]}`}</output>
            <button type="button" ?hidden=${Boolean(complaint)} @click=${use}>Take it</button></p></fieldset>`;
}
