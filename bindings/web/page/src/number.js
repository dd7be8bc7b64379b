// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as they are typed, with a decimal point or comma, and as they are shown.
import { numberOf } from "./answers/library.js";

const other = { ".": ",", ",": "." };
const mayBeThousands = { ",": /^[+-]?[1-9]\d{0,2},\d{3}$/, ".": /^[+-]?[1-9]\d{0,2}\.\d{3}$/ };

/** With a minus that the model knows. */
export const plainRows = (text) => text.replaceAll("\u2212", "-");

const plain = (text) => plainRows(text.trim()).replace(/\s/g, " ");

/** With the chosen decimal sign, as the model reads it. The other sign counts as one too, but where it may separate thousands: there it
 * stays, and the model refuses it. */
export function withSign(text, sign) {
    const typed = plain(text),
        stray = other[sign];
    const isDecimal = typed.split(stray).length === 2 && !typed.includes(sign) && !mayBeThousands[stray].test(typed);
    return isDecimal ? typed.replace(stray, sign) : typed;
}

/** With a decimal point; a text that the model refuses under this sign stays one that it refuses. */
export function withPoint(text, sign) {
    const typed = withSign(text, sign);
    if (sign === ".") return typed;
    return typed.includes(".") ? typed.replaceAll(".", ",") : typed.replace(",", ".");
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
