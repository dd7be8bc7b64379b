// SPDX-License-Identifier: GPL-3.0-or-later
// The tab Cycle: a table of loads, what its last cycle does along the surface, the worst places, and the loop.
import { element } from "../elements.js";
import { answerOf, usualLoads } from "../cycle/answer.js";
import { measureKinds } from "../cycle/measures.js";
import { readCase } from "../case/contact_case.js";
import { roomy } from "../plot/axes.js";
import { curvesText } from "../plot/curves.js";
import { savedPlot } from "../plot/save.js";
import { withUnit } from "../model.js";
import { tableText } from "./table.js";

function unitOf(name, unit) {
    return (
        {
            stress_range: unit.stress,
            swt: unit.stress,
            slip_range: unit.length,
            ruiz_f1: unit["force/length"],
            ruiz_f2: `${unit["force/length"]}\u00b7${unit.stress}`,
            energy_per_area: unit["force/length"],
        }[name] ?? ""
    );
}

/** A measure along the surface, and where it is worst. */
function alongText({ x, measured, worst }, { unit, write }, name, title) {
    const top = worst[name];
    if (!top) return "";
    return curvesText({
        title,
        curves: [{ name: title, style: "one", x, y: measured[name] }],
        points: [{ x: top.x, y: top.value, name: write(top.value) }],
        xLabel: withUnit("x", unit.length),
        yLabel: withUnit(name, unitOf(name, unit)),
    });
}

function loopText({ loop }, { unit, write }) {
    if (!loop) return "";
    const ofPlace = `shear traction over slip at x = ${write(loop.place)}`;
    const name = loop.whole ? "tangential load over displacement by slip" : ofPlace;
    return curvesText({
        title: `Loop of the cycle: ${name}`,
        curves: [{ name, style: "one", x: loop.x, y: loop.y }],
        xDomain: roomy([Math.min(...loop.x), Math.max(...loop.x)]),
        xLabel: withUnit(loop.xName, unit.length),
        yLabel: withUnit(loop.yName, loop.whole ? unit["force/length"] : unit.stress),
    });
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

function surfaceTable({ x, measured }) {
    const names = measureKinds.map((kind) => kind.name);
    return { names: ["x", ...names], rows: Array.from(x, (v, i) => [v, ...names.map((name) => measured[name][i])]) };
}

function loopTable({ loop }) {
    return { names: [loop.xName.replaceAll(" ", "_"), loop.yName], rows: loop.x.map((v, i) => [v, loop.y[i]]) };
}

function remarkOf(found, state) {
    if (found.complaint) return found.complaint;
    const usual = state.loads.trim() ? "" : "No table is given: this is Q to and fro under constant P. ";
    return usual + (found.slipKnown ? "" : "The slip has no closed form after these loads.");
}

/** What is typed, and the remark on it. */
function makeEntries() {
    return {
        loads: element("textarea", { id: "loads", rows: 5, spellcheck: "false", "aria-describedby": "loads-note" }),
        cycles: element("input", { id: "cycles", type: "text", size: 4, inputmode: "numeric" }),
        note: element("p", { id: "loads-note", class: "note", "aria-live": "polite" }),
    };
}

function showEntries({ loads, cycles, note }, state, texts, found) {
    if (document.activeElement !== loads) loads.value = state.loads;
    if (document.activeElement !== cycles) cycles.value = state.cycles;
    const { what } = readCase(texts, { withLoads: false });
    loads.placeholder = what ? usualLoads(what) : "P\tQ";
    loads.setAttribute("aria-invalid", Boolean(found.complaint));
    note.className = found.complaint ? "note bad" : "note";
    note.textContent = remarkOf(found, state);
}

/** The worst places and the plots. show(found, model) draws none of them where there is a complaint. */
function makeAnswers() {
    let found;
    const numbers = element("div", { class: "wide" });
    const swt = savedPlot("swt", () => surfaceTable(found));
    const slip = savedPlot("slip", () => surfaceTable(found));
    const loop = savedPlot("loop", () => loopTable(found));
    const show = (present, model) => {
        found = present;
        const none = Boolean(found.complaint);
        numbers.innerHTML = none ? "" : worstText(found, model);
        swt.draw(none ? "" : alongText(found, model, "swt", "Smith\u2013Watson\u2013Topper along the surface"));
        slip.draw(none ? "" : alongText(found, model, "slip_range", "range of slip along the surface"));
        loop.draw(none ? "" : loopText(found, model));
    };
    return { parts: [numbers, ...swt.parts, ...slip.parts, ...loop.parts], show };
}

function panelOf({ loads, cycles, note }, answers) {
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
    );
}

export function makeCycle(state, changed) {
    const entries = makeEntries(),
        answers = makeAnswers();
    let model;
    const show = (present) => {
        model = present;
        const found = answerOf(model.texts, state.loads, Number(state.cycles));
        showEntries(entries, state, model.texts, found);
        answers.show(found, model);
    };
    for (const name of ["loads", "cycles"])
        entries[name].addEventListener("input", () => {
            state[name] = entries[name].value;
            show(model);
            changed();
        });
    return { panel: panelOf(entries, answers), show };
}
