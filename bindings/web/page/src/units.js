// SPDX-License-Identifier: GPL-3.0-or-later
// Any consistent set of units does. Where the set changes, numbers go from one to the other, or the labels alone change.

const made = (length, force, stress) => ({
    length,
    stress,
    force: force,
    "force/length": `${force}/${length}`,
    "1/stress": `1/${stress}`,
    "force*length": `${force}\u00b7${length}`,
    rad: "rad",
    deg: "\u00b0",
    none: "",
    text: "",
    "force*stress/length": `${force}/${length}\u00b7${stress}`,
});

/** With the sizes of a length and a force in metres and newtons, where they have any. */
export const unitSystems = {
    mm: { name: "mm, N, MPa", unit: made("mm", "N", "MPa"), length: 1e-3, force: 1 },
    m: { name: "m, N, Pa", unit: made("m", "N", "Pa"), length: 1, force: 1 },
    in: { name: "in, lbf, psi", unit: made("in", "lbf", "psi"), length: 0.0254, force: 4.4482216152605 },
    any: { name: "any consistent units", unit: made("length", "force", "stress") },
};

/** What a number of a dimension is multiplied by; 1 where a set has no sizes. */
export function conversion(from, to, dimension) {
    const [length, force] = ["length", "force"].map((size) => unitSystems[from][size] / unitSystems[to][size]);
    const stress = force / length ** 2;
    const factors = {
        length,
        force,
        stress,
        "force/length": force / length,
        "1/stress": 1 / stress,
        "stress*sqrt(length)": stress * Math.sqrt(length),
    };
    return Number.isFinite(length) ? (factors[dimension] ?? 1) : 1;
}

export const unitsRemark =
    "Any consistent units do. Another choice converts all numbers, pasted ones too, unless \u201cconvert\u201d is off. Forces are per unit length.";
