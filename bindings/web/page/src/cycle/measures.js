// SPDX-License-Identifier: GPL-3.0-or-later
// What the last cycle does to places of the surface, and where that is worst: the library's answers by the tool's names.
import { status } from "../library.js";
import { isAngle, measureKinds } from "../words.js";

const kinds = measureKinds.filter((kind) => !isAngle(kind)).map(({ name }) => name); // in the library's order

const degrees = (angles) => angles.map((v) => (v * 180) / Math.PI);
const nowhere = (n) => new Float64Array(n).fill(NaN);
const material = ({ E1, nu1, k }) => [E1, nu1, Number.isNaN(k) ? 0 : 1 / (Math.sqrt(3) * k)];

function fatigue({ setup, before, lists }, x) {
    const s = before.cycle_fatigue(...lists, x, new Float64Array(x.length), ...material(setup));
    const strength = !Number.isNaN(setup.k);
    return {
        stress_range: s.stress_range,
        swt: s.swt,
        swt_angle: degrees(s.swt_angle),
        fatemi_socie: strength ? s.fatemi_socie : nowhere(x.length),
        fs_angle: strength ? degrees(s.fs_angle) : nowhere(x.length),
    };
}

/** NaN where there is no contact, and where the slip has no closed form. */
function friction({ before, lists, edges, slipKnown }, x) {
    const left = Math.min(...edges),
        right = Math.max(...edges),
        rounding = 1e-12 * (right - left);
    const s = slipKnown ? before.cycle_friction(...lists, x) : null;
    const inContact = (values) =>
        x.map((v, i) => (s && v >= left - rounding && v <= right + rounding ? values[i] : NaN));
    return {
        slip_range: inContact(s?.slip_range),
        ruiz_f1: inContact(s?.ruiz_f1),
        ruiz_f2: inContact(s?.ruiz_f2),
        energy_per_area: inContact(s?.energy),
    };
}

/** All measures at places x of the surface, by name. The apex of a sharp wedge is none of the places. */
export const measure = (of, x) => ({ ...fatigue(of, x), ...friction(of, x) });

function worstOf({ setup, before, lists }, x, values, kind) {
    const known = values.map((v) => v || 0); // NaN too
    if (!known.some((v) => v > 0)) return null;
    const worst = status.orNull(() => before.cycle_worst(kind, ...lists, x, known, 0, ...material(setup)));
    return worst && { x: worst.worst_x, value: worst.worst_value };
}

/** By name: { x, value }, or null where the measure is 0 or absent everywhere. */
export const worstPlaces = (of, x, measured) =>
    Object.fromEntries(kinds.map((name, kind) => [name, worstOf(of, x, measured[name], kind)]));
