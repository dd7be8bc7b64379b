// SPDX-License-Identifier: GPL-3.0-or-later
// The calls of the library: numbers and arrays into its memory, results out of it, statuses as exceptions, objects with a lifetime.
import { functions, statuses } from "./description.mjs";
import { wasm } from "./wasm.mjs";

export const library = new WebAssembly.Instance(new WebAssembly.Module(wasm)).exports;
library._initialize();

// The library's memory as doubles. It is another array after the memory has grown.
let doubles = new Float64Array(library.memory.buffer);
function memory() {
    if (doubles.buffer !== library.memory.buffer) doubles = new Float64Array(library.memory.buffer);
    return doubles;
}

/** The text at an address: ASCII, with a 0 at its end. */
function textAt(address) {
    const bytes = new Uint8Array(library.memory.buffer);
    return String.fromCharCode(...bytes.subarray(address, bytes.indexOf(0, address)));
}

/** What a status of the library other than RWEDGE_OK becomes. */
export class RwedgeError extends Error {
    constructor(status, message) {
        super(message);
        this.name = "RwedgeError";
        this.status = status;
    }
}

// ---- Arguments ----

function isArray(value) {
    return Array.isArray(value) || ArrayBuffer.isView(value) && !(value instanceof DataView);
}

function shown(value) {
    if (!isArray(value)) return String(value);
    return value.length > 3 ? `[${value[0]}, ${value[1]}, ... ${value.length} numbers]` : `[${Array.from(value).join(", ")}]`;
}

/** An argument that is no number, or not a whole one, is a mistake of the program. */
function checkNumber(name, parameter, value) {
    if (typeof value !== "number") {
        throw new TypeError(`${name}(): ${parameter.name} must be a number, not ${value === null ? "null" : typeof value}`);
    }
    if (parameter.kind !== "double" && (!Number.isInteger(value) || Math.abs(value) > 2147483647)) {
        throw new TypeError(`${name}(): ${parameter.name} must be a whole number below 2^31, not ${value}`);
    }
}

/** An array of numbers as a Float64Array: empty places and texts are no numbers. */
function asDoubles(name, parameter, value) {
    if (value instanceof Float64Array && parameter.kind === "double") return value;
    if (!isArray(value)) throw new TypeError(`${name}(): ${parameter.name} must be an array of numbers, not ${typeof value}`);
    for (const number of value) checkNumber(name, parameter, number);
    return Float64Array.from(value);
}

/** The arguments as they were given, by their names in the header. */
function byName(about, given) {
    return new Map(about.given.map((name, i) => [name, given[i]]));
}

/** The arguments of points: numbers among arrays are repeated. Gives the arrays, or undefined where all are numbers. */
function asPoints(name, parameters, given) {
    const arrays = given.map((value, i) => (isArray(value) ? asDoubles(name, parameters[i], value) : checkNumber(name, parameters[i], value)));
    const lengths = arrays.filter(Boolean).map((array) => array.length);
    if (lengths.some((n) => n !== lengths[0])) {
        throw new TypeError(`${name}(): arrays of ${lengths.join(" and ")} numbers: all must have the same length`);
    }
    return lengths.length ? { arrays, length: lengths[0] } : undefined;
}

// ---- Statuses ----

function allows(domain, value) {
    if (domain.any) return true;
    if (!Number.isFinite(value)) return value === Infinity && !domain.finite;
    if (value === 0 && domain.orZero) return true;
    return !(domain.low !== null && (value < domain.low || domain.lowOpen && value === domain.low)) &&
        !(domain.high !== null && (value > domain.high || domain.highOpen && value === domain.high)) &&
        (value === 0 || Math.abs(value) >= domain.smallest);
}

/** What of an argument is outside its domain: "x[3] = -1", or nothing. */
function outside(parameter, value) {
    if (!parameter.domain) return undefined;
    if (!isArray(value)) return allows(parameter.domain, value) ? undefined : `${parameter.name} = ${value}`;
    const i = value.findIndex((number) => !allows(parameter.domain, number));
    return i < 0 ? undefined : `${parameter.name}[${i}] = ${value[i]}`;
}

