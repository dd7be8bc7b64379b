// SPDX-License-Identifier: GPL-3.0-or-later
// Curves over an axis, as the text of an SVG.
import { extent as extentOf, minIndex } from "d3-array";
import { line } from "d3-shape";
import { escaped } from "../parts.js";
import { axes, frame, mark, narrow, plotText, point, roomy, scales } from "./axes.js";

/** Of the numbers that are finite. */
const extent = (numbers) => extentOf(numbers, (v) => (Number.isFinite(v) ? v : NaN));

/** In one line above the frame: it covers no curve. */
function legend(curves, box) {
    let x = narrow.matches ? 8 : box.left;
    return curves
        .map(({ name, style }) => {
            const at = x;
            x += 46 + 6.6 * name.length;
            return (
                `<line class="curve ${style}" x1="${at}" x2="${at + 22}" y1="12" y2="12"/>` +
                `<text class="legend" x="${at + 27}" y="12" dy="0.32em">${escaped(name)}</text>`
            );
        })
        .join("");
}

/** An interval of x as a coloured ground of the frame. */
function bandText({ from, to, style, name }, scale, top, bottom) {
    const width = Math.max(0, scale.x(to) - scale.x(from)).toFixed(1);
    return (
        `<rect class="${style}" x="${scale.x(from).toFixed(1)}" width="${width}" y="${top}" height="${bottom - top}">` +
        `<title>${escaped(name)}</title></rect>`
    );
}

/** A point with its name, which stands on the side that has more room. */
function markText({ x, y, name, below }, scale, box) {
    const [u, v] = [scale.x(x), scale.y(y)],
        dv = below ? 20 : -9;
    return point(u, v, 5) + (u > 0.6 * box.width ? mark(u - 9, v + dv, name, "end") : mark(u + 9, v + dv, name));
}

/** The scales of a plot; pinned curves have room too. */
function scalesOf({ curves, pinned = [], points = [], xDomain, yDomain }, box) {
    const reach = (axis, more = []) => extent([...more, ...[...curves, ...pinned].flatMap((c) => extent(c[axis]))]);
    const y = yDomain ? reach("y", yDomain) : roomy(reach("y", [0, ...points.map((p) => p.y)]), 0.08);
    return scales(reach("x", xDomain), y, box);
}

const isAlongX = ({ x }) => x.every((v, i) => i === 0 || v >= x[i - 1]);

/** The place of a curve next to a point of the view box. */
function nearest(curve, scale, u, v) {
    const along = isAlongX(curve);
    return minIndex(curve.x, (x, i) => Math.hypot(scale.x(x) - u, along ? 0 : scale.y(curve.y[i]) - v));
}

/** What the curves are at a point of the view box: [{ name, x, y }]; nothing outside the frame. */
export function valuesUnder(spec, u, v) {
    const box = frame(),
        scale = scalesOf(spec, box);
    if (u < box.left || u > box.width - box.right || v < box.top || v > box.height - box.bottom) return [];
    return spec.curves.map((curve) => {
        const i = nearest(curve, scale, u, v);
        return { name: curve.name, x: curve.x[i], y: curve.y[i] };
    });
}

/**
 * title, xLabel, yLabel: texts; curves: [{ name, style, x: numbers, y: numbers }];
 * pinned: curves of another case, thin; bands: [{ from, to, style, name }] along x; points: [{ x, y, name, below }]; xDomain, yDomain: what the axes show besides the curves.
 */
export function curvesText(spec) {
    const { title, xLabel, yLabel, curves, pinned = [], bands = [], points = [] } = spec;
    const box = frame(),
        scale = scalesOf(spec, box);
    const path = line()
        .defined(([, v]) => Number.isFinite(v))
        .x(([u]) => scale.x(u))
        .y(([, v]) => scale.y(v))
        .digits(2);
    const areas = bands.map((band) => bandText(band, scale, box.top, box.height - box.bottom));
    const paths = [...pinned.map((c) => ({ ...c, style: `${c.style} pinned` })), ...curves].map(
        (c) => `<path class="curve ${c.style}" d="${path(Array.from(c.x, (u, i) => [u, c.y[i]])) ?? ""}"/>`,
    );
    const marks = points.map((each) => markText(each, scale, box)),
        named = curves.filter((c) => c.name);
    return plotText(box, title, [...areas, axes(scale, xLabel, yLabel, box), ...paths, legend(named, box), ...marks]);
}
