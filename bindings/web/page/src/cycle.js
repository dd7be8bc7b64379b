// SPDX-License-Identifier: GPL-3.0-or-later
// What the last cycle of a history of loads does, as the model answers it; a material's constants as text.
import { ask, numbersAt } from "./library.js";
import { withPoint } from "./number.js";
import { linesOf, loadOf, number } from "./solution.js";
import { separated } from "./tables.js";
import { criteria } from "./words.js";

/** A name and the rest of its line. */
const namesAndRests = (text) =>
    [...text.matchAll(/^\s*([^\s,;=:]+)[^\S\r\n]*[,;=:\t ]?[^\S\r\n]*(.*?)\s*$/gm)].map(([, name, rest]) => [
        name,
        rest,
    ]);

/** The text is a material file, JSON or a name and a number a line: as lines for the model. */
function linesOfMaterial(text, sign) {
    const entries = text.trim().startsWith("{") ? Object.entries(JSON.parse(text)) : namesAndRests(text);
    return entries.map(([name, value]) => `${name}=${withPoint(String(value), sign)}`).join("\n");
}

const takers = {
    refused: (answer, input, text) =>
        answer.faults.push(input === "criterion" ? `${criteria[answer.criterion.name]} ${text}` : text),
    load: (answer, ...numbers) => answer.loads.push(loadOf(numbers)),
    unused: (answer, text) => (answer.unused = text),
    known: (answer, slip, error) => Object.assign(answer, { slipKnown: slip === "1", error: number(error) }),
    places: (answer, ...at) => (answer.x = numbersAt(...at)),
    measured: (answer, name, ...at) => (answer.measured[name] = numbersAt(...at)),
    worst: (answer, name, x, value) => (answer.worst[name] = { x: number(x), value: number(value) }),
    judged(answer, ...numbers) {
        const [limit, safety, life] = numbers.map(number);
        Object.assign(answer, { limit, safety, life });
    },
    constant: (answer, name, value) => (answer.criterion.constants[name] = value),
    loop(answer, whole, place, ...at) {
        answer.loop = { whole: whole !== "", place: number(place), x: numbersAt(...at), y: numbersAt(...at.slice(3)) };
    },
};

/**
 * { loads, unused, slipKnown, error, x, measured and worst by name, loop or null, limit, safety, life: NaN where not known, criterion with the
 * constants it needs } or { complaint }. text: pasted loads, which are gone through so many times; without any the case's own Q and sigma go
 * to and fro. chosen: { name of the criterion, isPlaneStress, material: its text }.
 */
export function cycleOf(texts, text, sign, times, chosen) {
    const criterion = { ...chosen, constants: {} },
        answer = { faults: [], loads: [], measured: {}, worst: {}, loop: null, criterion };
    let material;
    try {
        material = linesOfMaterial(chosen.material, sign);
    } catch (error) {
        return { complaint: `the material: ${error.message}` };
    }
    for (const [kind, ...fields] of ask(
        "cycle",
        linesOf(texts, sign),
        separated(text),
        sign.charCodeAt(0),
        times.trim(),
        chosen.name,
        Number(chosen.isPlaneStress),
        material,
    ))
        takers[kind]?.(answer, ...fields);
    return answer.faults.length > 0 ? { complaint: answer.faults.join("; ") } : answer;
}
