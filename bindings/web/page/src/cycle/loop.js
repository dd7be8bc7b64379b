// SPDX-License-Identifier: GPL-3.0-or-later
// The loop of the last cycle: of the whole contact where P is constant and there is no moment or tension, else of one place.
import { status, statuses } from "../library.js";

const MOST = 240, // states
    names = ["P", "M", "Q", "sigma"];

const between = (from, to, share) => names.map((name) => from[name] + (to[name] - from[name]) * share);

/** The contact before the cycle, after each load, and in between as far as it can be had. */
function eachState({ before, loads }, see) {
    const going = before.copy(),
        steps = Math.max(1, Math.min(24, Math.round(MOST / loads.length)));
    see(going);
    for (const to of loads) {
        const from = going.loads(),
            way = going.copy(),
            apply = (i) => status.of(() => way.apply(...between(from, to, i / steps))) === statuses.RWEDGE_OK;
        for (let i = 1; i < steps && apply(i); i++) see(way);
        way.free();
        going.apply(...between(from, to, 1));
        see(going);
    }
    going.free();
}

function isCentred({ before, loads, setup }) {
    const { P } = before.loads();
    return setup.f > 0 && P > 0 && loads.every((load) => load.P === P && load.M === 0 && load.sigma === 0);
}

/** Q over the displacement by slip: the loop encloses the energy of the cycle. */
function ofContact(cycle) {
    const x = [],
        y = [],
        b = cycle.before.half_width();
    eachState(cycle, (contact) => (x.push(contact.displacement(b)), y.push(contact.loads().Q)));
    return { x, y, xName: "displacement by slip", yName: "Q", whole: true };
}

/** The shear traction of a place over its slip, as long as it touches. */
function ofPlace(cycle, place) {
    const x = [],
        y = [],
        at = Float64Array.of(place);
    eachState(cycle, (contact) => {
        const slip = status.orNull(() => contact.slip(at));
        if (slip) (x.push(slip[0]), y.push(contact.tractions(at).q[0]));
    });
    return { x, y, xName: "slip", yName: "q", place };
}

/** { x, y, xName, yName, and whole, or place }; nothing where no slip is known. */
export function loopOf(cycle, place) {
    if (isCentred(cycle)) return ofContact(cycle);
    return cycle.slipKnown && place !== undefined ? ofPlace(cycle, place) : null;
}
