// SPDX-License-Identifier: GPL-3.0-or-later
// Any consistent set of units does. Where the set changes, numbers go from one to the other, or the labels alone change.

const made = (length, force, stress) => ({
    length,
    stress,
    area: `${length}\u00b2`,
    force: force,
    "force/length": `${force}/${length}`,
    "1/stress": `1/${stress}`,
    "length/force": `${length}/${force}`,
    "area/force": `${length}\u00b2/${force}`,
    "force*length": `${force}\u00b7${length}`,
    rad: "rad",
    deg: "\u00b0",
    none: "",
    text: "",
    "force*stress/length": `${force}/${length}\u00b7${stress}`,
});

export const unitSystems = {
    mm: { name: "mm, N, MPa", unit: made("mm", "N", "MPa") },
    m: { name: "m, N, Pa", unit: made("m", "N", "Pa") },
    in: { name: "in, lbf, psi", unit: made("in", "lbf", "psi") },
    any: { name: "any consistent units", unit: made("length", "force", "stress") },
};

/** A set as the model, case files and the tool have it, "mm,N,MPa"; "" where it has no names. */
export const wordsOf = (units) =>
    units === "any" ? "" : ["length", "force", "stress"].map((name) => unitSystems[units].unit[name]).join(",");

/** The set of these words; any consistent one where it is none of the page's. */
export const unitsNamed = (words) => Object.keys(unitSystems).find((units) => wordsOf(units) === words.replace(/\s/g, "")) ?? "any";

export const unitsRemark =
    "Any consistent units do. Another choice converts all numbers, pasted ones too, unless \u201cconvert\u201d is off. Forces are per unit length.";
