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

const ROUNDING = 1e-12; // of an edge, in widths of the contact
const clamped = ({ left, right }, x) => Math.min(Math.max(x, left), right);

/** An edge of one load may lie outside the contact of another by a rounding. */
function isInside({ left, right }, x) {
    const rounding = ROUNDING * (right - left);
    return x >= left - rounding && x <= right + rounding;
}

/** Slip may jump at an edge. A place within a rounding of an edge is moved inwards, so that all states see it on the same side. */
function offTheEdges(states, x) {
    let inside = x;
    for (const { left, right } of states) {
        const margin = 4 * ROUNDING * (right - left);
        if (Math.abs(x - left) <= margin) inside = Math.max(inside, left + margin);
        if (Math.abs(x - right) <= margin) inside = Math.min(inside, right - margin);
    }
    return inside;
}

/** NaN outside the contact. */
const slipAt = (state, x) => (isInside(state, x) ? state.contact.slip(Float64Array.of(clamped(state, x)))[0] : NaN);

/** p, q and slip of the places x that touch in a state; `inside` are the same places, off the edges. */
function touching(state, x, inside) {
    const at = [...x.keys()].filter((i) => isInside(state, inside[i])),
        found = { p: nowhere(x.length), q: nowhere(x.length), slip: nowhere(x.length) };
    if (at.length === 0) return found;
    const of = (places) => Float64Array.from(at, (i) => clamped(state, places[i]));
    const { p, q } = state.contact.tractions(of(x)),
        slip = state.contact.slip(of(inside));
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

/**
 * The place slips until the edge passes it. How much it slips is interpolated: at the edge's new position the change of slip is known,
 * at its old position it is 0. The change is taken, not the slip: slip jumps at the border of what the contact has never left.
 */
function leave(states, at, x, to) {
    const [before, after] = [states[to - 1], states[to]];
    const [start, end] = x < after.left ? [before.left, after.left] : [before.right, after.right];
    const near = offTheEdges(states, end),
        change = slipAt(after, near) - slipAt(before, near);
    if (!Number.isNaN(change)) slipTo(at, at.slip + (change * (x - start)) / (end - start), 0);
    at.touches = false;
}

function rubThrough({ what, states }, x, i, found) {
    let at = { touches: false, slip: 0, limit: 0, most: -Infinity, least: Infinity, shear: 0, energy: 0 };
    found.forEach(({ p, q, slip }, s) => {
        if (Number.isNaN(slip[i])) {
            if (at.touches) leave(states, at, x, s);
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
    const inside = x.map((v) => offTheEdges(of.states, v)),
        found = of.states.map((state) => touching(state, x, inside)),
        all = nothingSlips(x.length);
    inside.forEach((v, i) => {
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
