// SPDX-License-Identifier: GPL-3.0-or-later
// A case as the model answers it: from texts to numbers, results and verdict, or what is wrong.
import { answeredContact, ask } from "./library.js";
import { resultKinds } from "./words.js";
import { plainRows, withPoint, withSign } from "../number.js";

const linesFor = (texts, sign, write) =>
    Object.entries(texts).map(([name, text]) => `${name}=${name === "profile" ? plainRows(text) : write(text, sign)}`);

/**
 * The texts for the model, one after the other, with their decimal sign: of inputs; "hull", "fit", "heights", "origin" of the profile;
 * "units", "width", "section", "compliance", "plane_stress", "strength_of", "rotation" and "similar".
 */
export const textsFor = (texts, sign) => [`decimal_sign=${sign}`, ...linesFor(texts, sign, withSign)].join("\x1e");

/** The same with a decimal point, as constants of rows that have a sign of their own. */
export const constantsFor = (texts, sign) => [`profile_sign=${sign}`, ...linesFor(texts, sign, withPoint)].join("\x1e");

/** What an answer of the model has where nothing is said of it. */
const none = { inputs: {}, shares: {}, faults: [], setup: null, hardest: null, results: null, verdict: null, remark: "" };

/** The factor by which the yield stress may fall, as in the workbook. */
const safetyOnStrength = (r) => (r.load_over_bk && r.P_over_bk !== null ? r.P_over_bk / r.load_over_bk : null);

const ROUNDING = 1e-12; // of the contact's width

const FEW = 5, // places between the highest pressure and an edge
    MUCH = 0.05; // change of p0 without every second place

/** What is doubtful of a measured profile, in words; "" for nothing. */
export function doubtOfProfile({ left, right, change }, percent) {
    const isFew = Math.min(left ?? FEW, right ?? FEW) < FEW;
    return [
        isFew && `only ${Math.min(left, right)} measured places lie between the highest pressure and an edge`,
        Math.abs(change) > MUCH && `without every second place p0 changes by ${percent(change)}`,
        change === null && "without every second place there is no such contact",
    ]
        .filter(Boolean)
        .join("; ");
}

export const percentOf = (share) => `${share < 0 ? "\u2212" : "+"}${Math.abs(100 * share).toPrecision(2)} %`;

/** A verdict that is green beside a doubt is not. */
function judged(verdict, resolution) {
    const doubt = resolution ? doubtOfProfile(resolution, percentOf) : "";
    if (doubt === "" || verdict.colour !== "green") return verdict;
    return { ...verdict, colour: "amber", text: `CAUTION: the profile may not be resolved: ${doubt}` };
}

/** Lengths that are rounding beside the contact are 0. */
function withoutRounding(all, { left, right }) {
    const least = ROUNDING * (right - left),
        isLength = (name) => resultKinds[name]?.unit === "length" || name === "x" || name === "y";
    return Object.fromEntries(Object.entries(all).map(([name, value]) =>
        [name, typeof value === "number" && isLength(name) && Math.abs(value) < least ? 0 : value]));
}

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
    const results = withoutRounding(answer.results, answer.results);
    return {
        ...answer,
        results: { ...results, safety_strength: safetyOnStrength(results) },
        verdict: judged(answer.verdict, answer.resolution),
        contact: held,
    };
}

/** The radius, a, P or f with which the case has a factor: { value } or { complaint }. on: "P", of full sliding; "stress", under the loads; "sliding", the stress in full sliding. */
export function findInput(texts, sign, name, safety, on = "P") {
    const { faults, value } = ask("find", textsFor(texts, sign), name, on, safety);
    return faults ? { complaint: faults[0].text } : { value };
}

export const isOffCentre = ({ M, sigma }) => M !== 0 || sigma !== 0;
