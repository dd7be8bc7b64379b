// SPDX-License-Identifier: GPL-3.0-or-later
// The loop of a cycle of loads: of the whole contact where P is constant and there is no moment or tension, else of one place.
import { orNull } from "./library.js";

const STATES = 240,
    STEPS_MAX = 24; // from one load to the next

const isCentred = ({ P }, loads, f) =>
    f > 0 && P > 0 && loads.every((to) => to.P === P && to.M === 0 && to.sigma === 0);

const isApplied = (contact, loads) => orNull(() => contact.apply(...loads)) !== null;

/** From one load to the next, in steps as far as they can be had. */
function goThrough(loads, contact, note) {
    const steps = Math.max(1, Math.min(STEPS_MAX, Math.round(STATES / loads.length)));
    note();
    for (const to of loads.map(Object.values)) {
        const from = Object.values(contact.loads());
        const between = (i) => to.map((end, k) => from[k] + ((end - from[k]) * i) / steps);
        for (let i = 1; i < steps && isApplied(contact, between(i)); i++) note();
        isApplied(contact, to);
        note();
    }
}

/**
 * { isWhole, place, x, y }: tangential load over displacement by slip, which encloses the energy of the cycle; or the shear traction of
 * a place over its slip, as long as it touches. Nothing where no slip is known. The contact, that before the cycle, goes through it.
 */
export function loopOf(contact, { loads, slipKnown, setup, worst }) {
    const isWhole = isCentred(contact.loads(), loads, setup.f),
        place = worst.energy_per_area?.x,
        width = contact.half_width(),
        points = [];
    if (!isWhole && !(slipKnown && place !== undefined)) return undefined;
    const ofWhole = () => [contact.displacement(width), contact.loads().Q];
    const ofPlace = () => orNull(() => [contact.slip(place), contact.tractions(place).q]);
    goThrough(loads, contact, () => points.push(isWhole ? ofWhole() : ofPlace()));
    const [x, y] = [0, 1].map((k) => points.filter(Boolean).map((point) => point[k]));
    return { isWhole, place, x, y };
}
