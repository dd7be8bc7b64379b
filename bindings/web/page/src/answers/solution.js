// SPDX-License-Identifier: GPL-3.0-or-later
// A case as the model answers it: from texts to numbers, results and verdict, or what is wrong.
import { answeredContact, ask } from "./library.js";
import { withPoint, withSign } from "../number.js";
import { rowsOfProfile } from "../pads.js";

const profileLine = (name, text, hull, sign) => `${hull ? "hull" : name}=${rowsOfProfile(text, sign)}`;
const linesFor = ({ hull, ...texts }, sign, write) =>
    Object.entries(texts).map(([name, text]) =>
        name === "profile" ? profileLine(name, text, hull, sign) : `${name}=${write(text, sign)}`,
    );

/** The texts for the model, one after the other, with their decimal sign. The profile is "hull" where its convex hull is taken. */
export const textsFor = (texts, sign) => [`decimal_sign=${sign}`, ...linesFor(texts, sign, withSign)].join("\x1e");

/** The same with a decimal point, as constants of rows that have a sign of their own. */
export const constantsFor = (texts, sign) => linesFor(texts, sign, withPoint).join("\x1e");

/** What an answer of the model has where nothing is said of it. */
const none = { inputs: {}, faults: [], setup: null, hardest: null, results: null, verdict: null, remark: "" };

/** The factor by which the yield stress may fall, as in the workbook. */
const safetyOnStrength = (r) => (r.load_over_bk && r.P_over_bk !== null ? r.P_over_bk / r.load_over_bk : null);

let held = null;

/**
 * The case as it stands: { inputs: numbers by name, faults: [{ input, text }], setup, hardest, results, verdict, remark, contact }. setup has
 * the numbers of the case, where it is one, and the places of a profile; a number that there is not is null. The contact is under its
 * loads, one at a time: the next one that has results frees it. length is the unit that the verdict names.
 */
export function solveHolding(texts, sign, length = "") {
    const answer = { ...none, ...ask("answer", textsFor(texts, sign), length, sign.charCodeAt(0)) };
    if (!answer.results) return { ...answer, contact: null };
    held?.free();
    held = answeredContact();
    return {
        ...answer,
        results: { ...answer.results, safety_strength: safetyOnStrength(answer.results) },
        contact: held,
    };
}

/** The radius, a, P or f with which the case has a safety in full sliding: { value } or { complaint }. */
export function findInput(texts, sign, name, safety) {
    const { faults, value } = ask("find", textsFor(texts, sign), name, safety);
    return faults ? { complaint: faults[0].text } : { value };
}

export const isOffCentre = ({ M, sigma }) => M !== 0 || sigma !== 0;
