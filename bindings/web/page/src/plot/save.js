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
        canvas.toBlob((blob) => download(`${name}.png`, blob), "image/png");
    };
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svgText(svg))}`;
}

/** Rows of numbers, columns by name; as the tool writes them, with ; between cells where the decimal sign is a comma. */
function csvText(names, rows) {
    const between = shown.sign === "," ? ";" : ",";
    const cell = (value) => (value === null || Number.isNaN(value) ? "" : shortNumber(value));
    return [names, ...rows.map((row) => row.map(cell))].map((row) => row.join(between)).join("\n") + "\n";
}

/** Three buttons. svg() is the plot, table() is { names, rows }. */
function saveButtons(name, svg, table) {
    const button = (form, save) =>
        element("button", { type: "button", "aria-label": `Save ${name} as ${form}`, onclick: save }, form);
    return element(
        "p",
        { class: "save" },
        "Save as ",
        button("SVG", () => download(`${name}.svg`, new Blob([svgText(svg())], { type: "image/svg+xml" }))),
        " ",
        button("PNG", () => savePng(name, svg())),
        " ",
        button("CSV", () =>
            download(`${name}.csv`, new Blob([csvText(table().names, table().rows)], { type: "text/csv" })),
        ),
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
    return { plot, parts: [plot, buttons], draw };
}
