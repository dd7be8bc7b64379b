// SPDX-License-Identifier: GPL-3.0-or-later
// A plot of curves on the page: it is saved, it tells the values under the pointer, and its curves can be pinned beside the next case.
import { html } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { redraw, written } from "../state.js";
import { curvesText, valuesUnder } from "./curves.js";
import { saveButtons } from "./save.js";

/** A point of the pointer in the units of the view box. */
export function inViewBox(svg, { clientX, clientY }) {
    const { x, y } = new DOMPoint(clientX, clientY).matrixTransform(svg.getScreenCTM().inverse());
    return [x, y];
}

function valuesText(values) {
    const number = (value) => written(value, 4);
    const places = new Set(values.map(({ x }) => number(x)));
    const each = values.map(({ name, x, y }) => `${name} ${number(y)}${places.size > 1 ? ` at ${number(x)}` : ""}`);
    return `${places.size === 1 ? `at ${[...places][0]}: ` : ""}${each.join("; ")}`;
}

export const noResults = "No results: the status says why.";

const pins = {}; // curves of another case, by the name of their plot

/** spec: what curvesText() takes, or a text that says why there is none; columns() for its file. */
export function curvePlot(name, spec, columns) {
    const isDrawn = typeof spec !== "string",
        pinned = pins[name] ?? [];
    const tell = (event) => {
        const { firstElementChild: svg, nextElementSibling: values } = event.currentTarget;
        if (isDrawn) values.textContent = valuesText(valuesUnder(spec, ...inViewBox(svg, event)));
    };
    const pin = () => {
        pins[name] = pinned.length > 0 ? [] : spec.curves;
        redraw();
    };
    const button = html`<button type="button" aria-pressed=${pinned.length > 0} @click=${pin}>Pin these curves</button>`;
    return html`
        <div id="plot-${name}" .innerHTML=${isDrawn ? curvesText({ ...spec, pinned }) : spec && `<p>${spec}</p>`} @pointermove=${tell}></div>
        <p class="note under-pointer" .textContent=${live(isDrawn ? "Point at the curves to read them." : "")}></p>
        ${saveButtons(name, columns, isDrawn, button)}`;
}
