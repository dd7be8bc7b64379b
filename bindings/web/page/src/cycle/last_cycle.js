// SPDX-License-Identifier: GPL-3.0-or-later
// The last cycle of a course of loads: its loads, the contact before it, the edges after each load. As cli/fretting/last_cycle.c.
import { status } from "../library.js";

/** The edges of contact and stick zone. */
function edgesOf(contact) {
    const edges = status.orNull(() => contact.edges());
    if (!edges) return [];
    const zone = status.orNull(() => contact.stick_zone());
    return [edges.left, edges.right, ...(zone ? [zone.left, zone.right] : [])];
}

/** { setup, before, loads, lists, edges, slipKnown }; lists: P, M, Q, sigma of all loads. The loads have been tried. */
export function lastCycle(setup, loads, before) {
    const going = before.copy(),
        edges = edgesOf(going);
    for (const { P, M, Q, sigma } of loads) {
        going.apply(P, M, Q, sigma);
        edges.push(...edgesOf(going));
    }
    going.free();
    const lists = ["P", "M", "Q", "sigma"].map((name) => Float64Array.from(loads, (load) => load[name]));
    const slipKnown = Boolean(status.orNull(() => before.cycle_friction(...lists, new Float64Array(0))));
    return { setup, before, loads, lists, edges, slipKnown };
}
