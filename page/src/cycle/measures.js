// SPDX-License-Identifier: GPL-3.0-or-later
// What the last cycle does to places of the surface: critical planes, slip, energy. As cli/fretting/last_cycle.c.
import { rwedge } from "../library.js";
import { SQRT_3 } from "../case/contact_case.js";
import { words } from "words";

export const measureKinds = words.measures;
export const isAngle = (name) => name.endsWith("_angle");

const nowhere = (n) => new Float64Array(n).fill(NaN);
const nothingSlips = (n) =>
    Object.fromEntries(["slip_range", "ruiz_f1", "ruiz_f2", "energy_per_area"].map((name) => [name, nowhere(n)]));

/** The stresses after each load: loads * n numbers each, row by row. */
function stresses({ states }, x) {
    const loaded = states.filter((state) => state.isLoad),
        n = x.length,
        y = new Float64Array(n);
    const all = {
        sxx: new Float64Array(loaded.length * n),
        syy: new Float64Array(loaded.length * n),
        txy: new Float64Array(loaded.length * n),
    };
    loaded.forEach((state, i) => {
        const found = state.contact.stresses(x, y);
        for (const name of ["sxx", "syy", "txy"]) all[name].set(found[name], i * n);
    });
    return { ...all, loads: loaded.length };
}

/** The largest value of each place over the loads. */
function most(values, loads, n, sign) {
    const found = new Float64Array(n).fill(-Infinity);
    for (let i = 0; i < loads * n; i++) found[i % n] = Math.max(found[i % n], sign * values[i]);
    return found.map((v) => sign * v);
}

const degrees = (angles) => angles.map((v) => (v * 180) / Math.PI);

function criticalPlanes({ what }, s, n) {
    const swt = rwedge.smith_watson_topper_field(s.loads, s.sxx, s.syy, s.txy, what.E1, what.nu1);
    const largest = most(s.sxx, s.loads, n, 1),
        smallest = most(s.sxx, s.loads, n, -1);
    const socie = Number.isNaN(what.k)
        ? { value: nowhere(n), angle: nowhere(n) }
        : rwedge.fatemi_socie_field(s.loads, s.sxx, s.syy, s.txy, what.E1, what.nu1, 1 / (SQRT_3 * what.k));
    return {
        stress_range: largest.map((v, i) => v - smallest[i]),
        swt: swt.value,
        swt_angle: degrees(swt.angle),
        fatemi_socie: socie.value,
        fs_angle: degrees(socie.angle),
        tension: largest,
    };
}

/** Where x is inside of the contact of a state; an edge may lie outside by a rounding. NaN where it is not. */
function inside({ left, right }, x) {
    const rounding = 1e-12 * (right - left);
    return x >= left - rounding && x <= right + rounding ? Math.min(Math.max(x, left), right) : NaN;
}

/** p, q and slip of the places that touch in a state. */
function touching(state, x) {
    const at = [],
        places = [];
    x.forEach((v, i) => {
        const place = inside(state, v);
        if (!Number.isNaN(place)) (at.push(i), places.push(place));
    });
    const found = { p: nowhere(x.length), q: nowhere(x.length), slip: nowhere(x.length) };
    if (at.length === 0) return found;
    const { p, q } = state.contact.tractions(Float64Array.from(places)),
        slip = state.contact.slip(Float64Array.from(places));
    at.forEach((i, k) => ([found.p[i], found.q[i], found.slip[i]] = [p[k], q[k], slip[k]]));
    return found;
}

/** Where a place slips, its shear is f |p| all the way from one state to the next; p is taken to change in proportion to the slip. */
function slipTo(at, slip, limit) {
    at.energy += ((at.limit + limit) / 2) * Math.abs(slip - at.slip);
    at.most = Math.max(at.most, slip);
    at.least = Math.min(at.least, slip);
    at.slip = slip;
    at.limit = limit;
}

/** It slips until the edge comes by; the edge's own slip tells how far. */
function leave(at, x, from, to) {
    const [edge, slip] =
        x < to.left
            ? [
                  [from.left, to.left],
                  [from.slipLeft, to.slipLeft],
              ]
            : [
                  [from.right, to.right],
                  [from.slipRight, to.slipRight],
              ];
    if (!Number.isNaN(to.left)) slipTo(at, slip[0] + ((slip[1] - slip[0]) * (x - edge[0])) / (edge[1] - edge[0]), 0);
    at.touches = false;
}

function rubThrough({ what, states }, x, i, found) {
    let at = { touches: false, slip: 0, limit: 0, most: -Infinity, least: Infinity, shear: 0, energy: 0 };
    states.forEach((state, s) => {
        const { p, q, slip } = found[s];
        if (Number.isNaN(slip[i])) {
            if (at.touches) leave(at, x, states[s - 1], state);
            return;
        }
        if (!at.touches) Object.assign(at, { touches: true, slip: 0, limit: 0 });
        slipTo(at, slip[i], what.f * Math.abs(p[i]));
        at.shear = Math.max(at.shear, Math.abs(q[i]));
        if (s === 0) Object.assign(at, { most: slip[i], least: slip[i], energy: 0 }); // the cycle begins here
    });
    return at;
}

function friction(of, x, tension) {
    const found = of.states.map((state) => touching(state, x)),
        all = nothingSlips(x.length);
    x.forEach((v, i) => {
        const at = rubThrough(of, v, i, found);
        if (at.most < at.least) return;
        const range = at.most - at.least;
        all.slip_range[i] = range;
        all.ruiz_f1[i] = at.shear * range;
        all.ruiz_f2[i] = Math.max(tension[i], 0) * at.shear * range;
        all.energy_per_area[i] = at.energy;
    });
    return all;
}

/** All measures at places x of the surface, by name; NaN where there is none. The apex of a sharp wedge is none of the places. */
export function measure(of, x) {
    const planes = criticalPlanes(of, stresses(of, x), x.length);
    return { ...planes, ...(of.slipKnown ? friction(of, x, planes.tension) : nothingSlips(x.length)) };
}
