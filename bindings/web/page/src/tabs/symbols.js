// SPDX-License-Identifier: GPL-3.0-or-later
// Results as people write them, and which of them belong together.

export const symbols = {
    b: "b",
    a: "a",
    radius: "R",
    a_over_b: "a/b",
    left: "x\u2081",
    right: "x\u2082",
    p0: "p\u2080",
    p0_x: "x of p\u2080",
    p_transition: "p(a)",
    c: "c",
    c_over_b: "c/b",
    Q_over_fP: "Q/(fP)",
    max_tension: "\u03c3\u209c",
    max_tension_sliding: "\u03c3\u209c, sliding",
    yield_factor: "factor on the stress",
    safety: "factor on P, sliding",
    P_yield: "P at yield, sliding",
    yield_x: "x of yield, sliding",
    yield_y: "y of yield, sliding",
};

export const groups = [
    { title: "Size", names: ["b", "a", "radius", "a_over_b", "left", "right"] },
    { title: "Pressure", names: ["p0", "p0_x", "p_transition"] },
    { title: "Stick", names: ["c", "c_over_b", "Q_over_fP"] },
    { title: "Tension", names: ["max_tension", "max_tension_sliding"] },
    { title: "Strength", names: ["yield_factor", "safety", "P_yield", "yield_x", "yield_y"] },
];

/** Of a contact in the middle these are -b and b. */
export const ofEdges = ["left", "right"];
