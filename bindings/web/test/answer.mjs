// SPDX-License-Identifier: GPL-3.0-or-later
// Answers the calls of tests/answers/calls.py from standard input: each line back with the bits of its results, as 16 hexadecimal
// digits, "nan" for every NaN, "error" where it is refused. Prints what the program in C prints.    answer.mjs PACKAGE
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

const url = (file) => pathToFileURL(resolve(process.argv[2], file)).href;
const rwedge = await import(url("rwedge.mjs"));
const { functions } = await import(url("description.mjs"));
const classes = { contact: rwedge.Contact, series: rwedge.Series };
const objects = {}; // one of a family at a time: what makes one begins the next

/** What of the package the header's name is: a function of arguments. */
function called(name) {
    const family = Object.keys(classes).find((word) => name.startsWith(`${word}_`));
    if (!family) return rwedge[name];
    const method = name.slice(family.length + 1);
    if (!functions[name].parameters.some((p) => p.role === "created")) return (...values) => objects[family][method](...values);
    return (...values) => {
        const make = { create: () => new classes[family](...values), copy: () => objects[family].copy() };
        objects[family] = (make[method] ?? (() => classes[family][method](...values)))();
    };
}

/** Arguments of the words; of an array of two sizes the first one goes where the header has its sizes. */
function argumentsOf(name, words, before) {
    const inputs = functions[name].parameters.filter((p) => p.role === "in" || p.role === "in array");
    const values = words.map((word, i) => {
        if (word === "@") return before;
        const numbers = word.split(/[ ;]/).map((text) => ({ inf: Infinity, "-inf": -Infinity }[text] ?? Number(text)));
        return inputs[i].role === "in" ? numbers[0] : Float64Array.from(numbers);
    });
    const rows = words.find((word) => word.includes(";"));
    if (rows) values.splice(functions[name].parameters.findIndex((p) => p.role === "size"), 0, rows.split(";").length);
    return values;
}

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

let before = new Float64Array(0);
const answers = [];
for (const line of readFileSync(0, "ascii").trimEnd().split("\n")) {
    const [call, ...words] = line.split(","), name = call.split(":")[0];
    try {
        before = Float64Array.from(numbersOf(called(name)(...argumentsOf(name, words, before))));
        answers.push([line, ...Array.from(before, bits)].join(","));
    } catch (error) {
        if (error.name !== "RwedgeError" && error.name !== "TypeError") throw error;
        answers.push(`${line},error`);
    }
}
process.stdout.write(`${answers.join("\n")}\n`);
