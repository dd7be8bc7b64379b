// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of pasted tables go from one set of units to another: of a profile, of loads, of rows, of a material's constants.
import { readNumber, writeNumber } from "./number.js";

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

/** A material's constants in other units: JSON, or a name and a number a line. */
export function convertedMaterial(text, factorOf, sign) {
    if (text.trim().startsWith("{")) {
        const converted = (name, value) =>
            typeof value === "number" ? Number((value * (factorOf(name) ?? 1)).toPrecision(12)) : value;
        return JSON.stringify(JSON.parse(text), converted, 1);
    }
    const line = /^([^\S\n]*)([^\s,;=:]+)([^\S\n]*[,;=:\t ][^\S\n]*)(\S+)/gm;
    return text.replace(line, (_, before, name, gap, value) =>
        [before, name, gap, convertedCell(value, factorOf(name) ?? 1, sign)].join(""),
    );
}
