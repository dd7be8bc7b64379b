// SPDX-License-Identifier: GPL-3.0-or-later
// The loop of the last cycle: of the whole contact where P is constant and there is no moment or tension, else of one place.
import { status } from "../library.js";
import { statesOnTheWay } from "./last_cycle.js";

const STEPS = 24,
    NODES = 400;

/** How far remote points have moved along the surface more than if the contact were bonded. As rwedge.plot.displacement() in Python. */
function displacement(contact, A) {
    const b = contact.half_width(),
        c = contact.stick_half_width();
    const edges = c > 0 && c < b ? [0, c, b] : [0, b];
    let total = 0;
    for (let e = 0; e < edges.length - 1; e++) {
        const width = edges[e + 1] - edges[e],
            u = Float64Array.from({ length: NODES }, (_, i) => (i + 0.5) / NODES);
        const s = u.map((v) => edges[e] + width * v ** 3 * (10 - 15 * v + 6 * v * v)),
            { q } = contact.tractions(s); // dense at both ends
        u.forEach((v, i) => (total -= q[i] * Math.log(b / (2 * s[i])) * ((width * 30 * (v * (1 - v)) ** 2) / NODES)));
    }
    return ((2 * A) / Math.PI) * total;
}

/** Every state of the last cycle, from its beginning, with those between loads. */
function eachState({ states, loads }, see) {
    const ends = states.filter((state, i) => state.isLoad || i === 0);
    see(ends[0]);
    loads.forEach((load, i) => {
        const way = statesOnTheWay(ends[i].contact, load, STEPS);
        way.forEach(see);
        way.forEach((state) => state.contact.free());
        see(ends[i + 1]);
    });
}

function isCentred({ states, loads, what }) {
    const [{ P }] = loads,
        first = states[0].contact.loads();
    return what.f > 0 && first.P === P && loads.every((load) => load.P === P && load.M === 0 && load.sigma === 0);
}

/** Q over the displacement by slip: the loop encloses the energy of the cycle. */
function ofContact(of) {
    const x = [],
        y = [];
    eachState(of, ({ contact, Q }) => (x.push(displacement(contact, of.what.A)), y.push(Q)));
    return { x, y, xName: "displacement by slip", yName: "Q", whole: true };
}

/** The shear traction of a place over its slip, as long as it touches. */
function ofPlace(of, place) {
    const x = [],
        y = [],
        at = Float64Array.of(place);
    eachState(of, ({ contact }) => {
        const slip = status.orNull(() => contact.slip(at));
        if (slip) (x.push(slip[0]), y.push(contact.tractions(at).q[0]));
    });
    return { x, y, xName: "slip", yName: "q", place };
}

/** { x, y, xName, yName, and whole, or place }; nothing where no slip is known. */
export function loopOf(of, place) {
    if (isCentred(of)) return ofContact(of);
    return of.slipKnown && place !== undefined ? ofPlace(of, place) : null;
}
