// SPDX-License-Identifier: GPL-3.0-or-later
// Places along the surface, dense at the edges, and where each measure is worst, also between them. As cli/fretting/surface.c and worst.c.
import { status } from "../library.js";
import { isAngle, measure, measureKinds } from "./measures.js";

const INSIDE = 200,
    OUTSIDE = 40;

/** Ascending, each once but for rounding; the edges of contact and stick zone are among them. Nothing where there is no contact. */
export function usualPlaces({ states, what }) {
    const lefts = states.map((s) => s.left).filter(Number.isFinite),
        rights = states.map((s) => s.right).filter(Number.isFinite);
    if (lefts.length === 0) return null;
    const left = Math.min(...lefts),
        right = Math.max(...rights),
        middle = (left + right) / 2,
        half = (right - left) / 2;
    const all = [...lefts, ...rights];
    for (let i = 1; i < INSIDE; i++) all.push(middle + half * Math.sin(((Math.PI / 2) * (2 * i - INSIDE)) / INSIDE));
    for (let i = 1; i <= OUTSIDE; i++) all.push(left - half * (i / OUTSIDE) ** 2, right + half * (i / OUTSIDE) ** 2);
    for (const state of states) {
        const zone = status.orNull(() => state.contact.stick_zone());
        if (zone) all.push(zone.left, zone.right);
    }
    all.sort((a, b) => a - b);
    const once = all.filter((x, i) => i === 0 || x - all[i - 1] > 1e-12 * half);
    return Float64Array.from(what.a === 0 ? once.filter((x) => x !== 0) : once);
}

/** Another top is worth a search if its place comes so near to the best one. */
const NEARLY = 0.97,
    SEARCHES = 8,
    PARTS = 8,
    ROUNDS = 17;

/** The interval shrinks around its best place: to a quarter in each round. */
function peakBetween(of, name, from, to, start) {
    let best = start;
    for (let round = 0; round < ROUNDS; round++) {
        const step = (to - from) / PARTS,
            x = Float64Array.from({ length: PARTS - 1 }, (_, i) => from + (i + 1) * step);
        measure(of, x)[name].forEach((value, i) => {
            if (value > best.value) best = { x: x[i], value };
        });
        from = Math.max(from, best.x - step);
        to = Math.min(to, best.x + step);
    }
    return best;
}

function worstOf(of, x, values, name) {
    const highest = values.reduce((m, v) => (v > m ? v : m), 0);
    if (!(highest > 0)) return null;
    let best = { x: x[values.indexOf(highest)], value: highest },
        searches = 0;
    for (let i = 0; i < x.length && searches < SEARCHES; i++) {
        const isTop = !(values[i - 1] > values[i]) && !(values[i + 1] > values[i]);
        if (!(values[i] >= NEARLY * highest) || !isTop) continue;
        searches++;
        const top = peakBetween(of, name, x[Math.max(0, i - 1)], x[Math.min(x.length - 1, i + 1)], {
            x: x[i],
            value: values[i],
        });
        if (top.value > best.value) best = top;
    }
    return best;
}

/** By name: { x, value }, or null where the measure is 0 or absent everywhere. */
export function worstPlaces(of, x, measured) {
    return Object.fromEntries(
        measureKinds
            .filter(({ name }) => !isAngle(name))
            .map(({ name }) => [name, worstOf(of, x, measured[name], name)]),
    );
}
