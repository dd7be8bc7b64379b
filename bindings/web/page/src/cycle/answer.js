// SPDX-License-Identifier: GPL-3.0-or-later
// What the tab Cycle asks for: from a table of loads to measures along the surface, the worst places, and the loop.
import { readCase } from "../case/contact_case.js";
import { lastCycle } from "./last_cycle.js";
import { readLoads } from "./loads_table.js";
import { loopOf } from "./loop.js";
import { measure } from "./measures.js";
import { usualPlaces, worstPlaces } from "./surface.js";

const LONGEST = 2000; // loads times cycles that are computed while one types

/** Without a table: Q to and fro under constant P. */
export function usualLoads({ P, Q, f }) {
    const most = Q !== 0 ? Math.abs(Q) : 0.5 * f * P;
    return `P\tQ\n${P}\t${most}\n${P}\t${-most}`;
}

/** { x, measured, worst, loop, slipKnown } or { complaint }. */
export function answerOf(texts, text, cycles) {
    const { what, complaints } = readCase(texts, { withLoads: false });
    if (complaints) return { complaint: complaints.map((c) => c.text).join("; ") };
    const { loads, complaint } = readLoads(text || usualLoads(what));
    if (complaint) return { complaint };
    if (!Number.isInteger(cycles) || cycles < 1) return { complaint: "cycles must be a whole number from 1" };
    if (loads.length * cycles > LONGEST)
        return {
            complaint: `loads times cycles must not exceed ${LONGEST} here; the command "rwedge fretting" takes more`,
        };
    const of = lastCycle(what, loads, cycles);
    if (of.complaint) return of;
    const x = usualPlaces(of);
    if (!x) return { complaint: "there is no contact in the cycle" };
    const measured = measure(of, x),
        worst = worstPlaces(of, x, measured);
    const loop = loopOf(of, worst.energy_per_area?.x);
    of.free();
    return { x, measured, worst, loop, slipKnown: of.slipKnown };
}
