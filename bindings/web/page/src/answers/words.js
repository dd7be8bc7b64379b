// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the model: inputs, results of "rwedge solve", measures of "rwedge fretting".
import { ask } from "./library.js";

/** By name, in the tool's order; the other of two ways to give the same, by the first; the results, a list. */
export const { inputs, alternatives, results: resultKinds, measures } = ask("words");
export const inputNames = Object.keys(inputs);

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
