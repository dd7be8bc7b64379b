// SPDX-License-Identifier: GPL-3.0-or-later
// The tab Cycle: a table of loads, what its last cycle does along the surface, the worst places, and the loop.
import { copyButton, element, escaped } from "../elements.js";
import { Aside } from "../aside.js";
import { asFretting } from "../export.js";
import { markWorst } from "../left/drawing.js";
import { roomy } from "../plot/axes.js";
import { curvePlot } from "../plot/live.js";
import { withUnit } from "../model.js";
import { writeNumber } from "../number.js";
import { barText } from "../verdict.js";
import { criteria, measures } from "../words.js";
import { tableText } from "./table.js";

const unitOf = (name, unit) => unit[measures[name].unit];

/** A measure along the surface, where it is worst, and its limit. */
function alongOf({ x, measured, worst }, { unit, write }, name, title, limit = NaN) {
    const top = worst[name];
    if (!top) return "";
    const ends = [x[0], x.at(-1)];
    return {
        title,
        curves: [
            { name: title, style: "one", x, y: measured[name] },
            ...(Number.isNaN(limit) ? [] : [{ name: "limit", style: "thin", x: ends, y: [limit, limit] }]),
        ],
        points: [{ x: top.x, y: top.value, name: write(top.value) }],
        xLabel: withUnit("x", unit.length),
        yLabel: withUnit(name, unitOf(name, unit)),
    };
}

function fatigueOf(answer, model) {
    const { name } = answer.criterion;
    return alongOf(answer, model, name, `${criteria[name]} along the surface`, answer.limit);
}

const loopNames = ({ whole }) => (whole ? ["displacement by slip", "Q"] : ["slip", "q"]);

function loopOf({ loop }, { unit, write }) {
    if (!loop) return "";
    const ofPlace = `shear traction over slip at x = ${write(loop.place)}`,
        name = loop.whole ? "tangential load over displacement by slip" : ofPlace,
        [xName, yName] = loopNames(loop);
    return {
        title: `Loop of the cycle: ${name}`,
        curves: [{ name, style: "one", x: loop.x, y: loop.y }],
        xDomain: roomy([Math.min(...loop.x), Math.max(...loop.x)]),
        xLabel: withUnit(xName, unit.length),
        yLabel: withUnit(yName, loop.whole ? unit["force/length"] : unit.stress),
    };
}

/** What the chosen criterion comes to where it is worst, in a sentence, with a bar. */
function sentenceText({ worst, criterion: { name }, limit, safety, life }, { unit, write }) {
    const { value, x } = worst[name] ?? { value: 0 };
    const place = x === undefined ? "" : ` at x = ${write(x)} ${unit.length}`,
        beside = safety < 1 ? "above" : "below";
    const parts = [
        `${criteria[name]}: ${write(value)} ${unitOf(name, unit)}${place}`,
        Number.isNaN(safety)
            ? "no limit of the material is given"
            : `${beside} its limit ${write(limit)}, a factor of ${write(safety)}`,
        !Number.isNaN(life) && (life === Infinity ? "no failure" : `${write(life)} cycles to failure`),
    ];
    const bar = Number.isNaN(safety) ? "" : barText(safety, safety < 1 ? "red" : "green", "the limit");
    return `<p class="sentence">${escaped(parts.filter(Boolean).join("; "))}.</p>${bar}`;
}

function verdictRows({ limit, safety, life }, { write }) {
    return [
        {
            name: "cycle_safety",
            value: write(safety),
            meaning: `limit ${write(limit)} over the worst value`,
        },
        {
            name: "cycle_life",
            value: write(life),
            meaning: "cycles to failure; inf below the limit",
        },
    ];
}

function worstText(answer, model) {
    const { worst } = answer,
        { unit, write } = model,
        names = Object.keys(worst);
    const rows = names.map((name) => ({
        name,
        value: write(worst[name].value),
        unit: unitOf(name, unit),
        meaning: `at x = ${write(worst[name].x)}: ${measures[name].meaning}`,
    }));
    return tableText("The worst places", [...rows, ...verdictRows(answer, model)]);
}

function surfaceTable({ x, measured }, unit) {
    const names = Object.keys(measured);
    return {
        names: ["x", ...names],
        units: [unit.length, ...names.map((name) => unitOf(name, unit))],
        rows: Array.from(x, (v, i) => [v, ...names.map((name) => measured[name][i])]),
    };
}

function loopTable({ loop }) {
    const names = loopNames(loop).map((name) => name.replaceAll(" ", "_"));
    return { names, rows: Array.from(loop.x, (v, i) => [v, loop.y[i]]) };
}

function remarkOf(answer, state) {
    if (answer.complaint) return answer.complaint;
    const usual = "No table is given: P and M of the case come first, then its Q and \u03c3 go to and fro";
    const slip = "No slip is known after these loads";
    const computed = `Computed numerically: tractions to about ${writeNumber(answer.error, 1, state.sign)} of f p0`;
    return [!state.loads.trim() && usual, answer.unused, !answer.slipKnown && slip, answer.error > 0 && computed]
        .filter(Boolean)
        .join(". ");
}

