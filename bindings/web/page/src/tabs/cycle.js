// SPDX-License-Identifier: GPL-3.0-or-later
// The tab Cycle: a table of loads, what its last cycle does along the surface, the worst places, and the loop.
import { copyButton, element } from "../elements.js";
import { Aside } from "../aside.js";
import { asFretting } from "../export.js";
import { roomy } from "../plot/axes.js";
import { curvePlot } from "../plot/live.js";
import { withUnit } from "../model.js";
import { measureKinds } from "../words.js";
import { tableText } from "./table.js";

const unitOf = (name, unit) => unit[measureKinds.find((kind) => kind.name === name).unit];

/** A measure along the surface, and where it is worst. */
function alongOf({ x, measured, worst }, { unit, write }, name, title) {
    const top = worst[name];
    if (!top) return "";
    return {
        title,
        curves: [{ name: title, style: "one", x, y: measured[name] }],
        points: [{ x: top.x, y: top.value, name: write(top.value) }],
        xLabel: withUnit("x", unit.length),
        yLabel: withUnit(name, unitOf(name, unit)),
    };
}

function loopOf({ loop }, { unit, write }) {
    if (!loop) return "";
    const ofPlace = `shear traction over slip at x = ${write(loop.place)}`;
    const name = loop.whole ? "tangential load over displacement by slip" : ofPlace;
    return {
        title: `Loop of the cycle: ${name}`,
        curves: [{ name, style: "one", x: loop.x, y: loop.y }],
        xDomain: roomy([Math.min(...loop.x), Math.max(...loop.x)]),
        xLabel: withUnit(loop.xName, unit.length),
        yLabel: withUnit(loop.yName, loop.whole ? unit["force/length"] : unit.stress),
    };
}

function worstText({ worst }, { unit, write }) {
    const there = measureKinds.filter(({ name }) => worst[name]);
    const rows = there.map(({ name, meaning }) => ({
        name,
        value: write(worst[name].value),
        unit: unitOf(name, unit),
        meaning: `at x = ${write(worst[name].x)}: ${meaning}`,
    }));
    return tableText("The worst places", rows);
}

function surfaceTable({ x, measured }, unit) {
    const names = measureKinds.map((kind) => kind.name);
    const units = [unit.length, ...measureKinds.map((kind) => unit[kind.unit])];
    return {
        names: ["x", ...names],
        units,
        rows: Array.from(x, (v, i) => [v, ...names.map((name) => measured[name][i])]),
    };
}

function loopTable({ loop }) {
    return { names: [loop.xName.replaceAll(" ", "_"), loop.yName], rows: loop.x.map((v, i) => [v, loop.y[i]]) };
}

function remarkOf(found, state) {
    if (found.complaint) return found.complaint;
    const usual = "No table is given: P and M of the case come first, then its Q and \u03c3 go to and fro";
    const slip = "The slip has no closed form after these loads";
    return [!state.loads.trim() && usual, found.unused, !found.slipKnown && slip].filter(Boolean).join(". ");
}

/** What is typed, and the remark on it. */
function makeEntries() {
    return {
        loads: element("textarea", {
            id: "loads",
            rows: 5,
            spellcheck: "false",
            placeholder: "P\tQ",
            "aria-describedby": "loads-note",
        }),
        cycles: element("input", { id: "cycles", type: "text", size: 4, inputmode: "numeric" }),
        command: element("pre", { id: "as-fretting", tabindex: "0" }),
        note: element("p", { id: "loads-note", class: "note", "aria-live": "polite" }),
    };
}

function showEntries({ loads, cycles }, state) {
    if (document.activeElement !== loads) loads.value = state.loads;
    if (document.activeElement !== cycles) cycles.value = state.cycles;
}

function showCommand({ command }, state, found, model) {
    const hasTable = state.loads.trim() !== "";
    command.textContent = found.complaint ? "" : asFretting(model, found, state.cycles.trim(), hasTable);
}

function showRemark({ loads, note }, state, found) {
    loads.setAttribute("aria-invalid", Boolean(found.complaint));
    note.className = found.complaint ? "note bad" : "note";
    note.textContent = remarkOf(found, state);
}

/** The worst places and the plots. show(found, model) draws none of them where there is a complaint. */
function makeAnswers() {
    let found, unit;
    const numbers = element("div", { class: "wide" });
    const swt = curvePlot("swt", () => surfaceTable(found, unit));
    const slip = curvePlot("slip", () => surfaceTable(found, unit));
    const loop = curvePlot("loop", () => loopTable(found));
    const show = (present, model) => {
        found = present;
        unit = model.unit;
        const none = Boolean(found.complaint);
        numbers.innerHTML = none ? "" : worstText(found, model);
        swt.draw(none ? "" : alongOf(found, model, "swt", "Smith\u2013Watson\u2013Topper along the surface"));
        slip.draw(none ? "" : alongOf(found, model, "slip_range", "range of slip along the surface"));
        loop.draw(none ? "" : loopOf(found, model));
    };
    return { parts: [numbers, ...swt.parts, ...slip.parts, ...loop.parts], show };
}

function panelOf({ loads, cycles, note, command }, answers) {
    const title = "Loads of a cycle, pasted from a spreadsheet: columns P and Q, perhaps M and sigma";
    const times = element("label", { for: "cycles" }, "gone through");
    return element(
        "div",
        {},
        element("label", { for: "loads" }, title),
        loads,
        element("p", { class: "tools" }, times, cycles, "times; the last time counts"),
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

export function makeCycle(state, changed) {
    const entries = makeEntries(),
        answers = makeAnswers(),
        aside = new Aside("cycle");
    const panel = panelOf(entries, answers);
    let model;
    const draw = (found) => {
        panel.removeAttribute("aria-busy");
        showRemark(entries, state, found);
        showCommand(entries, state, found, model);
        answers.show(found, model);
    };
    const show = (present) => {
        model = present;
        showEntries(entries, state);
        panel.setAttribute("aria-busy", "true");
        aside.ask([model.texts, state.loads, state.sign, state.cycles], draw);
    };
    for (const name of ["loads", "cycles"])
        entries[name].addEventListener("input", () => {
            state[name] = entries[name].value;
            show(model);
            changed();
        });
    return { panel, show };
}
