// SPDX-License-Identifier: GPL-3.0-or-later
// The inputs of a case: their texts become numbers, or complaints in the tool's words.
import { words } from "words";
import { readNumber } from "../number.js";

/** The tool's names, in its order. */
export const inputNames = Object.keys(words.inputs);

/** Two ways to give the same. */
export const alternatives = { theta: "theta_deg", a: "radius", k: "yield_stress" };

/** What one input is. */
export const dimensions = {
    E1: "stress",
    nu1: "none",
    E2: "stress",
    nu2: "none",
    theta: "rad",
    theta_deg: "deg",
    a: "length",
    radius: "length",
    P: "force/length",
    M: "force",
    Q: "force/length",
    sigma: "stress",
    f: "none",
    k: "stress",
    yield_stress: "stress",
};

export const isGiven = (texts, name) => (texts[name] ?? "").trim() !== "";

const isIn = (value, { lo, hi, open }) => (open ? value > lo && value < hi : value >= lo && value <= hi);
const withoutSize = ["nu1", "nu2"];

/** A number, or a complaint: { value } or { complaint }. */
export function readInput(name, text) {
    const input = words.inputs[name];
    const rigid = text.trim().toLowerCase() === "inf";
    if (rigid && name === "E2") return { value: Infinity };
    const value = readNumber(text);
    if (!Number.isFinite(value) || !isIn(value, input))
        return {
            complaint: `${name} must be ${input.domain}${rigid && name === "E1" ? "; a rigid body is body 2" : ""}`,
        };
    const size = Math.abs(value);
    if (withoutSize.includes(name) || size === 0 || (size >= 1e-60 && size <= 1e60)) return { value };
    return { complaint: `${name} must be 1e-60 to 1e60 in magnitude${isIn(0, input) ? ", or 0" : ""}` };
}
