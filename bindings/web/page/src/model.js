// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn: the solved case, how it is written, and in which units.
import { textsOfPad } from "./pads.js";
import { solveHolding } from "./answers/solution.js";
import { written } from "./state.js";
import { unitSystems } from "./units.js";

let solved; // the last model with results

/** pictured: the model itself, or where it has no results the last one that had: its pictures stay, greyed. */
export function makeModel(state) {
    const { unit } = unitSystems[state.units],
        texts = textsOfPad(state.texts, state.pad);
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

/** "x / mm"; the name alone where the unit is nothing. */
export const withUnit = (name, unit) => (unit ? `${name} / ${unit}` : name);
