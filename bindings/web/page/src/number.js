// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as they are typed, with a decimal point or comma, and as they are shown.

const written = /^[+-]?(\d+[.,]?\d*|[.,]\d+)(e[+-]?\d+)?$/i;

/** NaN where the text is no number. Both decimal signs are read; a sign for thousands is none. */
export function readNumber(text) {
    const plain = text.trim().replace(/\u2212/g, "-");
    return written.test(plain) ? Number(plain.replace(",", ".")) : NaN;
}

/** Whether others would read 1,234 as a thousand and more. */
export const mayBeThousands = (text) => /^[+-]?[1-9]\d{0,2},\d{3}$/.test(text.trim());

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
