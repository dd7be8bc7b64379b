// SPDX-License-Identifier: GPL-3.0-or-later
// Loads of a contact, and what is wrong with one: as cli/contact/loads.c.
import { rwedge, status, statuses } from "../library.js";
import { writeNumber } from "../number.js";

const apply = (contact, { P, M, Q, sigma }) => status.of(() => contact.apply(P, M, Q, sigma));

/** Q and sigma grow together from 0 under constant P and M. The status. */
export function applyMonotonic(contact, load) {
    const first = apply(contact, { P: load.P, M: load.M, Q: 0, sigma: 0 });
    return first === statuses.RWEDGE_OK ? apply(contact, load) : first;
}

function isInDomain(contact, load) {
    const trial = contact.copy();
    const answer = apply(trial, load);
    trial.free();
    return answer !== statuses.RWEDGE_EDOMAIN;
}

const SIZE_LEAST = 1e-60; // whatever has a size is 0 or at least this

/** The magnitude below which a moment lays no flank on the surface, to the digits that are shown. */
function largestMoment(contact, load) {
    let allowed = 0,
        refused = load.M;
    while (Math.abs(refused) >= SIZE_LEAST && Math.abs(refused - allowed) > 1e-7 * Math.abs(refused)) {
        const M = allowed + (refused - allowed) / 2;
        if (isInDomain(contact, { ...load, M })) allowed = M;
        else refused = M;
    }
    return Math.abs(allowed);
}

function domainFault(contact, load) {
    if (load.P < 0) return { input: "P", text: "P must not be below 0, and Q must be 0 where P is" };
    if (load.P === 0 && load.M !== 0) return { input: "M", text: "M must be 0 where P is" };
    if (!isInDomain(contact, { ...load, M: 0 })) return { text: rwedge.strerror(statuses.RWEDGE_EDOMAIN) };
    const most = largestMoment(contact, load);
    if (most === 0) return { input: "M", text: "M must be 0: any other lays a flank on the surface" };
    return {
        input: "M",
        text: `M must be below ${writeNumber(most, 6)} in magnitude: more lays a flank on the surface`,
    };
}

function pathFault(contact, load) {
    const last = contact.loads();
    const why = `no closed form: ${contact.obstacle(load.P, load.M, load.Q, load.sigma)}`;
    const most = contact.largest_tension_step(load.Q);
    const isStep = load.P === last.P && load.M === last.M && Math.abs(load.sigma - last.sigma) > most;
    return {
        input: "sigma",
        text: isStep ? `${why}; sigma may change by ${writeNumber(most, 6)} with this Q` : why,
        noClosedForm: true,
    };
}

/** Why a contact as it is refuses a load: { input, text }, and whether it slides or has no closed form. */
export function faultOfLoad(answer, contact, load, f) {
    if (answer === statuses.RWEDGE_EDOMAIN) return domainFault(contact, load);
    if (answer === statuses.RWEDGE_EPATH) return pathFault(contact, load);
    if (answer === statuses.RWEDGE_ESLIDING)
        return {
            input: "Q",
            text: `Q must not exceed f P = ${writeNumber(f * load.P, 6)}: there is no equilibrium`,
            slides: true,
        };
    return { text: rwedge.strerror(answer) };
}

/** Goes on to a load: nothing, or the fault. The contact is then as before. */
export function applyNext(contact, load, f) {
    const answer = apply(contact, load);
    return answer === statuses.RWEDGE_OK ? null : faultOfLoad(answer, contact, load, f);
}
