// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as they are typed, with a decimal point or comma, and as they are shown.
import { numberOf } from "./answers/library.js";

const mayBeThousands = /^[+-]?[1-9]\d{0,2},\d{3}$/;

/** With a decimal point, as the model reads it. A comma that may separate thousands stays, unless it was chosen as decimal sign. */
export function withPoint(text, sign) {
    const plain = text.trim().replaceAll("\u2212", "-").replace(/\s/g, " ");
    const isDecimal = plain.split(",").length === 2 && !plain.includes(".");
    return isDecimal && (sign === "," || !mayBeThousands.test(plain)) ? plain.replace(",", ".") : plain;
}

/** NaN where the text is no number. */
export const readNumber = (text, sign) => numberOf(withPoint(text, sign));

/** So many significant digits, as the tool writes them (printf's %g); nothing for NaN. */
export function writeNumber(value, digits, sign = ".") {
    if (value === null || Number.isNaN(value)) return "";
    if (!Number.isFinite(value)) return value > 0 ? "inf" : "-inf";
    if (value === 0) return "0";
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
    if (exponent >= -4 && exponent < digits)
        return withoutZeros(value.toFixed(Math.max(0, digits - 1 - exponent))).replace(".", sign);
    return `${withoutZeros(mantissa).replace(".", sign)}e${exponent[0]}${exponent.slice(1).padStart(2, "0")}`;
}

const withoutZeros = (text) => (text.includes(".") ? text.replace(/\.?0+$/, "") : text);

/** All digits: what reads back as the same number, for commands and addresses. */
export const wholeNumber = (value) => (value === Infinity ? "inf" : String(value));
