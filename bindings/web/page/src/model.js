// SPDX-License-Identifier: GPL-3.0-or-later
// The case as it stands: from texts to a contact under its loads, results and verdict. One at a time: the one before is freed.
import { loadedContact, readCase } from "./case/contact_case.js";
import { hardestPlace, solve } from "./case/results.js";
import { verdict } from "./case/status.js";
import { unitSystems } from "./units.js";
import { writeNumber } from "./number.js";

let held = null;

function answer(texts) {
    const { what, complaints } = readCase(texts);
    if (complaints) return { complaints };
    const { contact, fault } = loadedContact(what);
    if (fault) return { what, fault };
    held = contact;
    try {
        const hardest = hardestPlace(what, contact);
        return {
            what,
            contact,
            hardest,
            results: solve(what, contact, Number.isNaN(what.k) ? null : (hardest?.factor ?? 0)),
        };
    } catch (error) {
        return { what, fault: { text: error.message } };
    }
}

/** { what, contact, hardest, results } where there are any; faults for the fields, verdict, unit by dimension, write(value). */
export function makeModel(state) {
    held?.free();
    held = null;
    const found = answer(state.texts);
    return {
        ...found,
        texts: state.texts,
        faults: found.complaints ?? (found.fault ? [found.fault] : []),
        verdict: verdict(found),
        unit: unitSystems[state.units].unit,
        write: (value) => (typeof value === "number" ? writeNumber(value, state.digits, state.sign) : (value ?? "")),
    };
}

/** "x / mm"; the name alone where the unit is nothing. */
export const withUnit = (name, unit) => (unit ? `${name} / ${unit}` : name);
