// SPDX-License-Identifier: GPL-3.0-or-later
// The calls of the library: numbers and arrays into its memory, results out of it, statuses as exceptions, objects with a lifetime.
import { functions, statuses } from "./description.mjs";
import { wasm } from "./wasm.mjs";

// It imports nothing: an instance of another module could not be made so.
export const library = new WebAssembly.Instance(new WebAssembly.Module(wasm)).exports;
library._initialize();

// The library's memory as doubles. It is another array after the memory has grown.
let doubles = new Float64Array(library.memory.buffer);
export function memory() {
    if (doubles.buffer !== library.memory.buffer) doubles = new Float64Array(library.memory.buffer);
    return doubles;
}

/** The text at an address, with a 0 at its end. */
export function textAt(address) {
    const bytes = new Uint8Array(library.memory.buffer);
    return new TextDecoder().decode(bytes.subarray(address, bytes.indexOf(0, address)));
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
function checkNumber(name, parameter, value, place = "") {
    if (typeof value !== "number") {
        throw new TypeError(`${name}(): ${parameter.name}${place} must be a number, not ${value === null ? "null" : typeof value}`);
    }
    if (parameter.kind !== "double" && !isWhole(value)) {
        throw new TypeError(`${name}(): ${parameter.name}${place} must be a whole number below 2^31, not ${value}`);
    }
}

function isWhole(value) {
    return Number.isInteger(value) && Math.abs(value) <= 2147483647;
}

/** An array of numbers as a Float64Array: empty places and texts are no numbers. */
function asDoubles(name, parameter, value) {
    if (value instanceof Float64Array && parameter.kind === "double") return value;
    if (!isArray(value)) throw new TypeError(`${name}(): ${parameter.name} must be an array of numbers, not ${typeof value}`);
    for (let i = 0; i < value.length; i++) checkNumber(name, parameter, value[i], `[${i}]`);
    return Float64Array.from(value);
}

/** The arguments as they were given, by their names in the header. */
function byName(about, values) {
    return new Map(about.arguments.map((name, i) => [name, values[i]]));
}

/** The arguments of points: numbers among arrays are repeated. Gives the arrays, or undefined where all are numbers. */
function asPoints(name, parameters, values) {
    const arrays = parameters.map((p, i) => (isArray(values[i]) ? asDoubles(name, p, values[i]) : checkNumber(name, p, values[i])));
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

/** Which element of an argument is outside its domain, 0 of a number; -1 where none is. */
function outside({ domain }, value) {
    return domain ? (isArray(value) ? value : [value]).findIndex((number) => !allows(domain, number)) : -1;
}

/** "x[3] = -1 (|x| <= b)": the element that is outside, or the whole argument. place is that of numbers which stand for an element. */
function told(p, value, place, allowed) {
    const i = outside(p, value), isElement = isArray(value) && i >= 0;
    const text = isElement ? `[${i}] = ${value[i]}` : `${isArray(value) ? "" : place} = ${shown(value)}`;
    return `${p.name}${text}${allowed && p.domain?.text ? ` (${p.domain.text})` : ""}`;
}

const ofArguments = ["RWEDGE_EDOMAIN", "RWEDGE_ERANGE", "RWEDGE_ESLIDING"];

/** Throws what a status means: with the arguments that are outside their domains, or with all of them where none is by itself; with
 * what is allowed; and with the reason of this function, or that of these loads. */
function check(name, about, status, valuesOf, place = "", why = about.reasons[status]) {
    if (status === 0) return;
    const values = valuesOf(), constant = Object.keys(statuses).find((each) => statuses[each] === status);
    const parameters = about.parameters.filter((p) => values.has(p.name));
    const refused = parameters.filter((p) => outside(p, values.get(p.name)) >= 0);
    const listed = (refused.length ? refused : parameters).map((p) => told(p, values.get(p.name), place, ofArguments.includes(constant)));
    const reason = textAt(library.rwedge_strerror(status)) + (why ? `, ${why}` : "");
    throw new RwedgeError(constant, `${name}(): ${reason}${listed.length ? `: ${listed.join(", ")}` : ""}`);
}

/** The outputs: nothing, the one, or an object of several with their names in the header. */
function results(outputs, valueOf) {
    if (outputs.length < 2) return outputs.length ? valueOf(outputs[0], 0) : undefined;
    return Object.fromEntries(outputs.map((p, k) => [p.name, valueOf(p, k)]));
}

// ---- Formulas: functions of numbers, one call for each point ----

/** What is known of a formula before it is called; the place in memory of its results is kept. */
const formulas = new Map();
function prepare(name) {
    const about = functions[name];
    const inputs = about.parameters.filter((p) => p.role === "in"), outputs = about.parameters.filter((p) => p.role === "out");
    const address = outputs.length ? library.malloc(8 * outputs.length) : 0;
    const prepared = { about, inputs, outputs, address, called: library[`rwedge_${name}`], isValue: about.result === "value",
        places: outputs.map((_, k) => address + 8 * k), whole: inputs.map((p) => p.kind !== "double") };
    formulas.set(name, prepared);
    return prepared;
}

/** One call of numbers and of the places of its results; i where they are a point of arrays. */
function once(name, { about, called }, passed, i) {
    const status = called(...passed);
    if (status !== 0) check(name, about, status, () => byName(about, passed), i === undefined ? "" : `[${i}]`);
    return memory();
}

export function formula(name, ordered) {
    const prepared = formulas.get(name) ?? prepare(name), { outputs, address, called, isValue, places, whole } = prepared;
    for (let k = 0; k < whole.length; k++) {
        if (typeof ordered[k] !== "number" || whole[k] && !isWhole(ordered[k])) return ofPoints(name, prepared, ordered);
    }
    if (isValue) return called(...ordered);
    const written = once(name, prepared, [...ordered, ...places]);
    return results(outputs, (_, k) => written[address / 8 + k]);
}

/** A call for each point: numbers go with every one. */
function ofPoints(name, prepared, ordered) {
    const { inputs, outputs, address, called, isValue, places } = prepared, passed = [...inputs.map((_, k) => ordered[k]), ...places];
    const { arrays, length } = asPoints(name, inputs, passed);
    const changing = inputs.map((_, k) => k).filter((k) => arrays[k]);
    const columns = Array.from({ length: isValue ? 1 : outputs.length }, () => new Float64Array(length));
    for (let i = 0; i < length; i++) {
        for (const k of changing) passed[k] = arrays[k][i];
        if (isValue) columns[0][i] = called(...passed);
        else {
            const written = once(name, prepared, passed, i);
            for (let k = 0; k < columns.length; k++) columns[k][i] = written[address / 8 + k];
        }
    }
    return isValue ? columns[0] : results(outputs, (_, k) => columns[k]);
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
    for (const p of about.implied) {
        // 0 is told where any number will do, or where the function is going to refuse
        const count = p.fixed || library[`rwedge_${p.givenBy}`](values.get(p.givenFrom));
        if (count > 0) tell(p.name, count);
    }
    for (const p of about.parameters) {
        if (p.role === "size" && values.has(p.name)) tell(p.name, values.get(p.name));
        const teller = p.givenBy && library[p.givenBy.replace(/^(rwedge_)?/, "rwedge_")];
        if (teller) tell(p.name, teller(...[...(address ? [address] : []), ...values.values()].slice(0, teller.length)));
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
function taken(name, about, ordered) {
    const values = byName(about, ordered), inputs = about.parameters.filter((p) => values.has(p.name));
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

export function call(name, object, ordered) {
    const about = functions[name], handle = object ? addressOf(object, about) : 0;
    const { values, single } = taken(name, about, ordered);
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
        if (about.result === "status" && returned !== 0) {
            if (returned === statuses.RWEDGE_EDOMAIN && about.pointwise && !single) blame(name, about, passed, values, length);
            const why = returned === statuses.RWEDGE_EPATH && /^contact_(apply|load)$/.test(name) ? obstacle(object, values) : "";
            check(name, about, returned, () => (single ? point(values, 0) : values), "", why || undefined);
        }
        return answer(about, returned, places, (p, place) =>
            p.role === "out" || single ? memory()[place / 8] : memory().slice(place / 8, place / 8 + length(p)));
    } finally {
        library.free(block);
    }
}

/** The arguments of one point. */
const point = (values, i) => new Map([...values].map(([key, value]) => [key, isArray(value) ? value[i] : value]));

/** Throws for the first point that is refused alone. */
function blame(name, about, passed, values, length) {
    const arrays = about.parameters.map((p) => p.role === "in array");
    const n = length(about.parameters[arrays.indexOf(true)]);
    for (let i = 0; i < n; i++) {
        const alone = about.parameters.map((p, k) => (arrays[k] ? passed[k] + 8 * i : p.role === "size" ? 1 : passed[k]));
        const status = library[`rwedge_${name}`](...alone);
        check(name, about, status, () => point(values, i), `[${i}]`);
    }
}

/** Why these loads have no closed form, and what to do instead. Moment and tension that are not given stay. */
function obstacle(object, values) {
    const { P, M, Q, sigma } = { ...call("contact_loads", object, []), ...Object.fromEntries(values) };
    return call("contact_obstacle", object, [P, M, Q, sigma]);
}

// ---- Objects ----

const addresses = new WeakMap();
const registry = new FinalizationRegistry(({ destroy, address }) => destroy(address));

function addressOf(object, about) {
    const held = addresses.get(object);
    if (!held) throw new TypeError(`this ${object.constructor.name} has been freed`);
    const { kind } = about.parameters.find((p) => p.role === "handle" || p.role === "changed");
    if (held.family !== kind) throw new TypeError(`this ${object.constructor.name} is no ${kind}`);
    return held.address;
}

/** Makes a JavaScript object that of the library at an address, which is freed with it. */
export function adopt(object, family, address) {
    const held = { destroy: library[`rwedge_${family}_destroy`], address, family };
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
