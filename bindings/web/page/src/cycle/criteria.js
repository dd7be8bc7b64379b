// SPDX-License-Identifier: GPL-3.0-or-later
// Criteria of fatigue and a material's constants, as "rwedge fretting --material" has them: names, what is allowed, the life.
import { numberOf, rwedge } from "../library.js";
import { withPoint } from "../number.js";

/** measure: its number in the library; needs: constants, the first of which is the criterion's own; limit: what it must not exceed. */
export const criteria = {
    swt: { title: "Smith\u2013Watson\u2013Topper", measure: 1, unit: "stress", needs: [], limit: "swt_limit" },
    fatemi_socie: { title: "Fatemi\u2013Socie", measure: 2, unit: "none", needs: [], limit: "fs_limit" },
    findley: { title: "Findley", measure: 7, unit: "stress", needs: ["findley_k"], limit: "findley_limit" },
    modified_wohler: {
        title: "modified W\u00f6hler curve",
        measure: 8,
        unit: "stress",
        needs: ["kappa"],
        limit: "lambda",
    },
    mcdiarmid: { title: "McDiarmid", measure: 9, unit: "none", needs: ["t_A", "su"] },
    crossland: {
        title: "Crossland",
        measure: 10,
        unit: "stress",
        needs: ["crossland_alpha"],
        limit: "crossland_limit",
    },
    dang_van: { title: "Dang Van", measure: 11, unit: "stress", needs: ["dang_van_alpha"], limit: "dang_van_limit" },
};

const lives = { swt: ["sf", "b", "ef", "c"], fatemi_socie: ["G", "tf", "b0", "gf", "c0"] };
const remarks = ["name", "source"],
    ofForm = ["E", "nu", "yield_stress"],
    ofLength = ["dK_th", "ds0"];
const known = new Set([
    "fs_k",
    ...Object.values(criteria).flatMap(({ needs, limit }) => [...needs, limit]),
    ...Object.values(lives).flat(),
    ...ofForm,
    ...ofLength,
]);

/** A name and the rest of its line. */
const linesOf = (text) =>
    [...text.matchAll(/^\s*([^\s,;=:]+)[^\S\r\n]*[,;=:\t ]?[^\S\r\n]*(.*?)\s*$/gm)].map(([, name, rest]) => [
        name,
        rest,
    ]);

function entriesOf(text) {
    if (!text.trim().startsWith("{")) return linesOf(text);
    return Object.entries(JSON.parse(text)).map(([name, value]) => [name, String(value)]);
}

/** { constants: numbers by name } or { complaint }. The text is a material file: JSON, or a name and a number a line. */
export function readMaterial(text, sign) {
    const constants = {};
    try {
        for (const [name, value] of entriesOf(text).filter(([name]) => !remarks.includes(name))) {
            const number = numberOf(withPoint(value, sign));
            if (!known.has(name)) return { complaint: `${name}: no constant that is known here` };
            if (Number.isNaN(number)) return { complaint: `${name}: must be a number` };
            constants[name] = number;
        }
    } catch (error) {
        return { complaint: `the material: ${error.message}` };
    }
    return { constants };
}

/** What is missing for a criterion, in words; empty where all is there. */
export function missing(name, constants, k) {
    const { title, needs } = criteria[name],
        lacking = needs.filter((need) => !(need in constants));
    if (name === "fatemi_socie" && Number.isNaN(k)) return `${title} needs a yield stress`;
    return lacking.length > 0 ? `${title} needs ${lacking.join(" and ")} of the material` : "";
}

/** The library's constant and su. */
export const constantsOf = (name, { fs_k = 1, su = 1, ...constants }, k) => [
    name === "fatemi_socie" ? fs_k / (Math.sqrt(3) * k) : (constants[criteria[name].needs[0]] ?? 0),
    su,
];

/** What it must not exceed; undefined where that is not given. */
export const allowable = (name, constants) => (name === "mcdiarmid" ? 1 : constants[criteria[name].limit]);

/** The cycles to failure at a value; undefined where the constants are not given. */
export function lifeAt(name, value, E, constants) {
    const values = (lives[name] ?? []).map((each) => constants[each]),
        limit = allowable(name, constants) ?? 0;
    if (values.length === 0 || values.includes(undefined)) return undefined;
    return name === "swt"
        ? rwedge.smith_watson_topper_life(value, E, ...values, limit)
        : rwedge.fatemi_socie_life(value, ...values, limit);
}
