// SPDX-License-Identifier: GPL-3.0-or-later
// Results as a table: name, value, unit, meaning.
import { escaped } from "../elements.js";

const LONG = 24; // characters of a value that has a line of its own

function lineText({ name, symbol, value, unit, meaning }) {
    const cell = symbol ? 'class="value"' : `class="value" data-name="${escaped(name)}"`;
    const rest =
        value.length > LONG
            ? `<td ${cell} colspan="3">${escaped(value)}</td>`
            : `<td ${cell}>${escaped(value)}</td><td>${escaped(unit ?? "")}</td><td class="meaning">${escaped(meaning ?? "")}</td>`;
    return `<tr${value.length > LONG ? ' class="long"' : ""}><th scope="row">${escaped(symbol ?? name)}</th>${rest}</tr>`;
}

/** rows: [{ name or symbol, value, unit, meaning }]; a value is a text. What has no value is left out. */
export function tableText(caption, rows) {
    const lines = rows.filter((row) => row.value !== "").map(lineText);
    return `<table class="numbers"><caption class="hidden">${escaped(caption)}</caption><tbody>${lines.join("")}</tbody></table>`;
}

export const noResults = "<p>No results: the status says why.</p>";
