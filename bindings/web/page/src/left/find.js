// SPDX-License-Identifier: GPL-3.0-or-later
// "R for a safety of 2": the input that gives it, and a button that takes it into the form.
import { html } from "lit-html";
import { readNumber, writeNumber } from "../number.js";
import { options, remembered } from "../parts.js";
import { findInput } from "../answers/solution.js";
import { redraw } from "../state.js";
import { inputs } from "../answers/words.js";
import { put } from "./form.js";

const names = { radius: "Radius R", a: "Half-width of rounding a", P: "Load P", f: "Friction f" };
const wanted = { name: "radius", safety: "2" };

const find = remembered(({ texts, sign }, name, safety) => {
    const value = readNumber(safety, sign);
    return value > 0 ? findInput(texts, sign, name, value) : { complaint: "the safety must be above 0" };
});

const taker =
    (part) =>
    ({ target }) => {
        wanted[part] = target.value;
        redraw();
    };

export function finder(model) {
    const { name, safety } = wanted,
        { complaint, value } = find(model, name, safety);
    const use = () => put(name, writeNumber(value, 15, model.sign));
    return html`<fieldset class="find"><legend>Find an input</legend>
        <p class="tools"><select id="find-input" aria-label="What is looked for" @change=${taker("name")}>${options(names, name)}</select>
            for a safety, in full sliding, of
            <input id="find-safety" type="text" value="2" size="5" aria-label="Safety" @input=${taker("safety")}>:
            <output id="find-answer">${complaint ?? `${model.write(value)} ${model.unit[inputs[name].unit]}`}</output>
            <button type="button" ?hidden=${Boolean(complaint)} @click=${use}>Take it</button></p></fieldset>`;
}
