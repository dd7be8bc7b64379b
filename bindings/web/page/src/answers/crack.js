// SPDX-License-Identifier: GPL-3.0-or-later
// A crack in the cycle that was asked about last, as the model answers it.
import { ask } from "./library.js";
import { withPoint } from "../number.js";

/**
 * { length, threshold, dK: by shear, verdict: by shear, sentence, doubt } or { complaint }. crack: { edge, angle, from, to: texts, unit: of
 * length }. Threshold and verdict are only there where the material of the cycle has what they need.
 */
export function crackOf({ edge, angle, from, to, unit }, sign) {
    const { faults, ...answer } = ask("crack", edge, ...[angle, from, to].map((text) => withPoint(text, sign)), unit);
    return faults ? { complaint: faults.map(({ text }) => text).join("; ") } : answer;
}
