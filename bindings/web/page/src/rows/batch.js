// SPDX-License-Identifier: GPL-3.0-or-later
// Many cases: a row each. As "rwedge solve --input": what columns lack is taken from the case.
import { alternatives, inputNames, isGiven, readInput } from "../case/inputs.js";
import { loadedContact, readCase } from "../case/contact_case.js";
import { isOffCentre, resultKinds, solve } from "../case/results.js";
import { wholeNumber } from "../number.js";
import { readHeader } from "./header.js";
import { readRows } from "./paste.js";

const edgeResults = ["left", "right", "stick_left", "stick_right", "tilt"];
const pairs = [...Object.entries(alternatives), ["E2", "nu2"]];

/** The inputs of the case that no column has, and none the other way. */
function constantsFor(names, texts) {
    const isColumn = (input) =>
        names.includes(input) || pairs.some((pair) => pair.includes(input) && pair.some((one) => names.includes(one)));
    return Object.fromEntries(
        inputNames.filter((input) => isGiven(texts, input) && !isColumn(input)).map((input) => [input, texts[input]]),
    );
}

function textsOf(row, column, constants) {
    const texts = { ...constants };
    for (const [input, at] of Object.entries(column)) texts[input] = row[at] ?? "";
    return texts;
}

/** An empty cell is a gap in the data: a default would look like a result. Only a rigid body has no Poisson's ratio. */
function gapIn(texts, column) {
    const rigid = isGiven(texts, "E2") && readInput("E2", texts.E2).value === Infinity;
    const gap = Object.keys(column).find((input) => !isGiven(texts, input) && !(input === "nu2" && rigid));
    return gap ? `${gap}: the cell is empty` : null;
}

/** { results } or { error }. */
function solveRow(row, names, column, constants) {
    if (row.length !== names.length) return { error: `${row.length} cells in this row, ${names.length} in the header` };
    const texts = textsOf(row, column, constants),
        gap = gapIn(texts, column);
    if (gap) return { error: gap };
    const { what, complaints } = readCase(texts);
    if (complaints) return { error: complaints.map((c) => c.text).join("; ") };
    const { contact, fault } = loadedContact(what);
    if (fault) return { error: fault.text };
    try {
        const results = solve(what, contact);
        if (!("f" in texts)) results.warnings = [results.warnings, "no friction given"].filter(Boolean).join("; ");
        return { results, offCentre: isOffCentre(what) };
    } catch (error) {
        return { error: error.message };
    } finally {
        contact.free();
    }
}

/** A result that the rows have as an input is not repeated. */
function columnsOfResults(names, constants, wanted) {
    const edges = [...names, ...Object.keys(constants)].some((name) => name === "M" || name === "sigma");
    return resultKinds
        .map(({ name }) => name)
        .filter((name) => wanted(name) && !names.includes(name) && (edges || !edgeResults.includes(name)));
}

const cellOf = (value, sign) =>
    value === null || Number.isNaN(value)
        ? ""
        : typeof value === "number"
          ? wholeNumber(value).replace(".", sign)
          : value;

/** { names, rows: [[text ...]], errors, warnings } or { complaint }; rows are those that were pasted, with results behind. */
export function solveRows(text, texts, sign) {
    const [names, ...rows] = readRows(text);
    if (!names || rows.length === 0) return { complaint: names ? "no rows below the names" : "" };
    const constants = constantsFor(names, texts);
    const { column, complaints } = readHeader(names, inputNames, constants);
    const shown = columnsOfResults(names, constants, (name) => name !== "yield_factor");
    const taken = shown.concat("error").find((name) => names.includes(name) && !inputNames.includes(name));
    if (taken) complaints.push(`column ${taken}: a result has that name; allowed: any other`);
    if (Object.keys(column).length === 0)
        complaints.push(`the first row must name the columns, as ${inputNames.join(", ")}`);
    if (complaints.length > 0) return { complaint: complaints.join("; ") };
    const solved = rows.map((row) => solveRow(row, names, column, constants));
    return {
        names: [...names, ...shown, "error"],
        constants,
        rows: solved.map((one, i) => [
            ...names.map((_, k) => rows[i][k] ?? ""),
            ...shown.map((name) => (one.results ? cellOf(one.results[name], sign) : "")),
            one.error ?? "",
        ]),
        state: solved.map((one) =>
            one.error ? "red" : one.results.warnings || one.results.safety < 1 ? "amber" : "green",
        ),
        errors: solved.filter((one) => one.error).length,
    };
}
