// SPDX-License-Identifier: GPL-3.0-or-later
// The loop of a cycle of loads: of a rig that prescribes displacements; of the whole contact where P is constant and there is no moment
// or tension; else of one place.
import { orNull } from "./library.js";

const STATES = 240,
    STEPS_MAX = 24; // from one load to the next

const isCentred = ({ P }, loads, f) =>
    f > 0 && P > 0 && loads.every((to) => to.P === P && to.M === 0 && to.sigma === 0);

/** The loads of a rig, which goes on from where it was at the end of the cycle before. */
function driveThrough({ loads, displacements, compliance }, contact) {
    const points = [],
        steps = Math.max(1, Math.min(STEPS_MAX, Math.round(STATES / loads.length)));
    loads.forEach(({ P, M, sigma }, k) => {
        const from = contact.loads(),
            start = displacements.at(k - 1),
            isFirst = from.P === 0;
        for (let i = isFirst ? steps : 1; i <= steps; i++) {
            const between = (a, b) => (i === steps ? b : a + ((b - a) * i) / steps),
                there = between(start, displacements[k]);
            const Q = orNull(() => contact.drive(between(from.P, P), between(from.M, M), between(from.sigma, sigma), there, compliance));
            if (Q !== null) points.push([there, Q]);
        }
    });
    return points;
}

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
 * { isDriven, isWhole, place, x, y }: tangential load over the displacement of the rig, or over that by slip, which encloses the energy
 * of the cycle; or the shear traction of a place over its slip, as long as it touches. Nothing where no slip is known. The contact, that before the cycle, goes through it.
 */
export function loopOf(contact, { loads, displacements, compliance, slipKnown, setup, worst }) {
    const columnsOf = (points) => [0, 1].map((k) => points.filter(Boolean).map((point) => point[k]));
    if (displacements) {
        const [x, y] = columnsOf(driveThrough({ loads, displacements, compliance }, contact));
        return { isDriven: true, isWhole: true, x, y };
    }
    const isWhole = isCentred(contact.loads(), loads, setup.f),
        place = worst.energy_per_area?.x,
        width = contact.half_width(),
        points = [];
    if (!isWhole && !(slipKnown && place !== undefined)) return undefined;
    const ofWhole = () => [contact.displacement(width), contact.loads().Q];
    const ofPlace = () => orNull(() => [contact.slip(place), contact.tractions(place).q]);
    goThrough(loads, contact, () => points.push(isWhole ? ofWhole() : ofPlace()));
    const [x, y] = columnsOf(points);
    return { isWhole, place, x, y };
}
