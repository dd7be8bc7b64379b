// SPDX-License-Identifier: GPL-3.0-or-later
// The last cycle of a course of loads: the contact after each load, and on the way where P or M change. As cli/fretting/last_cycle.c.
import { status, statuses } from "../library.js";

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

/** { setup, states, loads, slipKnown, free() }: of a contact before the cycle, which is changed; the loads have been tried. */
export function lastCycle(setup, loads, contact) {
    const states = [stateOf(contact, false, contact.loads().Q)];
    for (const load of loads) {
        const before = contact.loads();
        if (before.P !== load.P || before.M !== load.M) states.push(...statesOnTheWay(contact, load, PARTS));
        contact.apply(load.P, load.M, load.Q, load.sigma);
        states.push(stateOf(contact, true, load.Q));
    }
    const free = () => states.forEach((state) => state.contact.free());
    return { setup, states, loads, slipKnown: states.every((state) => state.slipKnown), free };
}
