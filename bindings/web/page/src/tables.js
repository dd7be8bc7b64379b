// SPDX-License-Identifier: GPL-3.0-or-later
// Pasted tables as the model reads them; many cases, a row each.
import { ask } from "./library.js";
import { linesOf } from "./solution.js";

/** The model knows tabs, ; and , between cells. Without any of these in the first line, spaces separate. */
export function separated(text) {
    const trimmed = text.replace(/^\s+/, "").replaceAll("\u2212", "-");
    return /^[^\r\n]*[\t;,]/.test(trimmed) ? trimmed : trimmed.replace(/ +/g, "\t");
}

/**
 * { columns, results: names; constants: [[name, text]]; rows: [{ colour, error, cells, values }]; unused } or { complaint }. The texts of
 * the form stand for the columns that the rows lack. Values are texts with all digits and a decimal point.
 */
export function solveRows(text, texts, sign) {
    const answer = { columns: [], results: [], constants: [], rows: [], unused: "" };
    if (text.trim() === "") return { complaint: "" };
    for (const [kind, ...fields] of ask("rows", separated(text), linesOf(texts, sign), sign.charCodeAt(0))) {
        if (kind === "refused") return { complaint: fields[1] };
        if (kind === "columns" || kind === "results") answer[kind] = fields;
        if (kind === "constant") answer.constants.push(fields);
        if (kind === "unused") answer.unused = fields[0];
        if (kind !== "row") continue;
        const [colour, error, ...cells] = fields;
        const at = answer.columns.length;
        answer.rows.push({ colour, error, cells: cells.slice(0, at), values: cells.slice(at) });
    }
    return answer.rows.length > 0 ? answer : { complaint: "no rows below the names" };
}
