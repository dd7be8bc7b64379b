// SPDX-License-Identifier: GPL-3.0-or-later
// Axes of a plot: scales, ticks, grid and labels, as SVG text.
import { scaleLinear } from "d3-scale";
import { escaped } from "../parts.js";
import { shortNumber } from "../state.js";

/** On a narrow screen fewer units across make letters larger. */
export const narrow = matchMedia("(max-width: 520px)");
const frames = [
    { width: 640, height: 400, left: 70, right: 16, top: 28, bottom: 48 },
    { width: 420, height: 340, left: 62, right: 12, top: 28, bottom: 46 },
];
export const ofWidth = ([wide, small]) => (narrow.matches ? small : wide);
export const frame = () => ofWidth(frames);

/** Scales from the domains of x and y to the frame; y may run downwards. */
export function scales(x, y, box, down = false) {
    const range = [box.height - box.bottom, box.top];
    return { x: scaleLinear(x, [box.left, box.width - box.right]), y: scaleLinear(y, down ? range.reverse() : range) };
}

/** A domain with room around its numbers; never empty. */
export function roomy([lo, hi], share = 0.05) {
    if (!(hi > lo)) return lo === hi ? [lo - (Math.abs(lo) || 1), hi + (Math.abs(hi) || 1)] : [0, 1];
    const room = share * (hi - lo);
    return [lo === 0 ? 0 : lo - room, hi === 0 ? 0 : hi + room];
}

/** A whole plot, of the size of a box, as the text of an SVG; parts may be missing. */
export const plotText = ({ width, height }, title, parts) =>
    `<svg class="plot" viewBox="0 0 ${width} ${height}" role="img" aria-label="${escaped(title)}">` +
    `<title>${escaped(title)}</title>${parts.filter(Boolean).join("")}</svg>`;

/** To a tenth of a pixel. */
export const tenth = (number) => Math.round(10 * number) / 10;
export const mark = (x, y, text, anchor = "start") =>
    `<text class="mark" x="${tenth(x)}" y="${tenth(y)}" text-anchor="${anchor}">${escaped(text)}</text>`;
export const point = (x, y, radius, name = "") =>
    `<circle class="point" cx="${tenth(x)}" cy="${tenth(y)}" r="${radius}">${name && `<title>${escaped(name)}</title>`}</circle>`;

const superscript = (n) =>
    String(n).replace(/./g, (c) => "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"[c] ?? "\u207b");

/** Short ticks: a power of ten that all have goes into the label. */
function shortened(scale, count) {
    const ticks = scale.ticks(count),
        most = Math.max(...ticks.map(Math.abs));
    const power = most > 0 && (most < 0.01 || most >= 1e5) ? 3 * Math.floor(Math.log10(most) / 3) : 0;
    const text = (tick) => shortNumber(Number((tick / 10 ** power).toPrecision(8))).replace("-", "\u2212");
    return {
        ticks: ticks.map((tick) => ({ at: scale(tick).toFixed(1), text: text(tick) })),
        note: power ? `, in 10${superscript(power)}` : "",
    };
}

export function axes({ x, y }, xLabel, yLabel, box) {
    const bottom = box.height - box.bottom,
        right = box.width - box.right,
        parts = [];
    const along = shortened(x, box.width / 90),
        up = shortened(y, 6);
    for (const { at, text } of along.ticks)
        parts.push(
            `<line class="grid" x1="${at}" x2="${at}" y1="${box.top}" y2="${bottom}"/>`,
            `<text class="tick" x="${at}" y="${bottom + 16}" text-anchor="middle">${text}</text>`,
        );
    for (const { at, text } of up.ticks)
        parts.push(
            `<line class="grid" x1="${box.left}" x2="${right}" y1="${at}" y2="${at}"/>`,
            `<text class="tick" x="${box.left - 6}" y="${at}" dy="0.32em" text-anchor="end">${text}</text>`,
        );
    const middle = (box.top + bottom) / 2;
    parts.push(
        `<rect class="frame" x="${box.left}" y="${box.top}" width="${right - box.left}" height="${bottom - box.top}"/>`,
        `<text class="label" x="${(box.left + right) / 2}" y="${box.height - 8}" text-anchor="middle">${escaped(xLabel + along.note)}</text>`,
        `<text class="label" transform="translate(14 ${middle}) rotate(-90)" text-anchor="middle">${escaped(yLabel + up.note)}</text>`,
    );
    return parts.join("");
}