/** Throws what a status means: with the arguments that are outside their domains, or with all of them where none is by itself. */
function check(name, about, status, given) {
    if (status === 0) return;
    const values = given();
    const parameters = about.parameters.filter((p) => values.has(p.name));
    const refused = parameters.filter((p) => outside(p, values.get(p.name)));
    const told = refused.length ? refused.map((p) => `${outside(p, values.get(p.name))} (${p.domain.text})`)
        : parameters.map((p) => `${p.name} = ${shown(values.get(p.name))}`);
    const reason = textAt(library.rwedge_strerror(status));
    const constant = Object.keys(statuses).find((each) => statuses[each] === status);
    throw new RwedgeError(constant, `${name}(): ${reason}${told.length ? `: ${told.join(", ")}` : ""}`);
}

/** The outputs: nothing, the one, or an object of several with their names in the header. */
function results(outputs, valueOf) {
    if (outputs.length < 2) return outputs.length ? valueOf(outputs[0], 0) : undefined;
    return Object.fromEntries(outputs.map((p, k) => [p.name, valueOf(p, k)]));
}

// ---- Formulas: functions of numbers, one call for each point ----

/** The function of the header as one of an array of numbers, which gives its results in found, each at the index i. */
function evaluator(name, about, found, address) {
    const called = library[`rwedge_${name}`];
    if (about.result === "value") {
        return (numbers, i) => {
            found[0][i] = called(...numbers);
        };
    }
    const places = found.map((_, k) => address + 8 * k);
    return (numbers, i) => {
        check(name, about, called(...numbers, ...places), () => byName(about, numbers));
        const written = memory();
        for (let k = 0; k < found.length; k++) found[k][i] = written[address / 8 + k];
    };
}

export function formula(name, given) {
    const about = functions[name];
    const outputs = about.parameters.filter((p) => p.role === "out");
    const inputs = about.parameters.filter((p) => p.role === "in");
    const numbers = inputs.map((_, k) => given[k]);
    const points = asPoints(name, inputs, numbers);
    const changing = inputs.map((_, k) => k).filter((k) => points?.arrays[k]);
    const found = Array.from({ length: outputs.length || 1 }, () => new Float64Array(points?.length ?? 1));
    const address = library.malloc(8 * found.length);
    try {
        const evaluate = evaluator(name, about, found, address);
        for (let i = 0; i < found[0].length; i++) {
            for (const k of changing) numbers[k] = points.arrays[k][i];
            evaluate(numbers, i);
        }
    } finally {
        library.free(address);
    }
    const values = points ? found : found.map((array) => array[0]);
    return outputs.length ? results(outputs, (_, k) => values[k]) : values[0];
}

// ---- All other functions: arrays and objects ----

/** The sizes: given, told by arrays, or told by a function. */
function sizesOf(name, about, values, address) {
    const sizes = new Map();
    const tell = (size, n, array) => {
        if (sizes.has(size) && sizes.get(size) !== n) {
            throw new TypeError(`${name}(): ${array} has ${values.get(array).length} numbers, which does not fit the other arguments`);
        }
        sizes.set(size, n);
    };
    const arrays = about.parameters.filter((p) => p.role === "in array");
    for (const p of about.parameters) {
        if (p.role === "size" && values.has(p.name)) tell(p.name, values.get(p.name));
        if (p.givenBy) tell(p.name, library[p.givenBy.replace(/^(rwedge_)?/, "rwedge_")](address));
    }
    for (const p of arrays.filter((array) => array.size.length === 1)) tell(p.size[0], values.get(p.name).length, p.name);
    for (const p of arrays.filter((array) => array.size.length === 2)) {
        const rows = sizes.get(p.size[0]), n = rows ? values.get(p.name).length / rows : 0;
        if (!Number.isInteger(n)) throw new TypeError(`${name}(): ${p.name} must have ${p.size.join(" * ")} numbers, but has ${values.get(p.name).length}`);
        tell(p.size[1], n, p.name);
    }
    return sizes;
}

