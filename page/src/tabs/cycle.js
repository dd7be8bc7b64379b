// SPDX-License-Identifier: GPL-3.0-or-later
// The tab Cycle: a table of loads, what its last cycle does along the surface, the worst places, and the loop.
import { element } from "../elements.js";
import { lastCycle } from "../cycle/last_cycle.js";
import { loopOf } from "../cycle/loop.js";
import { readLoads } from "../cycle/loads_table.js";
import { measureKinds, measure } from "../cycle/measures.js";
import { usualPlaces, worstPlaces } from "../cycle/surface.js";
import { readCase } from "../case/contact_case.js";
import { roomy } from "../plot/axes.js";
import { curvesText } from "../plot/curves.js";
import { saveButtons } from "../plot/save.js";
import { withUnit } from "../model.js";
import { tableText } from "./table.js";

const LONGEST = 2000; // loads times cycles that are computed while one types

/** Without a table: Q to and fro under constant P. */
export function usualLoads({ P, Q, f }) {
    const most = Q !== 0 ? Math.abs(Q) : 0.5 * f * P;
    return `P\tQ\n${P}\t${most}\n${P}\t${-most}`;
}

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

function compute(model, text, cycles) {
    const { what, complaints } = readCase(model.texts, { withLoads: false });
    if (complaints) return { complaint: complaints.map((c) => c.text).join("; ") };
    const { loads, complaint } = readLoads(text || usualLoads(what));
    if (complaint) return { complaint };
    if (!Number.isInteger(cycles) || cycles < 1) return { complaint: "cycles must be a whole number from 1" };
    if (loads.length * cycles > LONGEST)
        return {
            complaint: `loads times cycles must not exceed ${LONGEST} here; the command "rwedge fretting" takes more`,
        };
    const of = lastCycle(what, loads, cycles);
    if (of.complaint) return of;
    const x = usualPlaces(of);
    if (!x) return { complaint: "there is no contact in the cycle" };
    const measured = measure(of, x),
        worst = worstPlaces(of, x, measured);
    const loop = loopOf(of, worst.energy_per_area?.x);
    of.free();
    return { x, measured, worst, loop, slipKnown: of.slipKnown };
}

/** One plot with its buttons; hidden where there is nothing to draw. */
function plotBox(name, table) {
    const plot = element("div"),
        box = element(
            "div",
            {},
            plot,
            saveButtons(name, () => plot.querySelector("svg"), table),
        );
    return { box, draw: (text) => ((box.hidden = !text), (plot.innerHTML = text ?? "")) };
}

export function makeCycle(state, changed) {
    const loads = element("textarea", { id: "loads", rows: 5, spellcheck: "false", "aria-describedby": "loads-note" });
    const cycles = element("input", { id: "cycles", type: "text", size: 4, inputmode: "numeric" });
    const note = element("p", { id: "loads-note", class: "note", "aria-live": "polite" }),
        numbers = element("div", { class: "wide" });
    let found = {},
        model;
    const all = () => ({
        names: ["x", ...measureKinds.map((m) => m.name)],
        rows: Array.from(found.x, (x, i) => [x, ...measureKinds.map((m) => found.measured[m.name][i])]),
    });
    const plots = {
        swt: plotBox("swt", all),
        slip_range: plotBox("slip", all),
        loop: plotBox("loop", () => ({
            names: [found.loop.xName.replaceAll(" ", "_"), found.loop.yName],
            rows: found.loop.x.map((v, i) => [v, found.loop.y[i]]),
        })),
    };
    const along = (name, title) => {
        const worst = found.worst[name];
        return (
            worst &&
            curvesText({
                title,
                curves: [{ name: title, style: "one", x: found.x, y: found.measured[name] }],
                points: [{ ...worst, y: worst.value, name: model.write(worst.value) }],
                xLabel: withUnit("x", model.unit.length),
                yLabel: withUnit(name, unitOf(name, model.unit)),
            })
        );
    };
    const loopText = ({ x, y, xName, yName, whole, place }) => {
        const name = whole
            ? "tangential load over displacement by slip"
            : `shear traction over slip at x = ${model.write(place)}`;
        return curvesText({
            title: `Loop of the cycle: ${name}`,
            curves: [{ name, style: "one", x, y }],
            xDomain: roomy([Math.min(...x), Math.max(...x)]),
            xLabel: withUnit(xName, model.unit.length),
            yLabel: withUnit(yName, whole ? model.unit["force/length"] : model.unit.stress),
        });
    };
    const draw = () => {
        plots.swt.draw(along("swt", "Smith\u2013Watson\u2013Topper along the surface"));
        plots.slip_range.draw(along("slip_range", "range of slip along the surface"));
        plots.loop.draw(found.loop && loopText(found.loop));
        numbers.innerHTML = tableText(
            "The worst places",
            measureKinds
                .filter(({ name }) => found.worst[name])
                .map(({ name, meaning }) => ({
                    name,
                    value: model.write(found.worst[name].value),
                    unit: unitOf(name, model.unit),
                    meaning: `at x = ${model.write(found.worst[name].x)}: ${meaning}`,
                })),
        );
    };
    const show = (present) => {
        model = present;
        if (document.activeElement !== loads) loads.value = state.loads;
        if (document.activeElement !== cycles) cycles.value = state.cycles;
        found = compute(model, state.loads, Number(state.cycles));
        const bad = Boolean(found.complaint);
        note.className = bad ? "note bad" : "note";
        loads.setAttribute("aria-invalid", bad);
        note.textContent =
            found.complaint ??
            (state.loads.trim() ? "" : "No table is given: this is Q to and fro under constant P. ") +
                (found.slipKnown ? "" : "The slip has no closed form after these loads.");
        const { what } = readCase(model.texts, { withLoads: false });
        loads.placeholder = what ? usualLoads(what) : "P\tQ";
        if (!bad) return draw();
        numbers.textContent = "";
        for (const one of Object.values(plots)) one.draw(null);
    };
    const again = (name, input) =>
        input.addEventListener("input", () => {
            state[name] = input.value;
            show(model);
            changed();
        });
    again("loads", loads);
    again("cycles", cycles);
    const panel = element(
        "div",
        {},
        element(
            "label",
            { for: "loads" },
            "Loads of a cycle, pasted from a spreadsheet: columns P and Q, perhaps M and sigma",
        ),
        loads,
        element(
            "p",
            { class: "tools" },
            element("label", { for: "cycles" }, "gone through"),
            cycles,
            "times; the last time counts",
        ),
        note,
        element("h2", {}, "Worst places"),
        numbers,
        ...Object.values(plots).map((one) => one.box),
    );
    return { panel, show };
}
