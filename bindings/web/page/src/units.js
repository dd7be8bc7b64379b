// SPDX-License-Identifier: GPL-3.0-or-later
// Units are labels: any consistent set does. Where the user says so, numbers go from one set to another.

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

export const unitSystems = {
    mm: { name: "mm, N, MPa", unit: made("mm", "N", "MPa") },
    m: { name: "m, N, Pa", unit: made("m", "N", "Pa") },
    in: { name: "in, lbf, psi", unit: made("in", "lbf", "psi") },
    any: { name: "any consistent units", unit: made("length", "force", "stress") },
};

/** In metres and newtons. */
const sizes = {
    mm: { length: 1e-3, force: 1 },
    m: { length: 1, force: 1 },
    in: { length: 0.0254, force: 4.4482216152605 },
};

/** What a number of a dimension is multiplied by; 1 where a set has no sizes. */
export function conversion(from, to, dimension) {
    const [length, force] = ["length", "force"].map(
        (size) => (sizes[from]?.[size] ?? NaN) / (sizes[to]?.[size] ?? NaN),
    );
    const factors = { length, force, "force/length": force / length, stress: force / length ** 2 };
    return Number.isFinite(length) ? (factors[dimension] ?? 1) : 1;
}

export const unitsRemark =
    "Any consistent units do; those shown are labels, unless \u201cconvert\u201d is set. Forces are per unit length.";
