// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the model: inputs, results of "rwedge solve", measures of "rwedge fretting".
import { ask } from "./library.js";

const { inputs, alternatives, results, measures, needs } = ask("words");
for (const [name, all] of Object.entries(needs)) needs[name] = [...new Map(all.map((need) => [need.name, need])).values()]; // a limit is told twice
/** By name, in the tool's order; needs: of each criterion the constants of a material, [{ name, meaning, unit }]. */
export { inputs, measures, needs };
export const inputNames = Object.keys(inputs);

/** The names by which an input can be given: of two ways to give the same, both. */
export const waysOf = (name) => Object.entries(alternatives).find((ways) => ways.includes(name)) ?? [name];

/** All that "rwedge solve" says, and the workbook's safety on strength, by name. */
export const resultKinds = {};
for (const { name, ...kind } of results) {
    resultKinds[name] = kind;
    if (name === "safety")
        resultKinds.safety_strength = { unit: "none", meaning: "k or Y may fall by this factor under this P" };
}

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
