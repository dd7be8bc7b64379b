// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests share: cases, numbers that are nearly the same, numbers by chance.
import assert from "node:assert/strict";

export const usual = { E1: "210000", nu1: "0.3", theta: "0.01", a: "0.05", P: "190", Q: "20", f: "0.2", k: "400" };

const body = { E1: "210000", nu1: "0.3", P: "300", Q: "40", f: "0.3", k: "400" };
export const parabola = Array.from({ length: 41 }, (_, i) => [(i - 20) / 20, ((i - 20) / 20) ** 2 / 20]);
export const rowsOf = (places) => ["x,height", ...places.map((row) => row.join())].join("\n");

/** A case of each pad. */
export const ofPads = {
    wedge: { ...body, theta: "0.01", a: "0.05" },
    cylinder: { ...body, radius: "10" },
    flat: { ...body, flat: "0.5", radius: "10" },
    profile: { ...body, profile: rowsOf(parabola) },
};

/** Of the tool, for texts of inputs by name. */
export const optionsOf = ({ similar, ...texts }) => [
    ...Object.entries(texts).flatMap(([name, text]) => [`--${name.replaceAll("_", "-")}`, text]),
    ...(similar ? ["--similar"] : []),
];

export function assertNear(value, expected, tolerance, about) {
    const difference = Math.abs(Number(value) - expected);
    assert.ok(difference <= tolerance * Math.abs(expected), `${about}: ${value}, not ${expected}`);
}

/** Numbers from 0 to 1, the same in each run (Lehmer, 48271 modulo 2^31 - 1). */
export function chance(seed) {
    let state = seed;
    return () => (state = (state * 48271) % 2147483647) / 2147483647;
}
