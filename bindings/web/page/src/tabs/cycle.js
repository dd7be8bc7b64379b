// SPDX-License-Identifier: GPL-3.0-or-later
// The tab Cycle: a table of loads, what its last cycle does along the surface, the worst places, and the loop.
import { html, nothing } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { Aside } from "../answers/aside.js";
import { asFretting } from "../export.js";
import { copyButton, options } from "../parts.js";
import { roomy } from "../plot/axes.js";
import { curvePlot } from "../plot/live.js";
import { withUnit } from "../model.js";
import { complianceDimension, redraw, set, setter, state, written } from "../state.js";
import { wordsOf } from "../units.js";
import { bar } from "../verdict.js";
import { criteria, measures } from "../answers/words.js";
import { askedCrack, crackPart } from "./crack.js";
import { lifeBeside, materialPart } from "./material.js";
import { table } from "./table.js";
import { waiting } from "./waiting.js";

const unitOf = (name, unit) => unit[measures[name].unit];

/** A measure along the surface, where it is worst, and its limit. */
function alongOf({ x, measured, worst }, { unit, write }, name, title, limit = null) {
    const top = worst[name];
    if (!top) return "";
    const ends = [x[0], x.at(-1)];
    return {
        title,
        curves: [
            { name: title, style: "one", x, y: measured[name] },
            ...(limit === null ? [] : [{ name: "limit", style: "thin", x: ends, y: [limit, limit] }]),
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

const loopNames = ({ isWhole, isDriven }) => (isDriven ? ["displacement", "Q"] : isWhole ? ["displacement by slip", "Q"] : ["slip", "q"]);

function loopOf({ loop }, { unit, write }) {
    if (!loop) return "";
    const ofPlace = `shear traction over slip at x = ${write(loop.place)}`,
        ofWhole = `tangential load over displacement ${loop.isDriven ? "of the rig" : "by slip"}`,
        name = loop.isWhole ? ofWhole : ofPlace,
        [xName, yName] = loopNames(loop);
    return {
        title: `Loop of the cycle: ${name}`,
        curves: [{ name, style: "one", x: loop.x, y: loop.y }],
        xDomain: roomy([Math.min(...loop.x), Math.max(...loop.x)]),
        xLabel: withUnit(xName, unit.length),
        yLabel: withUnit(yName, loop.isWhole ? unit["force/length"] : unit.stress),
    };
}

/** What the chosen criterion comes to where it is worst, in a sentence, with a bar. */
function sentence({ worst, criterion: { name }, limit, safety, life }, { unit, write }) {
    const { value, x } = worst[name] ?? { value: 0 };
    const place = x === undefined ? "" : ` at x = ${write(x)} ${unit.length}`,
        beside = safety < 1 ? "above" : "below",
        lasts = lifeBeside(life);
    const parts = [
        `${criteria[name]}: ${write(value)} ${unitOf(name, unit)}${place}`,
        safety === null
            ? life === null && "no limit of the material is given"
            : `${beside} its limit ${write(limit)}, a factor of ${write(safety)}`,
        life !== null && (life === Infinity ? "no failure" : `${write(life)} passes of the loads to failure`),
        lasts?.text,
    ];
    return html`<p class="sentence">${parts.filter(Boolean).join("; ")}.</p>
        ${safety === null ? nothing : bar(safety, safety < 1 ? "red" : "green", "the limit")}
        ${lasts && safety === null ? bar(Math.min(lasts.factor, 1e9), lasts.factor < 1 ? "red" : "green", "the cycles wanted") : nothing}`;
}

function verdictRows({ limit, safety, life }, { write }) {
    return [
        { name: "cycle_safety", value: write(safety), meaning: `limit ${write(limit)} over the worst value` },
        { name: "cycle_life", value: write(life), meaning: "passes of the loads to failure; inf for a run-out" },
    ];
}

/** The force that a rig needs. */
function forceRows({ loads, displacements }, { unit, write }) {
    const all = displacements ? loads.map(({ Q }) => Q) : [],
        row = (name, of, meaning) => ({ name, value: write(of), unit: unit["force/length"], meaning });
    const [least, most] = all.reduce(([a, b], Q) => [Math.min(a, Q), Math.max(b, Q)], [Infinity, -Infinity]);
    return all.length === 0 ? [] : [row("Q_min", least, "the smallest Q, which the rig needs"), row("Q_max", most, "the largest Q")];
}

function worstTable(answer, model) {
    const { worst } = answer,
        { unit, write } = model,
        names = Object.keys(worst);
    const rows = names.map((name) => ({
        name,
        value: write(worst[name].value),
        unit: unitOf(name, unit),
        meaning: `at x = ${write(worst[name].x)}: ${measures[name].meaning}`,
    }));
    return table("The worst places", [...rows, ...forceRows(answer, model), ...verdictRows(answer, model)]);
}

const surfaceColumns = ({ x, measured }, unit) => [
    { name: "x", unit: unit.length, numbers: x },
    ...Object.entries(measured).map(([name, numbers]) => ({ name, unit: unitOf(name, unit), numbers })),
];

const loopColumns = ({ loop }) =>
    loopNames(loop).map((name, i) => ({ name: name.replaceAll(" ", "_"), numbers: [loop.x, loop.y][i] }));

function remarkOf(answer) {
    if (answer.complaint !== undefined) return answer.complaint;
    const usual = "No table is given: P and M of the case come first, then its Q and \u03c3 go to and fro";
    const slip = "No slip is known after these loads",
        ofPad = "Cycles are of the half-plane: k of the form, which is the pad\u2019s, does not count here";
    return [state.body && ofPad, !state.loads.trim() && usual, answer.unused, !answer.slipKnown && slip, answer.computed]
        .filter(Boolean)
        .join(". ");
}

/** Where the loads have a displacement in place of Q, or a compliance is typed. */
const hasRig = () => /\bdisplacement/i.test(state.loads.trimStart().split("\n")[0]) || state.compliance.trim() !== "";

const rig = ({ unit }) => html`<p class="tools"><label for="compliance">Compliance of the rig</label>
    <input id="compliance" type="text" size="16" autocomplete="off" spellcheck="false" placeholder="0 where it is stiff"
        aria-describedby="loads-note" .value=${live(state.compliance)} @input=${setter("compliance")}>
    <span class="unit">${unit[complianceDimension()]}</span></p>`;

/** What is typed and chosen. */
const entries = (model) => html`
    <label for="loads">Loads of a cycle, pasted from a spreadsheet: columns P and Q, or the displacement of a rig; perhaps M or tilt, and sigma</label>
    <textarea id="loads" rows="5" placeholder="P\tQ" spellcheck="false" aria-describedby="loads-note"
        aria-invalid=${Boolean(aside.answer?.complaint)} .value=${live(state.loads)} @input=${setter("loads")}></textarea>
    ${hasRig() ? rig(model) : nothing}
    <p class="tools"><label for="cycles">gone through</label>
        <input id="cycles" type="text" size="4" inputmode="numeric" spellcheck="false" .value=${live(state.cycles)}
            @input=${setter("cycles")}>times; the last time counts</p>
    <p class="tools"><label for="criterion">Criterion</label>
        <select id="criterion" @change=${setter("criterion")}>${options(criteria, state.criterion)}</select></p>`;

/** The worst places and the plots; nothing where there is a complaint. Of an answer to other inputs only the plots stay, greyed. */
function answers(answer, model, isOld) {
    const isThere = answer.complaint === undefined,
        onSurface = () => surfaceColumns(answer, model.unit);
    const plot = (name, spec, columns) => curvePlot(name, isThere ? spec(answer, model) : "", columns);
    const slip = () => alongOf(answer, model, "slip_range", "range of slip along the surface");
    return html`<div class=${isOld ? "old" : ""} ?inert=${isOld}>
        <div class="wide">${isThere && !isOld ? [sentence(answer, model), worstTable(answer, model)] : nothing}</div>
        ${plot("criterion", fatigueOf, onSurface)} ${plot("slip", slip, onSurface)}
        ${plot("loop", loopOf, () => loopColumns(answer))}</div>`;
}

export const aside = new Aside("cycle", redraw);

/** The loads and the worst places, where the tab is seen and has them. */
export const cycleSeen = () => (state.tab === "cycle" && aside.answer && aside.answer.complaint === undefined ? aside.answer : null);

/** On the surface, where the tab is seen and there is one. */
export const worstPlace = () =>
    state.tab === "cycle" ? aside.answer?.worst?.[aside.answer.criterion.name]?.x : undefined;

export function cycle(model) {
    const { loads, sign, cycles, criterion: name, plane, material, units } = state;
    const compliance = state.compliance.trim();
    const answer = aside.ask([
        { ...model.texts, ...(compliance && { compliance }) },
        loads,
        sign,
        cycles,
        { name, isPlaneStress: plane === "stress", material, units: wordsOf(units) },
        askedCrack(model),
    ]);
    const shown = answer ?? aside.before ?? { complaint: "" };
    const command = answer && answer.complaint === undefined ? asFretting(model, answer, cycles.trim(), loads.trim() !== "") : "";
    return html`${entries(model)}
        ${materialPart(model)}
        ${waiting(aside)}
        <p id="loads-note" class="note ${answer?.complaint ? "bad" : ""}" aria-live="polite">${answer ? remarkOf(answer) : ""}</p>
        <h2>Worst places</h2>
        ${answers(shown, model, answer === undefined)}
        ${crackPart(shown.crack ?? null, model, answer === undefined)}
        <details><summary>This cycle as a command</summary>${copyButton("Copy the command", () => command)}
            <pre id="as-fretting" tabindex="0">${command}</pre></details>`;
}
