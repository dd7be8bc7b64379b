// SPDX-License-Identifier: GPL-3.0-or-later
// What the last cycle does to places of the surface, and where that is worst: the library's answers by the tool's names.
import { rwedge, status } from "../library.js";
import { isAngle, measureKinds } from "../words.js";
import { constantsOf, criteria } from "./criteria.js";

const kinds = measureKinds.filter((kind) => !isAngle(kind)).map(({ name }) => name); // in the library's order

const degrees = (angles) => angles.map((v) => (v * 180) / Math.PI);
const nowhere = (n) => new Float64Array(n).fill(NaN);

function stresses({ before, lists }, x) {
    const going = before.copy();
    try {
        return going.stress_history(...lists, x, new Float64Array(x.length));
    } finally {
        going.free();
    }
}

/** E, nu, plane stress, and the constants of a criterion. */
const settingsOf = ({ setup, criterion }, name) => [
    setup.E1,
    criterion.nu,
    Number(criterion.isPlaneStress),
    ...(name in criteria ? constantsOf(name, criterion.constants, setup.k) : [0, 1]),
];

function fatigue(cycle, x) {
    const { sxx, syy, txy } = stresses(cycle, x),
        { name: chosen } = cycle.criterion,
        along = (name, measure) =>
            rwedge.criterion_field(measure, cycle.loads.length, sxx, syy, txy, ...settingsOf(cycle, name)),
        none = { value: nowhere(x.length), angle: nowhere(x.length) },
        swt = along("swt", 1),
        fs = Number.isNaN(cycle.setup.k) ? none : along("fatemi_socie", 2);
    return {
        stress_range: along("stress_range", 0).value,
        swt: swt.value,
        swt_angle: degrees(swt.angle),
        fatemi_socie: fs.value,
        fs_angle: degrees(fs.angle),
        ...(chosen === "swt" || chosen === "fatemi_socie"
            ? {}
            : { [chosen]: along(chosen, criteria[chosen].measure).value }),
    };
}

/** NaN where there is no contact, and where no slip is known. */
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
export const measure = (cycle, x) => ({ ...fatigue(cycle, x), ...friction(cycle, x) });

function worstOf(cycle, x, values, name, kind) {
    const known = values.map((v) => Math.max(v, 0) || 0); // NaN too
    if (!known.some((v) => v > 0)) return null;
    const worst = status.orNull(() =>
        cycle.before.cycle_worst(kind, ...cycle.lists, x, known, 0, ...settingsOf(cycle, name)),
    );
    return worst && { x: worst.worst_x, value: worst.worst_value };
}

/** By name: { x, value }, or null where the measure is 0 or absent everywhere. */
export const worstPlaces = (cycle, x, measured) =>
    Object.fromEntries(
        [...new Set([...kinds, cycle.criterion.name])].map((name, kind) => [
            name,
            worstOf(cycle, x, measured[name], name, criteria[name]?.measure ?? kind),
        ]),
    );
