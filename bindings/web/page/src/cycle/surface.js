// SPDX-License-Identifier: GPL-3.0-or-later
// Places along the surface, dense at the edges. As cli/fretting/surface.c.
import { kinksOf } from "../pads.js";

const INSIDE = 200,
    OUTSIDE = 40,
    EDGES = 200;

/** Ascending, each once but for the distance. */
function thinned(places, distance) {
    const kept = [];
    for (const x of [...places].sort((a, b) => a - b))
        if (kept.length === 0 || x - kept[kept.length - 1] > distance) kept.push(x);
    return kept;
}

/** The edges of contact and stick zone are among them; of many that are close together one. Nothing where there is no contact. */
export function usualPlaces({ edges, setup }) {
    if (edges.length === 0) return null;
    const left = Math.min(...edges),
        right = Math.max(...edges),
        middle = (left + right) / 2,
        half = (right - left) / 2;
    let all = thinned(edges, 2e-12 * half);
    if (all.length > EDGES) all = thinned(all, (2 * half) / EDGES);
    for (let i = 1; i < INSIDE; i++) all.push(middle + half * Math.sin(((Math.PI / 2) * (2 * i - INSIDE)) / INSIDE));
    for (let i = 1; i <= OUTSIDE; i++) all.push(left - half * (i / OUTSIDE) ** 2, right + half * (i / OUTSIDE) ** 2);
    const kinks = kinksOf(setup);
    return Float64Array.from(thinned(all, 1e-12 * half).filter((x) => !kinks.includes(x)));
}
