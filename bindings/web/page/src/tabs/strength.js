// SPDX-License-Identifier: GPL-3.0-or-later
// The tab Strength: the elastic limit over friction for this a/b, its two branches, the present point, both safeties.
import { html } from "lit-html";
import { orNull, rwedge } from "../answers/library.js";
import { remembered } from "../parts.js";
import { isOffCentre } from "../answers/solution.js";
import { curvePlot, noResults } from "../plot/live.js";
import { resultRow, table } from "./table.js";

const COUNT = 101;

/** Friction from 0 on, as far as the tables go and beyond the present one. */
const frictions = (f) => Float64Array.from({ length: COUNT }, (_, i) => (Math.max(0.8, 1.25 * f) * i) / (COUNT - 1));

function branches({ setup, results }) {
    const alpha = results.a_over_b,
        f = frictions(setup.f);
    const each = (branch) => f.map((v) => orNull(() => branch(alpha, v, setup.nu1))?.limit ?? NaN);
    return [
        {
            name: "elastic limit",
            column: "P_over_bk",
            style: "one",
            x: f,
            y: rwedge.elastic_limit(alpha, f, setup.nu1),
        },
        { name: "below surface", column: "P_over_bk_subsurface", style: "two", x: f, y: each(rwedge.subsurface_yield) },
        { name: "at surface", column: "P_over_bk_surface", style: "three", x: f, y: each(rwedge.surface_yield) },
    ];
}

/** The load of the case, where a yield stress is given. */
function presentPoint({ setup, results, write }) {
    const y = results.load_over_bk;
    return y === null ? [] : [{ x: setup.f, y, name: `this load, P/(bk) = ${write(y)}`, below: true }];
}

/** Where yield moves to the surface: the limit has a kink there. */
function criticalPoint({ setup, results }) {
    const x = results.f_critical;
    if (!(x > 0)) return [];
    return [{ x, y: rwedge.elastic_limit(results.a_over_b, x, setup.nu1), name: "critical friction" }];
}

/** A branch far above the limit is left out of the picture, not out of the table. */
function plotOf(model, curves) {
    const { results, write } = model,
        present = presentPoint(model);
    const highest = Math.max(...curves[0].y, ...present.map((p) => p.y));
    const shown = curves.map((c, i) => (i === 0 ? c : { ...c, y: c.y.map((v) => (v > 1.2 * highest ? NaN : v)) }));
    return {
        title: `Elastic limit over friction for a/b = ${write(results.a_over_b)}`,
        curves: shown,
        points: [...criticalPoint(model), ...present],
        xLabel: "coefficient of friction f",
        yLabel: "P/(bk)",
        yDomain: [0, 1.25 * highest],
    };
}

const shownRows = {
    a_over_b: "of this contact: the limit below is for it",
    load_over_bk: "of the load given",
    P_over_bk: "it yields above, in full sliding",
    P_yield: "with the contact that it makes",
    safety: "on load: P may grow by this factor, and the contact grows with it",
    safety_strength: "on strength: k or Y may fall by this factor under this P",
    yield_factor: "k over the largest sqrt(J2) under P and Q as they are",
    f_critical: "above it, yield starts at the surface",
    yield_branch: "where, at that load",
    yield_x: "",
    yield_y: "",
};

const ofWedge = "The limits over friction are drawn for a wedge alone; the numbers below hold for this pad.";

/** Why nothing is drawn; empty where it is. */
function reasonFor({ pad, results }) {
    if (!results) return noResults;
    if (pad !== "wedge") return ofWedge;
    if (results.a_over_b === 0) return "A sharp wedge yields under any load: its elastic limit is 0.";
    return results.a_over_b < 1e-14 ? "a/b must be 0 or at least 1e-14 here." : "";
}

const numbers = (model) =>
    table(
        "Strength",
        Object.entries(shownRows).map(([name, meaning]) => ({ ...resultRow(model, name), meaning })),
    );

const offCentreRemark =
    "Moment and bulk tension are not in these limits: they are those of full sliding under P alone. The yield factor has them.";
const branchesOf = remembered(branches);

export function strength(model) {
    const reason = reasonFor(model),
        curves = !reason && branchesOf(model);
    const columns = () => [
        { name: "f", numbers: curves[0].x },
        ...curves.map(({ column, y }) => ({ name: column, numbers: y })),
    ];
    return html`${curvePlot("elastic-limit", reason || plotOf(model, curves), columns)}
        <p class="note">${!reason && isOffCentre(model.setup) ? offCentreRemark : ""}</p>
        <div class="wide">${!reason || (model.results && model.pad !== "wedge") ? numbers(model) : ""}</div>`;
}
