// SPDX-License-Identifier: GPL-3.0-or-later
// Case files, as the tool and Python read them. The model knows their words; what the page alone has stands under what is asked of it.
import { ask, knows } from "./library.js";
import { readNumber } from "../number.js";
import { textsFor } from "./solution.js";
import { constantsOf } from "./last_cycle.js";

const LOADS = ["P", "M", "Q", "displacement", "sigma", "tilt"];
const instead = { M: "tilt", Q: "displacement" }; // of which the other is a result

/** A number where it is one. */
const valueOf = (text, sign) => {
    const value = readNumber(text, sign);
    return Number.isFinite(value) ? value : text;
};

/** A material's constants by name: numbers, or texts with their units. */
const materialOf = (text, sign) => Object.fromEntries(constantsOf(text, sign).map(([name, value]) => [name, valueOf(value, ".")]));

/** Columns of a list of loads, of the whole width or section where there is one. */
function columnsOf(loads, width, section) {
    const names = LOADS.filter((name) => name in loads[0] && !(instead[name] in loads[0])),
        share = (name) => (["P", "M", "Q"].includes(name) ? width : name === "sigma" ? section : 1);
    return Object.fromEntries(names.map((name) => [name, loads.map((load) => load[name] * share(name))]));
}

/**
 * The text of a case file. texts: those that the model is told; loads: of a cycle, [{ P, M, Q, sigma }], perhaps with tilt or
 * displacement, or undefined: then those of the form are the case's; compliance: of a rig, as it is typed; shipped: the name of a material that the tool has; settings: what the page alone has.
 */
export function writtenCase({ name, texts, sign, material, shipped, loads, compliance, settings }) {
    const { case: made, width, section } = ask("case", textsFor(texts, sign)),
        { rwedge_case, bodies, pad, loads: ofForm } = made,
        isList = loads?.length > 0,
        rig = isList && "displacement" in loads[0] ? { compliance: valueOf(compliance, sign) } : {},
        options = { ...settings, ...(isList ? ofForm : {}) };
    const file = {
        rwedge_case,
        ...(name && { name }),
        ...(texts.units && { units: texts.units }),
        ...(width && { width }),
        ...(section && { section }),
        bodies: {
            ...bodies,
            ...(texts.plane_stress && { plane_stress: true }),
            ...(texts.strength_of && { strength_of: 2 }),
            ...(texts.similar && { similar: true }),
        },
        pad: { ...pad, ...(texts.rotation && { rotation: texts.rotation }) },
        loads: isList ? { ...columnsOf(loads, width ?? 1, section ?? 1), ...rig } : ofForm,
        ...(material.trim() && { material: shipped || materialOf(material, sign) }),
        asked: { command: "page", options },
    };
    return `${JSON.stringify(file, null, 1).replace(/\n +(-?[\d.e+-]+,?)(?=\n)/g, " $1").replace(/(\d)\n +\]/g, "$1]")}\n`;
}

/** What is wrong ends the reading, with a text for people. */
const refuse = (text) => {
    throw new Error(text);
};
const answered = (answer) => (answer.faults ? refuse(answer.faults[0].text) : answer);
const numbersOnly = (name, list) =>
    list.every((value) => typeof value === "number") ? list : refuse(`${name}: must be a list of numbers`);

/** A pasted table of columns. */
const tableOf = (columns, write) => {
    const names = Object.keys(columns),
        rows = columns[names[0]].map((_, i) => names.map((name) => write(columns[name][i])).join("\t"));
    return [names.join("\t"), ...rows].join("\n");
};

/** The lists of loads of a case, where one of them is a list: the others stay the same. */
function listsOf(loads) {
    const count = Math.max(0, ...Object.values(loads).map((value) => (Array.isArray(value) ? value.length : 0)));
    if (count === 0) return null;
    const whole = (name, value) => {
        const list = Array.isArray(value) ? value : Array(count).fill(value);
        return list.length === count ? numbersOnly(name, list) : refuse(`loads: ${name} has ${list.length} numbers, another one ${count}`);
    };
    return Object.fromEntries(Object.entries(loads).map(([name, value]) => [name, whole(name, value)]));
}

/** Of a group: texts of inputs by name, in the working units. Flags, words and lists go elsewhere. */
function takeGroup(group, values, told, taken) {
    for (const [name, value] of Object.entries(values)) {
        const word = answered(ask("case_word", group, name, String(value), told));
        if (word.input) taken.texts[word.input] = word.value === Infinity ? "inf" : taken.write(word.value);
        else if (word.kind === "numbers") taken.lists[name] = numbersOnly(name, [value].flat());
        else if (word.kind === "flag") taken.words[name] = value === true ? "yes" : "";
        else taken.words[name] = String(value);
    }
}

/** The texts of a page's state of a case file; it throws what is wrong. write(number): with the page's decimal sign. */
export function readCase(text, write) {
    const file = JSON.parse(text),
        { rwedge_case, name = "", material, asked, ...rest } = file,
        settings = asked?.command === "page" ? (asked.options ?? {}) : {},
        setting = (value) => (typeof value === "number" ? write(value) : String(value));
    answered(ask("case_version", rwedge_case ?? NaN));
    const groups = Object.fromEntries(Object.entries(rest).filter(([group]) => knows("case_group", group))),
        others = Object.fromEntries(Object.entries(rest).filter(([word]) => !(word in groups)));
    const { compliance = "", ...ofLoads } = groups.loads ?? {},
        taken = { texts: {}, lists: {}, words: {}, write },
        told = ["units", "width", "section"].filter((word) => word in others).map((word) => `${word}=${others[word]}`).join("\x1e"),
        list = groups.loads && listsOf(ofLoads);
    takeGroup("", others, told, taken);
    for (const [group, values] of Object.entries(groups)) if (!(group === "loads" && list)) takeGroup(group, values, told, taken);
    const { x, ...column } = taken.lists;
    if (x) taken.texts.profile = tableOf({ x, ...column }, write);
    const { units, plane_stress = "", strength_of, rotation = "", similar, width, section, K_in, ...making } = taken.words;
    const isNamed = typeof material === "string",
        ofMaterial = isNamed ? "" : ((material && JSON.stringify(material, null, 1)) ?? "");
    return {
        ...taken.texts,
        ...making,
        ...(list && { loads: tableOf(list, write), tab: "cycle" }),
        ...Object.fromEntries(Object.entries(settings).map(([word, value]) => [word, setting(value)])),
        name,
        units: units ?? "",
        width: width ?? "",
        section: section ?? "",
        compliance: list ? setting(compliance) : "",
        plane: plane_stress && "stress",
        body: strength_of === "2" ? "2" : "",
        rotation: similar ? "similar" : rotation,
        material: ofMaterial,
        shipped: isNamed ? material : "",
    };
}
