// SPDX-License-Identifier: GPL-3.0-or-later
// Rows that are pasted: cells between tabs as a spreadsheet gives them, or between ; or , as a file has them.

const separatorOf = (line) =>
    line.includes("\t") ? "\t" : line.includes(";") ? ";" : line.includes(",") ? "," : /[ ]+/;

/** A cell may stand in quotes, and then hold separators. */
function cellsOf(line, separator) {
    if (separator instanceof RegExp || !line.includes('"')) return line.split(separator).map((cell) => cell.trim());
    const cells = [];
    let cell = "",
        quoted = false;
    for (let i = 0; i < line.length; i++) {
        const c = line[i];
        if (c === '"' && quoted && line[i + 1] === '"') cell += line[++i];
        else if (c === '"') quoted = !quoted;
        else if (c === separator && !quoted) (cells.push(cell.trim()), (cell = ""));
        else cell += c;
    }
    return [...cells, cell.trim()];
}

/** Rows of cells; empty lines are none. */
export function readRows(text) {
    const lines = text
        .replace(/^\ufeff/, "")
        .split(/\r\n|\r|\n/)
        .filter((line) => line.trim() !== "");
    if (lines.length === 0) return [];
    const separator = separatorOf(lines[0].trim());
    return lines.map((line) => cellsOf(separator instanceof RegExp ? line.trim() : line, separator));
}
