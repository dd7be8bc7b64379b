// SPDX-License-Identifier: GPL-3.0-or-later
// What the tab Cycle asks for: from a table of loads to measures along the surface, the worst places, and the loop.
import { goThrough } from "../tables.js";
import { missing, readMaterial } from "./criteria.js";
import { lastCycle } from "./last_cycle.js";
import { loopOf } from "./loop.js";
import { measure, worstPlaces } from "./measures.js";
import { usualPlaces } from "./surface.js";

function measuredAlong(cycle) {
    const x = usualPlaces(cycle);
    if (!x) return { complaint: "there is no contact in the cycle" };
    const measured = measure(cycle, x),
        worst = worstPlaces(cycle, x, measured),
        { slipKnown, error, criterion } = cycle;
    return { x, measured, worst, loop: loopOf(cycle, worst.energy_per_area?.x), slipKnown, error, criterion };
}

/** In plane stress the contact is one of Poisson's ratio 0. */
const inPlaneStress = (texts) => ({ ...texts, nu1: "0", ...(texts.nu2 ? { nu2: "0" } : {}) });

/**
 * { x, measured, worst, loop, slipKnown, error, criterion, loads, unused } or { complaint }. chosen: { name of the criterion, isPlaneStress,
 * material: its text, nu }.
 */
export function answerOf(texts, text, sign, times, chosen) {
    const { constants, complaint: wrong } = readMaterial(chosen.material, sign);
    if (wrong) return { complaint: wrong };
    const { complaint, setup, loads, unused, contact } = goThrough(
        chosen.isPlaneStress ? inPlaneStress(texts) : texts,
        text,
        sign,
        times,
    );
    if (complaint) return { complaint };
    try {
        const lacking = missing(chosen.name, constants, setup.k);
        if (lacking) return { complaint: lacking };
        const cycle = lastCycle(setup, loads, contact);
        return { ...measuredAlong({ ...cycle, criterion: { ...chosen, constants } }), loads, unused };
    } finally {
        contact.free();
    }
}
