// SPDX-License-Identifier: GPL-3.0-or-later
// What the last cycle does to places of the surface, and where that is worst: the library's answers by the tool's names.
import { rwedge, status } from "../library.js";
import { isAngle, measureKinds } from "../words.js";

const kinds = measureKinds.filter((kind) => !isAngle(kind)).map(({ name }) => name); // in the library's order

const degrees = (angles) => angles.map((v) => (v * 180) / Math.PI);
const nowhere = (n) => new Float64Array(n).fill(NaN);
const kOverSy = ({ k }) => (Number.isNaN(k) ? 0 : 1 / (Math.sqrt(3) * k));

function stresses({ before, lists }, x) {
    const going = before.copy();
    try {
        return going.stress_history(...lists, x, new Float64Array(x.length));
    } finally {
        going.free();
    }
}

function fatigue(of, x) {
    const { E1, nu1, k } = of.setup,
        { sxx, syy, txy } = stresses(of, x),
        criterion = (kind, constant) =>
            rwedge.criterion_field(kind, of.loads.length, sxx, syy, txy, E1, nu1, 0, constant, 1),
        swt = criterion(1, 0),
        fs = Number.isNaN(k) ? null : criterion(2, kOverSy(of.setup));
    return {
        stress_range: criterion(0, 0).value,
        swt: swt.value,
        swt_angle: degrees(swt.angle),
        fatemi_socie: fs?.value ?? nowhere(x.length),
        fs_angle: fs ? degrees(fs.angle) : nowhere(x.length),
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
    const constants = [setup.E1, setup.nu1, 0, kOverSy(setup), 1];
    const worst = status.orNull(() => before.cycle_worst(kind, ...lists, x, known, 0, ...constants));
    return worst && { x: worst.worst_x, value: worst.worst_value };
}

/** By name: { x, value }, or null where the measure is 0 or absent everywhere. */
export const worstPlaces = (of, x, measured) =>
    Object.fromEntries(kinds.map((name, kind) => [name, worstOf(of, x, measured[name], kind)]));
