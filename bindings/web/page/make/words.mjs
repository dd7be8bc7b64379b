// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the tool and the workbook, read from their sources: names, domains and meanings are written once, there.
import { readFileSync } from "node:fs";

const string = /"((?:[^"\\]|\\.)*)"/g;
const joined = (text) => [...text.matchAll(string)].map((m) => m[1]).join("");
const lower = (id) => ({ E1: "E1", E2: "E2", P: "P", M: "M", Q: "Q" })[id] ?? id.toLowerCase();

function number(text) {
    return text === "HUGE_VAL" ? Infinity : text === "-HUGE_VAL" ? -Infinity : Number(text);
}

/** Of each input: what it is (as the subject of a sentence), its domain, and the words for it. */
function inputs(source) {
    const macros = Object.fromEntries(
        [...source.matchAll(/^#define (\w+) (-?\w+), (-?\w+), (true|false), ("[^"]*")$/gm)].map((m) => [
            m[1],
            m.slice(2).join(", "),
        ]),
    );
    const found = {};
    for (const [, id, subject, rest] of source.matchAll(/\[INPUT_(\w+)\] = \{"([^"]*)",\s*([^}]*)\}/g)) {
        const [, lo, hi, open, domain] = /^(\S+), (\S+), (true|false),\s*("[^]*")$/.exec(macros[rest] ?? rest);
        found[lower(id)] = { subject, lo: number(lo), hi: number(hi), open: open === "true", domain: joined(domain) };
    }
    const help = source.matchAll(/\{INPUT\("([\w-]+)", INPUT_(\w+)\),\s*((?:"[^"]*"\s*)+),\s*"(\w+)"\}/g);
    for (const [, option, id, text] of help) Object.assign(found[lower(id)], { option, help: joined(text) });
    return found;
}

/** Of each result of "rwedge solve": name, meaning, dimension. */
function results(source) {
    const table = /result_kinds\[RESULT_COUNT\] = \{([^]*?)\n\};/.exec(source)[1];
    return [...table.matchAll(/\[RESULT_\w+\] = \{([^}]*)\}/g)].map(([, row]) => {
        const [name, meaning, dimension] = [...row.matchAll(string)].map((m) => m[1]);
        return { name, meaning, dimension };
    });
}

/** Of each measure of "rwedge fretting": name and meaning. */
function measures(source) {
    const table = /measure_kinds\[MEASURE_COUNT\] = \{([^]*?)\n\};/.exec(source)[1];
    return [...table.matchAll(/\{"(\w+)", "([^"]*)",\s*(true|false)\}/g)].map(([, name, meaning]) => ({
        name,
        meaning,
    }));
}

/** Other names of inputs, which a column may have by mistake. */
function synonyms(source) {
    const table = /synonyms\[\] = \{([^]*?)\n\};/.exec(source)[1].replace(/\/\*.*?\*\//g, "");
    return [...table.matchAll(/\{"([^"]*)", INPUT_(\w+)\}/g)].map(([, name, id]) => [bytes(name), lower(id)]);
}

/** A C string with escaped bytes, which are UTF-8. */
function bytes(text) {
    const raw = text.replace(/\\x([0-9a-f]{2})|\\([0-7]{3})/gi, (_, hex, octal) =>
        String.fromCharCode(hex ? parseInt(hex, 16) : parseInt(octal, 8)),
    );
    return Buffer.from(raw, "latin1").toString("utf8");
}

export function words(top) {
    const read = (name) => readFileSync(`${top}/${name}`, "utf8");
    const all = {
        inputs: inputs(read("cli/contact/inputs.c")),
        results: results(read("cli/solve/results.c")),
        measures: measures(read("cli/fretting/last_cycle.c")),
        synonyms: synonyms(read("cli/model/header.c")),
    };
    const counts = [Object.keys(all.inputs).length, all.results.length, all.measures.length];
    if (counts.join() !== "15,30,9" || all.synonyms.length < 30)
        throw new Error(`the sources of the words have changed: ${counts} inputs, results, measures`);
    for (const [name, input] of Object.entries(all.inputs))
        if (!input.option || !input.domain) throw new Error(`no words for the input ${name}`);
    return all;
}
