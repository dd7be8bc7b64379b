// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn: the solved case, how it is written, and in which units.
import { textsOfPad } from "./pads.js";
import { solveHolding } from "./answers/solution.js";
import { inputs } from "./answers/words.js";
import { wholeNumber } from "./number.js";
import { written } from "./state.js";
import { unitSystems, wordsOf } from "./units.js";

let solved; // the last model with results

/** What the model is told beside the inputs. */
function otherTexts({ texts, units, width, section, plane, body, rotation: chosen }) {
    const rotation = texts.E2 ? chosen : ""; // of two materials alone
    const all = {
        units: wordsOf(units),
        width: width.trim(),
        section: section.trim(),
        plane_stress: plane,
        strength_of: body,
        rotation: rotation === "similar" ? "" : rotation,
        similar: rotation === "similar" ? "yes" : "",
    };
    return Object.fromEntries(Object.entries(all).filter(([, text]) => text !== ""));
}

/** pictured: the model itself, or where it has no results the last one that had: its pictures stay, greyed. */
export function makeModel(state) {
    const { unit } = unitSystems[state.units],
        texts = { ...textsOfPad(state.texts, state.pad), ...otherTexts(state) };
    const model = {
        ...solveHolding(texts, state.sign, unit.length),
        texts,
        pad: state.pad,
        unit,
        write: (value) => (typeof value === "number" ? written(value, Number(state.digits)) : (value ?? "")),
    };
    if (model.results) solved = model;
    return Object.assign(model, { pictured: solved ?? model });
}

/** The inputs of a case as texts, with their units. */
export const inputTexts = ({ inputs: numbers, texts, unit }) => [
    ...Object.entries(numbers).map(([name, value]) =>
        name === "profile" ? `profile of ${value} places` : `${name} = ${wholeNumber(value)} ${unit[inputs[name].unit]}`.trim(),
    ),
    ...(texts.plane_stress ? ["plane stress"] : []),
    ...(texts.rotation ? [`the pad is ${texts.rotation}`] : []),
    ...(texts.similar ? ["friction leaves the pressure of unlike bodies"] : []),
    ...(texts.strength_of ? ["strength and stresses of the pad, body 2"] : []),
];

/** "x / mm"; the name alone where the unit is nothing. */
export const withUnit = (name, unit) => (unit ? `${name} / ${unit}` : name);
