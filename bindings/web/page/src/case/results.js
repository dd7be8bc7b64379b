// SPDX-License-Identifier: GPL-3.0-or-later
// What "rwedge solve" answers about one contact, by its names: as cli/solve/results.c and present_state.c.
import { rwedge, status } from "../library.js";
import { words } from "words";
import { shearRatio, SQRT_3 } from "./contact_case.js";

export const resultKinds = words.results;
const WIDTH_MOST = 1e14; // the library looks for first yield up to this b/a

function geometry(what, b, r) {
    const alpha = what.a / b,
        unit = what.theta / what.A;
    Object.assign(r, {
        A: what.A,
        dundurs_beta: what.beta,
        a: what.a,
        radius: rwedge.radius(what.theta, what.a),
        b,
        a_over_b: alpha,
        AP_over_theta_b: rwedge.load(alpha),
        p0: unit * rwedge.peak_pressure(alpha),
        p_transition: unit * rwedge.transition_pressure(alpha),
        left: -b,
        right: b,
        tilt: 0,
    });
}

/** Without friction there is neither stick nor slip to speak of. */
function friction(what, b, r) {
    const alpha = what.a / b,
        ratio = shearRatio(what),
        rough = what.f > 0;
    const c = rwedge.stick_width(alpha, Math.abs(ratio));
    const sxx = ratio === 0 ? 0 : rwedge.stress(alpha, what.f, c, -1, 0).sxx;
    r.max_tension = (what.theta / what.A) * sxx;
    r.max_tension_sliding = ((what.f * what.P) / b) * rwedge.max_tension(alpha);
    if (!rough) return;
    Object.assign(r, { Q_over_fP: ratio, c: c * b, c_over_b: c });
    if (c > 0) Object.assign(r, { stick_left: -c * b, stick_right: c * b });
}

/** Where it yields once P has grown to P_yield: the contact grows on the way. Q < 0 is the mirror image. */
function yieldPlace(what, P_yield, r) {
    const b = rwedge.half_width(what.theta, what.a, what.A, P_yield);
    const place = rwedge.yield_point(b > 0 ? what.a / b : 0, what.f, what.nu1);
    r.yield_x = (what.Q < 0 ? -place.x : place.x) * b;
    r.yield_y = place.y * b;
    r.yield_branch = place.y > 0 ? "subsurface" : "surface";
}

function strength(what, b, r) {
    const alpha = what.a / b;
    const limit = rwedge.elastic_limit(alpha, what.f, what.nu1);
    r.von_mises_sliding = (SQRT_3 * what.P) / b / limit;
    if (alpha > 0) r.f_critical = rwedge.critical_friction(alpha, what.nu1);
    r.P_over_bk = limit;
    if (Number.isNaN(what.k)) return;
    r.P_yield = rwedge.yield_load(what.theta, what.a, what.A, what.f, what.nu1, what.k);
    if (Number.isNaN(r.P_yield)) throw new Error("P_yield: a result leaves 1e-60 to 1e60");
    r.load_over_bk = what.P / b / what.k;
    r.safety = r.P_yield / what.P;
    if (Number.isFinite(r.P_yield)) yieldPlace(what, r.P_yield, r);
}

/** The pressure's top and its values at x = -a and a have no closed form under a moment. */
function offCentre(what, contact, r) {
    const b = contact.half_width(),
        edges = contact.edges();
    if (what.M !== 0)
        Object.assign(r, {
            b,
            a_over_b: what.a / b,
            AP_over_theta_b: (what.A * what.P) / (what.theta * b),
            p0: null,
            p_transition: null,
        });
    Object.assign(r, { left: edges.left, right: edges.right, tilt: contact.tilt() });
    const sxx = contact.stresses(Float64Array.of(edges.left, edges.right), Float64Array.of(0, 0)).sxx;
    if (!Number.isNaN(what.k)) r.load_over_bk = what.P / b / what.k;
    r.max_tension = Math.max(sxx[0], sxx[1]); // the larger of the two edges' is that of the trailing edge
    if (what.f === 0) return;
    const c = contact.stick_half_width();
    Object.assign(r, { Q_over_fP: shearRatio(what), c, c_over_b: c / b });
    const zone = status.orNull(() => contact.stick_zone());
    if (zone) Object.assign(r, { stick_left: zone.left, stick_right: zone.right });
}

function doubtTexts(doubts) {
    const texts = [];
    for (let bit = 1; rwedge.validity_text(bit) !== ""; bit *= 2)
        if (doubts & bit) texts.push(rwedge.validity_text(bit));
    return texts;
}

function boundSafety(what, r, warnings) {
    const most = rwedge.normal_load(what.theta, what.a, what.A, WIDTH_MOST * what.a);
    if (Number.isFinite(most)) r.safety = `> 1e${Math.floor(Math.log10(most / what.P))}`;
    warnings.push("nothing yields before the contact is 1e14 a wide: safety is a bound");
}

/** Whether there is a moment or a tension: what holds only without them is then empty. */
export const isOffCentre = (what) => what.M !== 0 || what.sigma !== 0;

/** Where the von Mises stress is largest under the present loads, and k over it: any k gives the place. Null where it is infinite. */
export function hardestPlace(what, contact) {
    const k = Number.isNaN(what.k) ? what.theta / what.A : what.k;
    const found = status.orNull(() => contact.yield_factor(what.nu1, k));
    return found && found.factor > 0 ? { ...found, von_mises: (SQRT_3 * k) / found.factor } : null;
}

/**
 * All results by name; null where the case does not have one, or the yield factor is not given.
 * Throws, with the reason, where one cannot be computed.
 */
export function solve(what, contact, yieldFactor = null) {
    const r = Object.fromEntries(resultKinds.map(({ name }) => [name, null]));
    const b = rwedge.half_width(what.theta, what.a, what.A, what.P);
    if (!(b > 0) || !Number.isFinite(what.a / b))
        throw new Error("b: so large or small that results leave 1e-60 to 1e60");
    geometry(what, b, r);
    if (isOffCentre(what)) offCentre(what, contact, r);
    else {
        friction(what, b, r);
        strength(what, b, r);
    }
    r.yield_factor = yieldFactor;
    const warnings = doubtTexts(
        rwedge.validity(what.theta, what.a / r.b, what.beta, what.f, what.k / what.E1, r.safety ?? NaN),
    );
    if (r.safety === Infinity) boundSafety(what, r, warnings);
    r.warnings = warnings.join("; ");
    return r;
}

/** The factor by which the yield stress may fall, as in the workbook. */
export const safetyOnStrength = (r) => (r.load_over_bk && r.P_over_bk !== null ? r.P_over_bk / r.load_over_bk : null);
