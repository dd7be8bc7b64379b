// SPDX-License-Identifier: GPL-3.0-or-later
// Pasted tables as the model reads them; many cases, a row each.
import { ask } from "./library.js";
import { constantsFor } from "./solution.js";

/** The model knows tabs, ; and , between cells. Without any in the first line that is not blank, spaces do. */
export function separated(text) {
    const trimmed = text.replace(/^\s+/, (blank) => blank.replace(/[^\r\n]/g, "")).replaceAll("\u2212", "-");
    return /^[\r\n]*[^\r\n]*[\t;,]/.test(trimmed) ? trimmed : trimmed.replace(/ +/g, "\t");
}

/**
 * { columns, results: names; constants: texts by name; rows: [{ colour, error, cells, values }]; unused } or { complaint }. The texts of
 * the form stand for the columns that the rows lack. Values are texts with all digits and a decimal point.
 */
export function solveRows(text, texts, sign) {
    if (text.trim() === "") return { complaint: "" };
    const { faults, ...answer } = ask("rows", separated(text), constantsFor(texts, sign), sign.charCodeAt(0));
    if (faults) return { complaint: faults[0].text };
    return answer.rows ? { constants: {}, ...answer } : { complaint: "no rows below the names" };
}
