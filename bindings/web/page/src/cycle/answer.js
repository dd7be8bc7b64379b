// SPDX-License-Identifier: GPL-3.0-or-later
// What the tab Cycle asks for: from a table of loads to measures along the surface, the worst places, and the loop.
import { goThrough } from "../tables.js";
import { lastCycle } from "./last_cycle.js";
import { loopOf } from "./loop.js";
import { measure, worstPlaces } from "./measures.js";
import { usualPlaces } from "./surface.js";

function measuredAlong(cycle) {
    const x = usualPlaces(cycle);
    if (!x) return { complaint: "there is no contact in the cycle" };
    const measured = measure(cycle, x),
        worst = worstPlaces(cycle, x, measured);
    return { x, measured, worst, loop: loopOf(cycle, worst.energy_per_area?.x), slipKnown: cycle.slipKnown };
}

/** { x, measured, worst, loop, slipKnown, loads, unused } or { complaint }. */
export function answerOf(texts, text, sign, times) {
    const { complaint, setup, loads, unused, contact } = goThrough(texts, text, sign, times);
    if (complaint) return { complaint };
    try {
        return { ...measuredAlong(lastCycle(setup, loads, contact)), loads, unused };
    } finally {
        contact.free();
    }
}
