// SPDX-License-Identifier: GPL-3.0-or-later
// A cycle of loads from pasted rows: columns P, Q, perhaps M and sigma; or, without names, P and Q, or P, M, Q, sigma.
import { readHeader } from "../rows/header.js";
import { readRows } from "../rows/paste.js";
import { readNumber } from "../number.js";

const order = { 2: ["P", "Q"], 4: ["P", "M", "Q", "sigma"] };

/** { loads } or { complaint }. What has no column is 0. */
export function readLoads(text) {
    const rows = readRows(text);
    if (rows.length === 0) return { complaint: "no loads" };
    const named = rows[0].some((cell) => cell !== "" && Number.isNaN(readNumber(cell)));
    const names = named ? rows[0] : order[rows[0].length];
    if (!names) return { complaint: "a row without names must have 2 numbers, P and Q, or 4: P, M, Q, sigma" };
    const { column, complaints } = readHeader(names, ["P", "M", "Q", "sigma"]);
    if (complaints.length > 0) return { complaint: complaints.join("; ") };
    if (!("P" in column && "Q" in column)) return { complaint: "columns P and Q are needed; M and sigma may be there" };
    const loads = [];
    for (const [i, row] of rows.slice(named ? 1 : 0).entries()) {
        const load = { P: 0, M: 0, Q: 0, sigma: 0 };
        for (const [name, at] of Object.entries(column)) {
            load[name] = readNumber(row[at] ?? "");
            if (!Number.isFinite(load[name]))
                return { complaint: `row ${i + 1}: ${name} must be a number, not '${row[at] ?? ""}'` };
        }
        loads.push(load);
    }
    return loads.length > 0 ? { loads } : { complaint: "no loads below the names" };
}
