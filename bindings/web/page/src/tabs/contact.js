// SPDX-License-Identifier: GPL-3.0-or-later
// The tab Contact: pressure and shear along the surface, the stick zone, and all results.
import { html } from "lit-html";
import { remembered } from "../parts.js";
import { isOffCentre } from "../answers/solution.js";
import { groups, ofEdges, symbols } from "./symbols.js";
import { resultKinds } from "../answers/words.js";
import { curvesText } from "../plot/curves.js";
import { curvePlot, noResults } from "../plot/live.js";
import { withUnit } from "../model.js";
import { placesAcross } from "../answers/stresses.js";
import { resultRow, table } from "./table.js";

const minus = (numbers) => numbers.map((v) => -v + 0);

function tractions({ contact, setup, results }) {
    const x = placesAcross(results.left, results.right, 400),
        { p, q } = contact.tractions(x);
    return [
        { name: "pressure \u2212p", column: "minus_p", style: "one", x, y: minus(p) },
        ...(setup.f > 0
            ? [
                  { name: "shear \u2212q", column: "minus_q", style: "two", x, y: minus(q) },
                  { name: "limit f|p|", column: "f_p", style: "thin", x, y: p.map((v) => setup.f * Math.abs(v)) },
              ]
            : []),
    ];
}

function plotOf(model, curves) {
    const slips = model.zones.some(({ slip }) => slip === 0) ? "slips" : "slides";
    const bands = model.zones.map(({ from, to, slip }) =>
        slip === 0 ? { from, to, style: "stick", name: "sticks" } : { from, to, style: "slip", name: slips });
    return {
        title: "Pressure and shear traction along the surface",
        curves,
        bands: model.setup.f === 0 ? [] : bands,
        xLabel: withUnit("x", model.unit.length),
        yLabel: withUnit("traction", model.unit.stress),
    };
}

/** The results of a group as people write them; the rows of all quantities have the tool's names. */
function groupPart(model, { title, names }) {
    const shown = names.filter((name) => isOffCentre(model.setup) || !ofEdges.includes(name));
    const rows = shown.map((name) => ({ ...resultRow(model, name), symbol: symbols[name] }));
    return rows.some(({ value }) => value !== "") ? html`<h2>${title}</h2>${table(title, rows)}` : "";
}

/** As a picture of a report. */
export const tractionsText = (model) => curvesText(plotOf(model, tractionsOf(model)));

const equationLine = ({ unit, write }, { name, symbols, numbers, value, unit: dimension }) =>
    html`<p class="equation"><b>${name}</b> = ${symbols} = <code>${numbers}</code> = <b>${write(value)}</b> ${unit[dimension]}</p>`;

const allRows = (model) => Object.keys(resultKinds).map((name) => resultRow(model, name));
const tractionsOf = remembered(tractions);

export function contact(model) {
    const { results, unit } = model,
        curves = results && tractionsOf(model);
    const columns = () => [
        { name: "x", unit: unit.length, numbers: curves[0].x },
        ...curves.map(({ column, y }) => ({ name: column, unit: unit.stress, numbers: y })),
    ];
    return html`${curvePlot("tractions", curves ? plotOf(model, curves) : noResults, columns)}
        <p class="note">Pressure and shear are drawn upwards. Blue ground: sticks; red ground: slips.</p>
        <div class="wide few">${curves && groups.map((group) => groupPart(model, group))}</div>
        <details><summary>All quantities, by the tool\u2019s names</summary>
            <div class="wide">${curves && table("All quantities", allRows(model))}</div></details>
        <details id="equations"><summary>Formulas with the numbers put in</summary>
            ${model.equations?.map((equation) => equationLine(model, equation))}</details>`;
}
