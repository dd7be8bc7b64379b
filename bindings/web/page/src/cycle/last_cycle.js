// SPDX-License-Identifier: GPL-3.0-or-later
// The last cycle of a course of loads: the contact after each load, and on the way where P or M change. As cli/fretting/last_cycle.c.
import { Contact, status, statuses } from "../library.js";
import { applyNext } from "../case/loads.js";

const PARTS = 32;

function stateOf(contact, isLoad, Q) {
    const held = contact.copy(),
        edges = status.orNull(() => held.edges());
    return {
        contact: held,
        isLoad,
        Q,
        left: edges?.left ?? NaN,
        right: edges?.right ?? NaN,
        slipKnown: !edges || Boolean(status.orNull(() => held.slip(Float64Array.of(edges.left, edges.right)))),
    };
}

const between = (from, to, share) =>
    Object.fromEntries(["P", "M", "Q", "sigma"].map((name) => [name, from[name] + (to[name] - from[name]) * share]));

/** The states on the way to a load, but the last. Where one of them has no closed form, there are none: the whole step has. */
export function statesOnTheWay(contact, to, parts) {
    const trial = contact.copy(),
        from = contact.loads(),
        states = [];
    for (let i = 1; i < parts; i++) {
        const { P, M, Q, sigma } = between(from, to, i / parts);
        if (status.of(() => trial.apply(P, M, Q, sigma)) !== statuses.RWEDGE_OK) {
            states.forEach((state) => state.contact.free());
            trial.free();
            return [];
        }
        states.push(stateOf(trial, false, Q));
    }
    trial.free();
    return states;
}

function goThrough(contact, what, loads, cycles, states) {
    for (let cycle = 1; cycle <= cycles; cycle++)
        for (const [row, load] of loads.entries()) {
            const isLast = cycle === cycles,
                before = contact.loads();
            if (isLast && row === 0) states.push(stateOf(contact, false, before.Q));
            if (isLast && (before.P !== load.P || before.M !== load.M))
                states.push(...statesOnTheWay(contact, load, PARTS));
            const fault = applyNext(contact, load, what.f);
            if (fault) return `row ${row + 1}${cycle > 1 ? `, cycle ${cycle}` : ""}: ${fault.text}`;
            if (isLast) states.push(stateOf(contact, true, load.Q));
        }
    return null;
}

/** { what, states, loads, slipKnown, free() } or { complaint }. */
export function lastCycle(what, loads, cycles) {
    const states = [],
        contact = new Contact(what.theta, what.a, what.A, what.f);
    const complaint = goThrough(contact, what, loads, cycles, states);
    contact.free();
    const free = () => states.forEach((state) => state.contact.free());
    if (complaint) {
        free();
        return { complaint };
    }
    return { what, states, loads, slipKnown: states.every((state) => state.slipKnown), free };
}
