// SPDX-License-Identifier: GPL-3.0-or-later
// A plot as a file: SVG and PNG as it is drawn, in light colours and with white ground; CSV with all digits.
import { download, element } from "../elements.js";
import { shortNumber, shown } from "../number.js";
import plotStyle from "../plot.css";

/** The style with its colours written out: few programs that open an SVG know variables. */
function styleOfFile() {
    const light = Object.fromEntries([...plotStyle.matchAll(/(--[\w-]+):\s*([^;]+);/g)].map((m) => [m[1], m[2]]));
    const rules = plotStyle.replace(/\/\*.*?\*\/|:root\s*\{[^}]*\}/g, "");
    return rules.replace(/var\((--[\w-]+)\)/g, (_, name) => light[name]);
}

function svgText(svg) {
    const copy = svg.cloneNode(true);
    copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
    const [, , width, height] = copy.getAttribute("viewBox").split(" ");
    copy.setAttribute("width", width);
    copy.setAttribute("height", height);
    copy.insertAdjacentHTML(
        "afterbegin",
        `<style>${styleOfFile()}</style><rect width="100%" height="100%" fill="#fff"/>`,
    );
    return new XMLSerializer().serializeToString(copy);
}

function savePng(name, svg) {
    const [, , width, height] = svg.getAttribute("viewBox").split(" ").map(Number);
    const image = new Image(),
        scale = 2;
    image.onload = () => {
        const canvas = element("canvas", { width: scale * width, height: scale * height });
        canvas.getContext("2d").drawImage(image, 0, 0, scale * width, scale * height);
        canvas.toBlob((blob) => download(`${fileOf(name)}.png`, blob), "image/png");
    };
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svgText(svg))}`;
}

/** The file of a plot is named for the case. */
const fileOf = (name) => [shown.name.replace(/[^\p{L}\p{N}.-]+/gu, "-"), name].filter(Boolean).join("-");

/** Rows of numbers, columns by name, with units; as the tool writes them, with ; between cells where the decimal sign is a comma. */
function csvText({ names, units = [], rows }) {
    const between = shown.sign === "," ? ";" : ",";
    const heads = names.map((name, i) => (units[i] ? `${name} [${units[i]}]` : name));
    const cell = (value) => (value === null || Number.isNaN(value) ? "" : shortNumber(value));
    return [heads, ...rows.map((row) => row.map(cell))].map((row) => row.join(between)).join("\n") + "\n";
}

/** Three buttons. svg() is the plot, table() is { names, units, rows }. */
function saveButtons(name, svg, table) {
    const button = (form, save) =>
        element("button", { type: "button", "aria-label": `Save ${name} as ${form}`, onclick: save }, form);
    return element(
        "p",
        { class: "save" },
        "Save as ",
        button("SVG", () => download(`${fileOf(name)}.svg`, new Blob([svgText(svg())], { type: "image/svg+xml" }))),
        " ",
        button("PNG", () => savePng(name, svg())),
        " ",
        button("CSV", () => download(`${fileOf(name)}.csv`, new Blob([csvText(table())], { type: "text/csv" }))),
    );
}

/** A plot above the buttons that save it. draw(text) fills it; where the text has no SVG there are no buttons. */
export function savedPlot(name, table) {
    const plot = element("div");
    const buttons = saveButtons(name, () => plot.querySelector("svg"), table);
    buttons.hidden = true;
    const draw = (text) => {
        plot.innerHTML = text;
        buttons.hidden = !plot.querySelector("svg");
    };
    return { plot, buttons, parts: [plot, buttons], draw };
}
