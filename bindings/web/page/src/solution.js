// SPDX-License-Identifier: GPL-3.0-or-later
// A case as the model answers it: from texts to numbers, results and verdict, or what is wrong.
import { answeredContact, ask } from "./library.js";
import { withPoint } from "./number.js";
import { rowsOfProfile } from "./pads.js";

export const number = (text) =>
    text === "" ? NaN : text === "inf" ? Infinity : text === "-inf" ? -Infinity : Number(text);

const takers = {
    refused: (answer, input, text) => answer.faults.push({ input, text }),
    input: (answer, name, value) => (answer.inputs[name] = number(value)),
    case: (answer, name, value) => ((answer.setup ??= { places: [] })[name] = number(value)),
    place: (answer, x, slope) => answer.setup.places.push({ x: number(x), slope: number(slope) }),
    remark: (answer, text) => (answer.remark = text),
    hardest(answer, ...numbers) {
        const [factor, x, y, von_mises] = numbers.map(number);
        answer.hardest = { factor, x, y, von_mises };
    },
    number: (answer, name, value) => ((answer.results ??= {})[name] = value === "" ? null : number(value)),
    text: (answer, name, value) => ((answer.results ??= {})[name] = value === "" ? null : value),
    verdict: (answer, colour, text, strength, factor) =>
        (answer.verdict = { colour, text, strength, factor: number(factor) }),
};

const lineOf = ([name, text], sign) =>
    name === "profile" ? `profile=${rowsOfProfile(text, sign).join("\x1d")}` : `${name}=${withPoint(text, sign)}`;

export const loadOf = (numbers) =>
    Object.fromEntries(["P", "M", "Q", "sigma"].map((name, i) => [name, number(numbers[i])]));

/** The texts as lines for the model. The rows of a profile are one; "hull" has them again where their hull is taken. */
export function linesOf({ hull, ...texts }, sign) {
    const lines = Object.entries(texts).map((entry) => lineOf(entry, sign));
    return (hull ? lines.map((line) => line.replace(/^profile=/, "hull=")) : lines).join("\n");
}

/**
 * From records of the model: { inputs: numbers by name, faults: [{ input, text }], setup, hardest, results, verdict, remark }. setup has the
 * numbers of the case, where it is one, and the places of a profile.
 */
export function taken(records) {
    const answer = { inputs: {}, faults: [], setup: null, hardest: null, results: null, verdict: null, remark: "" };
    for (const [kind, ...fields] of records) takers[kind](answer, ...fields);
    return answer;
}

let held = null;

/** The case as it stands, with its contact under its loads; length is the unit that the verdict names. One at a time: the next one that has results frees it. */
export function solveHolding(texts, sign, length = "") {
    const answer = taken(ask("answer", linesOf(texts, sign), length, sign.charCodeAt(0)));
    if (!answer.results) return { ...answer, contact: null };
    held?.free();
    held = answeredContact();
    return { ...answer, contact: held };
}

/** The radius, a, P or f with which the case has a safety in full sliding: { value } or { complaint }. */
export function findInput(texts, sign, name, safety) {
    const { inputs, faults } = taken(ask("find", linesOf(texts, sign), name, safety));
    return faults.length > 0 ? { complaint: faults[0].text } : { value: inputs[name] };
}

export const isOffCentre = ({ M, sigma }) => M !== 0 || sigma !== 0;

/** The factor by which the yield stress may fall, as in the workbook. */
export const safetyOnStrength = (r) => (r.load_over_bk && r.P_over_bk !== null ? r.P_over_bk / r.load_over_bk : null);
