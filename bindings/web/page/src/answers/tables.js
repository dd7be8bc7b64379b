// SPDX-License-Identifier: GPL-3.0-or-later
// Pasted tables as the model reads them; many cases, a row each.
import { ask } from "./library.js";
import { plainRows } from "../number.js";
import { constantsFor } from "./solution.js";

/**
 * { columns, results: names; constants: texts by name; rows: [{ colour, error, cells, values }]; unused } or { complaint }. The texts of
 * the form stand for the columns that the rows lack. Values are texts with all digits and a decimal point.
 */
export function solveRows(text, texts, sign) {
    if (text.trim() === "") return { complaint: "" };
    const { faults, ...answer } = ask("rows", plainRows(text), constantsFor(texts, sign), sign.charCodeAt(0));
    if (faults) return { complaint: faults[0].text };
    return answer.rows ? { constants: {}, ...answer } : { complaint: "no rows below the names" };
}
