// SPDX-License-Identifier: GPL-3.0-or-later
// A plot of curves on the page: it is saved, it tells the values under the pointer, and its curves can be pinned beside the next case.
import { element } from "../elements.js";
import { shown, writeNumber } from "../number.js";
import { curvesText, valuesUnder } from "./curves.js";
import { savedPlot } from "./save.js";

/** A point of the pointer in the units of the view box. */
export function inViewBox(svg, event) {
    const rect = svg.getBoundingClientRect();
    const [, , width, height] = svg.getAttribute("viewBox").split(" ").map(Number);
    return [((event.clientX - rect.left) / rect.width) * width, ((event.clientY - rect.top) / rect.height) * height];
}

function valuesText(values) {
    const number = (value) => writeNumber(value, 4, shown.sign);
    const places = new Set(values.map(({ x }) => number(x)));
    const each = values.map(({ name, x, y }) => `${name} ${number(y)}${places.size > 1 ? ` at ${number(x)}` : ""}`);
    return `${places.size === 1 ? `at ${[...places][0]}: ` : ""}${each.join("; ")}`;
}

/** Its parts, and draw(spec): what curvesText() takes, or a text that says why there is none. */
export function curvePlot(name, table) {
    const saved = savedPlot(name, table),
        values = element("p", { class: "note under-pointer" });
    let spec = null,
        pinned = [];
    const redraw = () => saved.draw(spec ? curvesText({ ...spec, pinned }) : "");
    const pin = element("button", { type: "button", "aria-pressed": "false" }, "Pin these curves");
    pin.addEventListener("click", () => {
        pinned = pinned.length > 0 ? [] : spec.curves;
        pin.setAttribute("aria-pressed", pinned.length > 0);
        redraw();
    });
    saved.buttons.append(" ", pin);
    saved.plot.addEventListener("pointermove", (event) => {
        const svg = saved.plot.querySelector("svg");
        if (spec && svg) values.textContent = valuesText(valuesUnder(spec, ...inViewBox(svg, event)));
    });
    const draw = (wanted) => {
        spec = typeof wanted === "string" ? null : wanted;
        if (spec) redraw();
        else saved.draw(wanted);
        values.textContent = spec ? "Point at the curves to read them." : "";
    };
    return { plot: saved.plot, parts: [saved.plot, values, saved.buttons], draw };
}
