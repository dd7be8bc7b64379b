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
export const measureKinds = kinds("measure");

/** Criteria by their columns, as they are offered. */
export const criteria = {
    swt: { title: "Smith\u2013Watson\u2013Topper", unit: "stress" },
    fatemi_socie: { title: "Fatemi\u2013Socie", unit: "none" },
    findley: { title: "Findley", unit: "stress" },
    modified_wohler: { title: "modified W\u00f6hler curve", unit: "stress" },
    mcdiarmid: { title: "McDiarmid", unit: "none" },
    crossland: { title: "Crossland", unit: "stress" },
    dang_van: { title: "Dang Van", unit: "stress" },
};
