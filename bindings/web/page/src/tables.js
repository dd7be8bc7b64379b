// SPDX-License-Identifier: GPL-3.0-or-later
// Pasted tables as the model reads them: many cases, a row each; the loads of a history.
import { answeredContact, ask } from "./library.js";
import { linesOf, taken } from "./solution.js";

/** The model knows tabs, ; and , between cells. Without any of these in the first line, spaces separate. */
function separated(text) {
    const trimmed = text.replace(/^\s+/, "").replaceAll("\u2212", "-");
    return /^[^\r\n]*[\t;,]/.test(trimmed) ? trimmed : trimmed.replace(/ +/g, "\t");
}

const code = (sign) => sign.charCodeAt(0);

/**
 * { columns, results: names; constants: [[name, text]]; rows: [{ colour, error, cells, values }]; unused } or { complaint }. The texts of
 * the form stand for the columns that the rows lack. Values are texts with all digits and a decimal point.
 */
export function solveRows(text, texts, sign) {
    const answer = { columns: [], results: [], constants: [], rows: [], unused: "" };
    if (text.trim() === "") return { complaint: "" };
    for (const [kind, ...fields] of ask("rows", separated(text), linesOf(texts, sign), code(sign))) {
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

/**
 * The case under pasted loads, which are gone through so many times; without any, its own Q and sigma go to and fro. { setup, loads of the
 * last cycle, unused, contact before it } or { complaint }. Whoever asks frees the contact.
 */
export function goThrough(texts, text, sign, times) {
    const answer = taken(ask("history", linesOf(texts, sign), separated(text), code(sign), times.trim()));
    if (answer.faults.length > 0) return { complaint: answer.faults.map((fault) => fault.text).join("; ") };
    return { ...answer, contact: answeredContact() };
}
