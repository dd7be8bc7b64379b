// SPDX-License-Identifier: GPL-3.0-or-later
// Results as a table: name, value, unit, meaning.
import { html, nothing } from "lit-html";
import { resultKinds } from "../answers/words.js";

const LONG = 24; // characters of a value that has a line of its own

function line({ name, symbol, value, unit, meaning }) {
    const isLong = value.length > LONG;
    const rest = isLong ? nothing : html`<td>${unit}</td><td class="meaning">${meaning}</td>`;
    return html`<tr class=${isLong ? "long" : nothing}><th scope="row">${symbol ?? name}</th>
        <td class="value" data-name=${symbol ? nothing : name} colspan=${isLong ? 3 : nothing}>${value}</td>${rest}</tr>`;
}

/** The row of a result of the case. */
export function resultRow({ results, unit, write }, name) {
    const kind = resultKinds[name];
    return { name, value: write(results[name]), unit: unit[kind.unit], meaning: kind.meaning };
}

/** rows: [{ name or symbol, value, unit, meaning }]; a value is a text. What has no value is left out. */
export const table = (caption, rows) => html`<table class="numbers"><caption class="hidden">${caption}</caption>
    <tbody>${rows.filter(({ value }) => value !== "").map(line)}</tbody></table>`;
