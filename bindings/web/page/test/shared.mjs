// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests share: numbers that are nearly the same; cases by chance, the same ones each time.
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
export const optionsOf = (texts) => Object.entries(texts).flatMap(([name, text]) => [`--${name.replaceAll("_", "-")}`, text]);

export function assertNear(value, expected, tolerance, about) {
    const difference = Math.abs(Number(value) - expected);
    assert.ok(difference <= tolerance * Math.abs(expected), `${about}: ${value}, not ${expected}`);
}

/** Numbers from 0 to 1, the same in each run (Lehmer, 48271 modulo 2^31 - 1). */
export function chance(seed) {
    let state = seed;
    return () => (state = (state * 48271) % 2147483647) / 2147483647;
}

/** One case, texts by the tool's names of the inputs. Every third has a moment, a tension or both; every fifth another material, every seventh a rigid wedge. */
export function randomCase(next, i) {
    const between = (lo, hi) => Number((lo * (hi / lo) ** next()).toPrecision(4));
    const texts = { E1: String(between(7e4, 3e5)), nu1: String(Number((0.2 + 0.25 * next()).toFixed(3))) };
    const theta = between(0.002, 0.08),
        a = i % 11 === 10 ? 0 : between(0.01, 2);
    if (i % 2) texts.theta = String(theta);
    else texts.theta_deg = String(Number(((theta * 180) / Math.PI).toPrecision(5)));
    if (i % 4 < 2 || a === 0) texts.a = String(a);
    else texts.radius = String(Number((a / theta).toPrecision(5)));
    if (i % 5 === 4) Object.assign(texts, { E2: String(between(7e4, 3e5)), nu2: "0.33" });
    if (i % 7 === 6) Object.assign(texts, { E2: "inf", nu2: "0.3" });
    const P = between(20, 3000),
        f = Number((0.05 + 0.7 * next()).toFixed(3));
    Object.assign(texts, {
        P: String(P),
        f: String(f),
        Q: String(Number((f * P * (1.8 * next() - 0.9)).toPrecision(3))),
    });
    if (i % 3 === 1) texts.sigma = String(Number((20 * next()).toPrecision(3)));
    if (i % 3 === 2) texts.M = String(Number((P * Math.max(a, 0.02) * 0.2 * next()).toPrecision(3)));
    if (i % 2) texts.k = String(between(150, 900));
    else texts.yield_stress = String(between(250, 1500));
    return texts;
}
