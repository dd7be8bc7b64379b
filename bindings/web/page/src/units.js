// SPDX-License-Identifier: GPL-3.0-or-later
// Units are labels: any consistent set does, and no number is ever converted.

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

/** Those of a name, or the usual ones. */
export const unitsOf = (name) => (Object.hasOwn(unitSystems, name) ? unitSystems[name] : unitSystems.mm).unit;

export const unitSystems = {
    mm: { name: "mm, N, MPa", unit: made("mm", "N", "MPa") },
    m: { name: "m, N, Pa", unit: made("m", "N", "Pa") },
    in: { name: "in, lbf, psi", unit: made("in", "lbf", "psi") },
    any: {
        name: "any consistent units",
        unit: { ...made("length", "force", "stress"), force: "force", "1/stress": "1/stress" },
    },
};

export const unitsRemark =
    "Any consistent units do; those shown are labels, nothing is converted. Forces are per unit length.";
