// SPDX-License-Identifier: GPL-3.0-or-later
// Answers what tests/answers/calls.py javascript prints, from standard input: each call with the bits of its results, as 16
// hexadecimal digits, "nan" for every NaN, "error" where it is refused. Prints what the program in C prints.    answer.mjs PACKAGE
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

const rwedge = await import(pathToFileURL(resolve(process.argv[2], "rwedge.mjs")).href);
const known = { ...rwedge, inf: Infinity, nan: NaN, before: new Float64Array(0) };

/** The numbers of a result, in the order of the header. */
function numbersOf(result) {
    if (result === undefined) return [];
    if (typeof result === "string") return [result.length];
    if (typeof result === "number") return [result];
    return result instanceof Float64Array ? Array.from(result) : Object.values(result).flatMap(numbersOf);
}

const view = new DataView(new ArrayBuffer(8));
function bits(number) {
    view.setFloat64(0, number);
    return Number.isNaN(number) ? "nan" : view.getBigUint64(0).toString(16).padStart(16, "0");
}

const answers = [];
for (const line of readFileSync(0, "ascii").trimEnd().split("\n")) {
    const [call, text] = line.split("\t");
    try {
        let result = new Function(...Object.keys(known), `return ${text.split(" = ").at(-1)}`)(...Object.values(known));
        for (const [name, kind] of [["contact", rwedge.Contact], ["cycle", rwedge.Cycle], ["series", rwedge.Series]])
            if (result instanceof kind) [known[name], result] = [result, undefined]; // what makes one begins the next
        known.before = Float64Array.from(numbersOf(result));
        answers.push([call, ...Array.from(known.before, bits)].join(","));
    } catch (error) {
        if (error.name !== "RwedgeError" && error.name !== "TypeError") throw error;
        answers.push(`${call},error`);
    }
}
process.stdout.write(`${answers.join("\n")}\n`);
