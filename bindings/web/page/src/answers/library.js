// SPDX-License-Identifier: GPL-3.0-or-later
// The library as WebAssembly, with the model of the tool.
import * as rwedge from "rwedge";
import { adopt, library, textAt } from "rwedge-runtime";

export { rwedge };

/** What an action gives; null where the library refuses. Any other error is a mistake of the page. */
export function orNull(action) {
    try {
        return action();
    } catch (error) {
        if (error instanceof rwedge.RwedgeError) return null;
        throw error;
    }
}

// ---- The model: ../model/*.c ----

function placed(text) {
    const letters = new TextEncoder().encode(`${text}\0`),
        address = library.malloc(letters.length);
    new Uint8Array(library.memory.buffer).set(letters, address);
    return address;
}

/** Calls a function of the model with texts and numbers. */
function call(name, values) {
    const texts = [];
    const passed = values.map((value) => {
        if (typeof value !== "string") return value;
        texts.push(placed(value));
        return texts.at(-1);
    });
    try {
        return library[name](...passed);
    } finally {
        texts.forEach(library.free);
    }
}

/** Members of an answer: lists are continued, objects too. */
function join(all, part) {
    for (const [name, value] of Object.entries(part)) {
        if (Array.isArray(value)) (all[name] ??= []).push(...value);
        else all[name] = value?.constructor === Object ? join(all[name] ?? {}, value) : value;
    }
    return all;
}

/** What is long goes on in parts; told() is called after each with the share that is done. */
export function goThrough(name, values, told) {
    call(`page_${name}_begin`, values);
    for (let share = 0; share < 1; told(share)) share = call(`page_${name}_go`, []);
}

/** What the model answers: an object, of which the model gives the parts in JSON. It has no text where memory ran out. */
export function ask(name, ...values) {
    const text = textAt(call(`page_${name}`, values));
    if (text === "") throw new Error("the memory of the page is not enough");
    return JSON.parse(text).reduce(join, {});
}

/** What the model says of texts, yes or no. */
export const knows = (name, ...values) => call(`page_${name}`, values) !== 0;

/** NaN where the text is no number with a decimal point. */
export const numberOf = (text) => call("page_number", [text]);

/** What a number of a dimension in the units "mm,N,MPa" is multiplied by to be in others; 1 where the model does not know one of them. */
export const factorOf = (from, to, dimension = "") => call("page_factor", [from, to, dimension]);

/** The same of a material's constant; that of paris_C depends on the text of its exponent. */
export const constantFactorOf = (from, to, name, exponent) => call("page_constant_factor", [from, to, name, exponent]);

/** The contact of the last answer, once. */
export const answeredContact = () => adopt(Object.create(rwedge.Contact.prototype), "contact", library.page_contact());
