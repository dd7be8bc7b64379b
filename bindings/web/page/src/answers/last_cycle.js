// SPDX-License-Identifier: GPL-3.0-or-later
// What the last cycle of a history of loads does, as the model answers it; a material's constants as text.
import { answeredContact, ask, goThrough } from "./library.js";
import { plainRows, withPoint } from "../number.js";
import { crackOf } from "./crack.js";
import { loopOf } from "./loop.js";
import { textsFor } from "./solution.js";
import { criteria } from "./words.js";

/** A name and the rest of its line. */
const namesAndRests = (text) =>
    [...text.matchAll(/^\s*([^\s,;=:]+)[^\S\r\n]*[,;=:\t ]?[^\S\r\n]*(.*?)\s*$/gm)].map(([, name, rest]) => [
        name,
        rest,
    ]);

/** A material file, JSON or a name and a number a line: [[name, text with a decimal point]]. */
export function constantsOf(text, sign) {
    const isJson = text.trim().startsWith("{"); // whose numbers have a point
    const entries = isJson ? Object.entries(JSON.parse(text)) : namesAndRests(text);
    return entries.map(([name, value]) => [name, withPoint(String(value), isJson ? "." : sign)]);
}

/** As lines for the model. */
const linesOfMaterial = (text, sign) => constantsOf(text, sign).map((entry) => entry.join("=")).join("\n");

/**
 * { loads, perhaps tilts, or displacements and the compliance of a rig, unused, slipKnown, computed: a remark, x, measured and worst by name, loop where there is one, limit, safety, life: null where not known,
 * criterion with the constants it needs } or { complaint }. text: pasted loads, which are gone through so many times; without any the
 * case's own Q and sigma go to and fro. chosen: { name of the criterion, isPlaneStress, material: its text, units: "mm,N,MPa", "" for any }. crack: what
 * crackOf() takes where one is asked; its answer is `crack`. told() hears the share of the loads that is done.
 */
export function cycleOf(texts, text, sign, times, chosen, crack = null, told = () => {}) {
    let material;
    try {
        material = linesOfMaterial(chosen.material, sign);
    } catch (error) {
        return { complaint: `the material: ${error.message}` };
    }
    const asked = [
        textsFor(texts, sign),
        text.trim() === "" ? "" : plainRows(text),
        sign.charCodeAt(0),
        times.trim(),
        chosen.name,
        Number(chosen.isPlaneStress),
        material,
        chosen.units ?? "",
    ];
    goThrough("cycle", asked, told);
    const { faults, constants = {}, ...answer } = ask("cycle_answer");
    const subject = { criterion: criteria[chosen.name], compliance: "the compliance of the rig" };
    if (faults) return { complaint: faults.map(({ input, text }) => [subject[input], text].filter(Boolean).join(" ")).join("; ") };
    const found = { measured: {}, worst: {}, ...answer, criterion: { ...chosen, constants } },
        before = answeredContact(),
        loop = loopOf(before, found);
    before.free();
    return { ...found, loop, crack: crack && crackOf(crack, sign) };
}
