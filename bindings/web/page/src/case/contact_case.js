// SPDX-License-Identifier: GPL-3.0-or-later
// One contact and its loads, from texts. It is what cli/contact/contact_case.c is to the tool: a change of one is a change of the other.
import { Contact, rwedge, statuses } from "../library.js";
import { alternatives, inputNames, isGiven, readInput } from "./inputs.js";
import { applyMonotonic, faultOfLoad } from "./loads.js";

const RADIANS_PER_DEGREE = 0.017453292519943295;
export const SQRT_3 = 1.7320508075688772;

/** Where friction counts, it has no default: a guess would look like a result. */
function needsFriction(texts) {
    return ["Q", "sigma", "k", "yield_stress"].some((name) => isGiven(texts, name));
}

/** Complaints about what is missing or there twice, each with the input that it is shown at. */
function incomplete(texts, withLoads) {
    const complaints = [];
    const needed = [
        "E1",
        "nu1",
        "theta",
        "a",
        ...(withLoads ? ["P"] : []),
        ...(needsFriction(texts) || !withLoads ? ["f"] : []),
    ];
    for (const name of needed) {
        const other = alternatives[name];
        if (!isGiven(texts, name) && !(other && isGiven(texts, other)))
            complaints.push({ input: name, text: `${name}${other ? ` or ${other}` : ""} is missing` });
    }
    for (const [one, other] of Object.entries(alternatives))
        if (isGiven(texts, one) && isGiven(texts, other))
            complaints.push({ input: other, text: `${one} and ${other}: give one of the two` });
    const [E2, nu2] = [isGiven(texts, "E2"), isGiven(texts, "nu2")];
    if (E2 !== nu2 && !(E2 && readInput("E2", texts.E2).value === Infinity))
        complaints.push({
            input: E2 ? "nu2" : "E2",
            text: "E2 and nu2: give both, or neither for two bodies of one material",
        });
    return complaints;
}

function fill(value) {
    const { E1, nu1 } = value;
    const E2 = value.E2 ?? E1,
        nu2 = value.nu2 ?? nu1;
    const theta = value.theta ?? value.theta_deg * RADIANS_PER_DEGREE;
    return {
        E1,
        nu1,
        E2,
        nu2,
        theta,
        a: value.a ?? rwedge.rounding(theta, value.radius),
        P: value.P ?? 0,
        M: value.M ?? 0,
        Q: value.Q ?? 0,
        sigma: value.sigma ?? 0,
        f: value.f ?? 0,
        k: value.k ?? (value.yield_stress ?? NaN) / SQRT_3,
        A: rwedge.compliance(E1, nu1, E2, nu2),
        beta: rwedge.dundurs_beta(E1, nu1, E2, nu2),
    };
}

const isNormal = (x) => Number.isFinite(x) && x !== 0;

/** The numbers of a case without its loads' consequences: { what } or { complaints }. */
export function readCase(texts, { withLoads = true } = {}) {
    const complaints = incomplete(texts, withLoads);
    const value = {};
    for (const name of inputNames.filter((name) => isGiven(texts, name))) {
        const read = readInput(name, texts[name]);
        if (read.complaint) complaints.push({ input: name, text: read.complaint });
        else value[name] = read.value;
    }
    if (complaints.length > 0) return { complaints };
    const what = fill(value);
    if (!isNormal(what.A) || !isNormal(what.theta / what.A) || !Number.isFinite(what.a))
        return {
            complaints: [
                { text: "the moduli and the rounding are so large or small that results leave 1e-60 to 1e60" },
            ],
        };
    return { what };
}

/** A contact under the loads of the case: { contact } or { fault }. Whoever asks frees the contact. */
export function loadedContact(what) {
    const contact = new Contact(what.theta, what.a, what.A, what.f);
    const answer = applyMonotonic(contact, what);
    if (answer === statuses.RWEDGE_OK) return { contact };
    const fault = faultOfLoad(answer, contact, what, what.f);
    contact.free();
    return { fault };
}

export function shearRatio({ f, P, Q }) {
    const limit = f * P;
    return Q === 0 || limit === 0 ? 0 : Math.max(-1, Math.min(1, Q / limit));
}
