// SPDX-License-Identifier: GPL-3.0-or-later
// A plot as a file: SVG and PNG as it is drawn, in light colours and with white ground; CSV with all digits.
import { html } from "lit-html";
import { csvText, download } from "../parts.js";
import { shortNumber, state } from "../state.js";
import plotStyle from "./plot.css";

/** The style with its colours written out, those of light mode: few programs that open an SVG know variables. */
function styleOfFile() {
    const light = Object.fromEntries(
        [...plotStyle.matchAll(/(--[\w-]+):\s*light-dark\(([^,]+),/g)].map((m) => [m[1], m[2]]),
    );
    const rules = plotStyle.replace(/\/\*.*?\*\/|:root\s*\{[^}]*\}/g, "");
    return rules.replace(/var\((--[\w-]+)\)/g, (_, name) => light[name]);
}

const sizeOf = (svg) => [svg.viewBox.baseVal.width, svg.viewBox.baseVal.height];

function svgText(svg) {
    const copy = svg.cloneNode(true),
        [width, height] = sizeOf(svg);
    for (const [name, value] of Object.entries({ xmlns: "http://www.w3.org/2000/svg", width, height }))
        copy.setAttribute(name, value);
    copy.insertAdjacentHTML(
        "afterbegin",
        `<style>${styleOfFile()}</style><rect width="100%" height="100%" fill="#fff"/>`,
    );
    return new XMLSerializer().serializeToString(copy);
}

function savePng(name, svg) {
    const [width, height] = sizeOf(svg).map((size) => 2 * size),
        image = new Image();
    image.onload = () => {
        const canvas = Object.assign(document.createElement("canvas"), { width, height });
        canvas.getContext("2d").drawImage(image, 0, 0, width, height);
        canvas.toBlob((blob) => download(name, blob, "image/png"), "image/png");
    };
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svgText(svg))}`;
}

/** Columns as the tool writes them. */
function linesOf(columns) {
    const heads = columns.map(({ name, unit }) => (unit ? `${name} [${unit}]` : name));
    const cell = (value) => (value === null || Number.isNaN(value) ? "" : shortNumber(value));
    return [heads, ...Array.from(columns[0].numbers, (_, i) => columns.map(({ numbers }) => cell(numbers[i])))];
}

const forms = {
    SVG: (name, svg) => download(name, svgText(svg), "image/svg+xml"),
    PNG: savePng,
    CSV: (name, _, columns) => download(name, csvText(linesOf(columns())), "text/csv"),
};

/** A file of a plot is named for the case. */
const fileOf = (name, form) =>
    `${[state.name.replace(/[^\p{L}\p{N}.-]+/gu, "-"), name].filter(Boolean).join("-")}.${form.toLowerCase()}`;

/** Buttons for the plot in the element plot-NAME; columns() are those of its table, [{ name, unit, numbers }]. */
export const saveButtons = (name, columns, isDrawn, more = "") => html`<p class="tools save" ?hidden=${!isDrawn}>Save as
    ${Object.entries(forms).map(
        ([form, save]) => html`<button type="button" aria-label="Save ${name} as ${form}"
            @click=${() => save(fileOf(name, form), document.querySelector(`#plot-${name} svg`), columns)}>${form}</button> `,
    )}${more}</p>`;