const entry = (name, attributes) => element(name, { spellcheck: "false", ...attributes });

/** What is typed and chosen, by the names of the state, the command, and the remark. */
function makeEntries() {
    const options = Object.entries(criteria).map(([value, title]) => element("option", { value }, title));
    return {
        typed: {
            loads: entry("textarea", { id: "loads", rows: 5, placeholder: "P\tQ", "aria-describedby": "loads-note" }),
            cycles: entry("input", { id: "cycles", type: "text", size: 4, inputmode: "numeric" }),
            material: entry("textarea", { id: "material", rows: 5, placeholder: "swt_limit\t0.5" }),
            criterion: element("select", { id: "criterion" }, ...options),
            plane: element("input", { id: "plane", type: "checkbox" }),
        },
        command: element("pre", { id: "as-fretting", tabindex: "0" }),
        note: element("p", { id: "loads-note", class: "note", "aria-live": "polite" }),
    };
}

function showEntries({ typed }, state) {
    if (state.material) typed.material.closest("details").open = true;
    for (const [name, part] of Object.entries(typed))
        if (part.type === "checkbox") part.checked = state[name] === "stress";
        else if (document.activeElement !== part) part.value = state[name];
}

const typedIn = (part) => (part.type !== "checkbox" ? part.value : part.checked ? "stress" : "");

function showCommand({ command }, state, answer, model) {
    const hasTable = state.loads.trim() !== "";
    command.textContent = answer.complaint ? "" : asFretting(model, answer, state.cycles.trim(), hasTable);
}

function showRemark({ typed, note }, state, answer) {
    typed.loads.setAttribute("aria-invalid", Boolean(answer.complaint));
    note.className = answer.complaint ? "note bad" : "note";
    note.textContent = remarkOf(answer, state);
}

/** The worst places and the plots. show(found, model) draws none of them where there is a complaint. */
function makeAnswers() {
    let answer, unit;
    const numbers = element("div", { class: "wide" });
    const fatigue = curvePlot("criterion", () => surfaceTable(answer, unit));
    const slip = curvePlot("slip", () => surfaceTable(answer, unit));
    const loop = curvePlot("loop", () => loopTable(answer));
    const show = (present, model) => {
        answer = present;
        unit = model.unit;
        const none = Boolean(answer.complaint);
        numbers.innerHTML = none ? "" : sentenceText(answer, model) + worstText(answer, model);
        fatigue.draw(none ? "" : fatigueOf(answer, model));
        slip.draw(none ? "" : alongOf(answer, model, "slip_range", "range of slip along the surface"));
        loop.draw(none ? "" : loopOf(answer, model));
    };
    return { parts: [numbers, ...fatigue.parts, ...slip.parts, ...loop.parts], show };
}

/** Folded: the constants; the criterion and the switch stand in a line. */
function criterionParts({ criterion, plane, material }) {
    const names =
        "Constants of the material, a name and a number a line, or JSON: as \u201crwedge fretting --material\u201d";
    return [
        element(
            "p",
            { class: "tools" },
            element("label", { for: "criterion" }, "Criterion"),
            criterion,
            plane,
            element("label", { for: "plane" }, "plane stress"),
        ),
        element(
            "details",
            {},
            element("summary", {}, "Constants of the material: limit and life"),
            element("label", { for: "material" }, names),
            material,
        ),
    ];
}

function panelOf({ typed, note, command }, answers) {
    const { loads, cycles } = typed;
    const title = "Loads of a cycle, pasted from a spreadsheet: columns P and Q, perhaps M and sigma";
    const times = element("label", { for: "cycles" }, "gone through");
    return element(
        "div",
        {},
        element("label", { for: "loads" }, title),
        loads,
        element("p", { class: "tools" }, times, cycles, "times; the last time counts"),
        ...criterionParts(typed),
        note,
        element("h2", {}, "Worst places"),
        ...answers.parts,
        element(
            "details",
            {},
            element("summary", {}, "This cycle as a command"),
            copyButton("Copy the command", () => command.textContent),
            command,
        ),
    );
}

const chosenBy = ({ criterion, plane, material }) => ({ name: criterion, isPlaneStress: plane === "stress", material });

export function makeCycle(state, changed) {
    const entries = makeEntries(),
        answers = makeAnswers(),
        aside = new Aside("cycle");
    const panel = panelOf(entries, answers);
    let model;
    const draw = (answer) => {
        panel.removeAttribute("aria-busy");
        showRemark(entries, state, answer);
        showCommand(entries, state, answer, model);
        answers.show(answer, model);
        const drawing = document.querySelector(".drawing svg");
        if (drawing) markWorst(drawing, answer.worst?.[answer.criterion.name]?.x);
    };
    const show = (present) => {
        model = present;
        showEntries(entries, state);
        panel.setAttribute("aria-busy", "true");
        aside.ask([model.texts, state.loads, state.sign, state.cycles, chosenBy(state)], draw);
    };
    for (const [name, part] of Object.entries(entries.typed))
        part.addEventListener(part.tagName === "SELECT" ? "change" : "input", () => {
            state[name] = typedIn(part);
            show(model);
            changed();
        });
    return { panel, show };
}
