// SPDX-License-Identifier: GPL-3.0-or-later
// The last cycle of a history of loads: its loads, the contact before it, the edges after each load. As cli/fretting/last_cycle.c.
import { status } from "../library.js";

/** The edges of contact and stick zone. */
function edgesOf(contact) {
    const edges = status.orNull(() => contact.edges());
    if (!edges) return [];
    const zone = status.orNull(() => contact.stick_zone());
    return [edges.left, edges.right, ...(zone ? [zone.left, zone.right] : [])];
}

/** { setup, before, loads, lists, edges, slipKnown, error }; lists: P, M, Q, sigma of all loads, which have been tried; error: the largest of q over f p0. */
export function lastCycle(setup, loads, before) {
    const going = before.copy(),
        edges = edgesOf(going);
    let error = going.error();
    for (const { P, M, Q, sigma } of loads) {
        going.apply(P, M, Q, sigma);
        edges.push(...edgesOf(going));
        error = Math.max(error, going.error());
    }
    going.free();
    const lists = ["P", "M", "Q", "sigma"].map((name) => Float64Array.from(loads, (load) => load[name]));
    status.orNull(() => before.keep_cycle(...lists));
    const slipKnown = Boolean(status.orNull(() => before.cycle_friction(...lists, new Float64Array(0))));
    return { setup, before, loads, lists, edges, slipKnown, error };
}
