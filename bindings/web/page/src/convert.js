// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of pasted tables go from one set of units to another: of a profile, of loads, of rows, of a material's constants.
import { readNumber, withPoint, writeNumber } from "./number.js";

const between = /([\t;]+|,(?!\d)|(?<!\d),)/; // what separates cells, where a comma between digits may be a decimal sign

/** A cell in other units, as it was where it is no number; blanks around it stay. */
function convertedCell(cell, factor, sign) {
    const text = cell.trim(),
        value = readNumber(text, sign);
    return factor === 1 || Number.isNaN(value) ? cell : cell.replace(text, writeNumber(value * factor, 12, sign));
}

/** The parts of a line: cells at even places, what separates them between. Blanks separate where nothing else does. */
function partsOf(line, sign) {
    const separator = line.includes("\t") ? /(\t)/ : line.includes(";") ? /(;)/ : sign === "." && line.includes(",") ? /(,)/ : between;
    const parts = line.split(separator);
    return parts.length > 1 ? parts : line.trim().split(/( +)/);
}

const isNumber = (cell, sign) => !Number.isNaN(readNumber(cell, sign));

/**
 * A pasted table in other units. factorOf(name) is that of a column; a column whose name has a unit of its own has 1. usual: the names of
 * the columns where no line of names stands above.
 */
export function convertedTable(text, usual, factorOf, sign) {
    let names = null;
    const lines = text.split("\n").map((line) => {
        const parts = partsOf(line, sign),
            cells = parts.filter((_, i) => i % 2 === 0);
        if (line.trim() === "" || line.trimStart().startsWith("#")) return line;
        if (names === null && !cells.some((cell) => isNumber(cell, sign))) {
            names = cells.map((cell) => cell.trim());
            return line;
        }
        names ??= usual;
        return parts.map((part, i) => (i % 2 ? part : convertedCell(part, factorOf(names[i / 2] ?? ""), sign))).join("");
    });
    return lines.join("\n");
}

const exponent = /^\W*paris_m\W+?([-+]?[\d.,]+)/m;

/**
 * A material's constants in other units: JSON, or a name and a number a line. A constant with its own unit stays, and so do all where
 * the material says the units of its numbers. factorOf(name, exponent of the growth of a crack)
 */
export function convertedMaterial(text, factorOf, sign) {
    const [, m = ""] = text.match(exponent) ?? [],
        factor = (name) => factorOf(name, withPoint(m, sign));
    if (text.trim().startsWith("{")) {
        const constants = JSON.parse(text),
            converted = (name, value) =>
                typeof value === "number" ? Number((value * factor(name)).toPrecision(12)) : value;
        return "units" in constants ? text : JSON.stringify(constants, converted, 1);
    }
    if (/^[^\S\n]*units[^\S\n]*[,;=:\t ]/m.test(text)) return text;
    const line = /^([^\S\n]*)([^\s,;=:]+)([^\S\n]*[,;=:\t ][^\S\n]*)(.*)$/gm;
    return text.replace(line, (_, before, name, gap, value) =>
        [before, name, gap, convertedCell(value, factor(name), sign)].join(""),
    );
}
