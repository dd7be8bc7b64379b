// SPDX-License-Identifier: GPL-3.0-or-later
// A plot as a file: SVG and PNG as it is drawn, in light colours and with white ground; CSV with all digits.
import { html } from "lit-html";
import { csvText, download, escaped, fileName } from "../parts.js";
import { shortNumber, state } from "../state.js";
import plotStyle from "./plot.css";

/** The style with its colours written out, those of light mode: few programs that open an SVG know variables. */
export function styleOfFile() {
    const light = Object.fromEntries(
        [...plotStyle.matchAll(/(--[\w-]+):\s*light-dark\(([^,]+),/g)].map((m) => [m[1], m[2]]),
    );
    const rules = plotStyle.replace(/\/\*.*?\*\/|:root\s*\{[^}]*\}/g, "");
    return rules.replace(/var\((--[\w-]+)\)/g, (_, name) => light[name]);
}

let carried = []; // the inputs of the case, as texts
/** Files of plots have these with them. */
export const carry = (texts) => (carried = texts);

const CHARACTER = 7.4, // pixels, of a line below a plot
    LINE = 15;
/** The inputs in lines below a plot. */
function caption(width, height) {
    const lines = [""],
        room = (width - 16) / CHARACTER;
    for (const text of carried)
        if (lines.at(-1) && lines.at(-1).length + 2 + text.length > room) lines.push(text);
        else lines[lines.length - 1] += `${lines.at(-1) && "; "}${text}`;
    const texts = lines.map((line, i) => `<text class="legend" x="8" y="${height + LINE * (i + 1)}">${escaped(line)}</text>`);
    return { text: texts.join(""), height: height + LINE * (lines.length + 0.5) };
}

const sizeOf = (svg) => [svg.viewBox.baseVal.width, svg.viewBox.baseVal.height];

function svgText(svg) {
    const copy = svg.cloneNode(true),
        [width, ofPlot] = sizeOf(svg),
        { text, height } = caption(width, ofPlot),
        { x, y } = svg.viewBox.baseVal;
    const about = { xmlns: "http://www.w3.org/2000/svg", width, height, viewBox: `${x} ${y} ${width} ${height}` };
    for (const [name, value] of Object.entries(about)) copy.setAttribute(name, value);
    const ground = `<style>${styleOfFile()}</style><rect width="100%" height="100%" fill="#fff"/>`;
    copy.insertAdjacentHTML("afterbegin", ground);
    copy.insertAdjacentHTML("beforeend", text);
    return { text: new XMLSerializer().serializeToString(copy), width, height };
}

function savePng(name, svg) {
    const file = svgText(svg),
        [width, height] = [file.width, file.height].map((size) => 2 * size),
        image = new Image();
    image.onload = () => {
        const canvas = Object.assign(document.createElement("canvas"), { width, height });
        canvas.getContext("2d").drawImage(image, 0, 0, width, height);
        canvas.toBlob((blob) => download(name, blob, "image/png"), "image/png");
    };
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(file.text)}`;
}

/** Columns as the tool writes them, below the inputs in lines that it passes over. */
function linesOf(columns) {
    const heads = columns.map(({ name, unit }) => (unit ? `${name} [${unit}]` : name));
    const cell = (value) => (value === null || Number.isNaN(value) ? "" : shortNumber(value));
    return [...carried.map((text) => [`# ${text}`]), heads, ...Array.from(columns[0].numbers, (_, i) => columns.map(({ numbers }) => cell(numbers[i])))];
}

const forms = {
    SVG: (name, svg) => download(name, svgText(svg).text, "image/svg+xml"),
    PNG: savePng,
    CSV: (name, _, columns) => download(name, csvText(linesOf(columns())), "text/csv"),
};

/** Buttons for the plot in the element plot-NAME; columns() are those of its table, [{ name, unit, numbers }]. */
export const saveButtons = (name, columns, isDrawn, more = "") => html`<p class="tools save" ?hidden=${!isDrawn}>Save as
    ${Object.entries(forms).map(
        ([form, save]) => html`<button type="button" aria-label="Save ${name} as ${form}"
            @click=${() => save(`${fileName(name)}.${form.toLowerCase()}`, document.querySelector(`#plot-${name} svg`), columns)}>${form}</button> `,
    )}${more}</p>`;
