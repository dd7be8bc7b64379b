// SPDX-License-Identifier: GPL-3.0-or-later
// Small parts of the page, and what the browser does with texts: downloads, the clipboard.
import { html } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { state } from "./state.js";

/** The options of a choice: names, or objects that have one, by value. */
export const options = (choices, chosen) =>
    Object.entries(choices).map(
        ([value, { name = choices[value] }]) =>
            html`<option value=${value} .selected=${live(value === chosen)}>${name}</option>`,
    );

export const escaped = (text) =>
    String(text).replace(/[&<>"]/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c]);

/** f, which computes anew where an argument is another than at the call before. */
export function remembered(f) {
    let before = [NaN],
        value;
    return (...values) => {
        if (values.some((each, i) => each !== before[i])) [value, before] = [f(...values), values];
        return value;
    };
}

/** Lines of cells, with ; between these where the decimal sign is a comma. */
export const csvText = (lines) => lines.map((line) => line.join(state.sign === "," ? ";" : ",")).join("\n") + "\n";

/** The name of a file of the case: its own first. */
export const fileName = (...words) =>
    [state.name, ...words].map((word) => word.replace(/[^\p{L}\p{N}.-]+/gu, "-")).filter(Boolean).join("-");

/** Hands a file to the browser's downloads. */
export function download(name, content, type) {
    const href = URL.createObjectURL(new Blob([content], { type }));
    Object.assign(document.createElement("a"), { href, download: name }).click();
    setTimeout(() => URL.revokeObjectURL(href), 10000);
}

/** A button that copies a text, and says so for a while. */
export function copyButton(label, text, done = () => "Copied") {
    const click = async ({ target }) => {
        try {
            await navigator.clipboard.writeText(text());
            target.textContent = done();
        } catch {
            target.textContent = "Select the text and copy it";
        }
        setTimeout(() => (target.textContent = label), 2000);
    };
    return html`<button type="button" @click=${click} .textContent=${label}></button>`;
}