/** The arguments by their names, arrays as Float64Arrays; and whether all points were numbers. */
function taken(name, about, given) {
    const values = byName(about, given), inputs = about.parameters.filter((p) => values.has(p.name));
    const ofPoints = about.pointwise ? inputs.filter((p) => p.role === "in array") : [];
    const points = asPoints(name, ofPoints, ofPoints.map((p) => values.get(p.name)));
    const length = points?.length ?? 1;
    for (const p of inputs) {
        const value = values.get(p.name), k = ofPoints.indexOf(p);
        if (k >= 0) values.set(p.name, points?.arrays[k] ?? new Float64Array(length).fill(value));
        else if (p.role === "in array") values.set(p.name, asDoubles(name, p, value));
        else checkNumber(name, p, value);
    }
    return { values, single: ofPoints.length > 0 && !points };
}

/** One after another from an address on: the places of what a function reads and writes in memory. The arrays are written there. */
function placed(parameters, values, length, address) {
    const places = new Map();
    for (const p of parameters) {
        places.set(p.name, address);
        if (p.role === "in array") memory().set(values.get(p.name), address / 8);
        address += 8 * length(p);
    }
    return places;
}

/** What a function gives: the value that it returns, the object that it makes, or its outputs; read(p, place) is one of these. */
function answer(about, returned, places, read) {
    if (about.result === "value") return returned;
    if (about.result === "text") return textAt(returned);
    const made = about.parameters.find((p) => p.role === "created");
    if (made) return new Uint32Array(library.memory.buffer)[places.get(made.name) / 4];
    const outputs = about.parameters.filter((p) => p.role === "out" || p.role === "out array");
    return results(outputs, (p) => read(p, places.get(p.name)));
}

export function call(name, object, given) {
    const about = functions[name], handle = object ? addressOf(object) : 0;
    const { values, single } = taken(name, about, given);
    const sizes = sizesOf(name, about, values, handle);
    const length = (p) => (p.size ? p.size.reduce((n, size) => n * sizes.get(size), 1) : 1);
    const inMemory = about.parameters.filter((p) => ["in array", "out", "out array", "created"].includes(p.role));
    const block = library.malloc(8 * inMemory.reduce((n, p) => n + length(p), 1));
    if (!block) check(name, about, statuses.RWEDGE_ENOMEM, () => new Map());
    try {
        const places = placed(inMemory, values, length, block);
        const passed = about.parameters.map((p) => places.get(p.name) ??
            (p.role === "size" ? sizes.get(p.name) : p.role === "in" ? values.get(p.name) : handle));
        const returned = library[`rwedge_${name}`](...passed);
        if (about.result === "status") check(name, about, returned, () => values);
        return answer(about, returned, places, (p, place) =>
            p.role === "out" || single ? memory()[place / 8] : memory().slice(place / 8, place / 8 + length(p)));
    } finally {
        library.free(block);
    }
}

// ---- Objects ----

const addresses = new WeakMap();
const registry = new FinalizationRegistry(({ destroy, address }) => destroy(address));

function addressOf(object) {
    const address = addresses.get(object);
    if (!address) throw new TypeError(`this ${object.constructor.name} has been freed`);
    return address.address;
}

/** Makes a JavaScript object that of the library at an address, which is freed with it. */
export function adopt(object, family, address) {
    const held = { destroy: library[`rwedge_${family}_destroy`], address };
    addresses.set(object, held);
    registry.register(object, held, object);
    return object;
}

/** Frees now what the collector of garbage would free at some time. A second time does nothing. */
export function free(object) {
    const held = addresses.get(object);
    if (!held) return;
    registry.unregister(object);
    addresses.delete(object);
    held.destroy(held.address);
}
