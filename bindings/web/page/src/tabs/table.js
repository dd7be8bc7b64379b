// SPDX-License-Identifier: GPL-3.0-or-later
// Results as a table: name, value, unit, meaning.
import { escaped } from "../elements.js";

/** rows: [{ name, value, unit, meaning }]; a value is a text. What has no value is left out. */
export function tableText(caption, rows) {
    const lines = rows
        .filter((row) => row.value !== "")
        .map(
            ({ name, value, unit, meaning }) =>
                `<tr><th scope="row">${escaped(name)}</th><td class="value" data-name="${escaped(name)}">${escaped(value)}</td><td>${escaped(unit ?? "")}</td><td class="meaning">${escaped(meaning ?? "")}</td></tr>`,
        );
    return `<table class="numbers"><caption class="hidden">${escaped(caption)}</caption><tbody>${lines.join("")}</tbody></table>`;
}

export const noResults = "<p>No results: the status says why.</p>";
