// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn: the solved case, how it is written, and in which units.
import { shown, writeNumber } from "./number.js";
import { textsOfPad } from "./pads.js";
import { solveHolding } from "./answers/solution.js";
import { unitSystems } from "./units.js";

export function makeModel(state) {
    Object.assign(shown, { sign: state.sign, name: state.name });
    const { unit } = unitSystems[state.units],
        texts = textsOfPad(state.texts, state.pad);
    return {
        ...solveHolding(texts, state.sign, unit.length),
        texts,
        pad: state.pad,
        unit,
        sign: state.sign,
        write: (value) =>
            typeof value === "number" ? writeNumber(value, Number(state.digits), state.sign) : (value ?? ""),
    };
}

/** "x / mm"; the name alone where the unit is nothing. */
export const withUnit = (name, unit) => (unit ? `${name} / ${unit}` : name);
