// SPDX-License-Identifier: GPL-3.0-or-later
// What the tab Cycle asks for: from a table of loads to measures along the surface, the worst places, and the loop.
import { goThrough } from "../tables.js";
import { lastCycle } from "./last_cycle.js";
import { loopOf } from "./loop.js";
import { measure } from "./measures.js";
import { usualPlaces, worstPlaces } from "./surface.js";

/** { x, measured, worst, loop, slipKnown, loads, unused } or { complaint }. */
export function answerOf(texts, text, sign, times) {
    const { complaint, setup, loads, unused, contact } = goThrough(texts, text, sign, times);
    if (complaint) return { complaint };
    const of = lastCycle(setup, loads, contact);
    contact.free();
    const x = usualPlaces(of);
    if (!x) return { complaint: "there is no contact in the cycle" };
    const measured = measure(of, x),
        worst = worstPlaces(of, x, measured);
    const loop = loopOf(of, worst.energy_per_area?.x);
    of.free();
    return { x, measured, worst, loop, slipKnown: of.slipKnown, loads, unused };
}
