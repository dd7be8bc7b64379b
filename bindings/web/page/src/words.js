// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the model: inputs, results of "rwedge solve", measures of "rwedge fretting".
import { ask } from "./library.js";

const records = ask("words");
const ofKind = (kind) => records.filter((record) => record[0] === kind).map((record) => record.slice(1));
const kinds = (kind) => ofKind(kind).map(([name, unit, meaning]) => ({ name, unit, meaning }));

/** By name, in the tool's order. */
export const inputs = Object.fromEntries(
    ofKind("input").map(([name, option, unit, meaning]) => [name, { option, unit, meaning }]),
);
export const inputNames = Object.keys(inputs);

/** Two ways to give the same: the other way of the first. */
export const alternatives = Object.fromEntries(
    ofKind("input").flatMap(([name, , , , other]) => (other ? [[name, other]] : [])),
);

export const resultKinds = kinds("result");
/** By name. */
export const measures = Object.fromEntries(kinds("measure").map((kind) => [kind.name, kind]));

/** Titles of the criteria that are offered, by their columns. */
export const criteria = {
    swt: "Smith\u2013Watson\u2013Topper",
    fatemi_socie: "Fatemi\u2013Socie",
    findley: "Findley",
    modified_wohler: "modified W\u00f6hler curve",
    mcdiarmid: "McDiarmid",
    crossland: "Crossland",
    dang_van: "Dang Van",
};
