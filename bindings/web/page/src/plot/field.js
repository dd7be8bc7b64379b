// SPDX-License-Identifier: GPL-3.0-or-later
// Contours of a field on a grid, as the text of an SVG: bands of colour, and what they mean.
import { shortNumber } from "../state.js";
import { contours } from "d3-contour";
import { extent, ticks } from "d3-array";
import { line } from "d3-shape";
import { escaped } from "../parts.js";
import { axes, ofWidth, point, scales } from "./axes.js";
import { colourOf } from "./colours.js";

const frames = [
    { width: 640, height: 424, left: 60, right: 96, top: 14, bottom: 48 },
    { width: 420, height: 290, left: 58, right: 74, top: 14, bottom: 46 },
];
const fieldFrame = () => ofWidth(frames);
export const viewBox = () => `0 0 ${fieldFrame().width} ${fieldFrame().height}`;
const scalesOf = ({ x0, x1, depth }) => scales([x0, x1], [0, depth], fieldFrame(), true);
const LEVELS = 10;

/** A few of the highest and lowest values may be far from the rest, as near a sharp apex: they set no level. */
function range(values) {
    const some = Float64Array.from({ length: 1500 }, (_, i) => values[Math.floor((i * values.length) / 1500)]).sort();
    const [lowest, highest] = extent(values),
        inner = some[1480] - some[20];
    return [Math.max(lowest, some[20] - inner), Math.min(highest, some[1480] + inner)];
}

function key(levels, colours, box, unit) {
    const x = box.width - box.right + 12,
        height = (box.height - box.bottom - box.top - 18) / levels.length;
    const boxes = levels.map((level, i) => {
        const y = box.top + 18 + (levels.length - 1 - i) * height;
        return (
            `<rect x="${x}" y="${y.toFixed(1)}" width="16" height="${height.toFixed(1)}" fill="${colours[i]}"/>` +
            `<text class="tick" x="${x + 20}" y="${(y + height).toFixed(1)}" dy="0.32em">${i === 0 ? "below" : shortNumber(Number(level.toPrecision(6))).replace("-", "\u2212")}</text>`
        );
    });
    return `<text class="tick" x="${x}" y="${box.top + 8}">${escaped(unit)}</text>` + boxes.join("");
}

/** The values between which the colours change, the first below all, and the colour of each band above one. */
function bandsOf(values) {
    const [lo, hi] = range(values);
    const levels = [-Infinity, ...ticks(lo, hi, LEVELS).filter((v) => v > lo && v < hi)];
    const ends = [...levels.slice(1), hi];
    return { levels, colours: levels.map((level, i) => colourOf(((i === 0 ? lo : level) + ends[i]) / 2, lo, hi)) };
}

/** The bands but the lowest, one upon the other. Grid coordinates of d3-contour count half a cell more than ours. */
function bandTexts({ levels, colours }, { values, nx, ny, x0, x1, depth }, scale) {
    const ring = line()
        .x(([i]) => scale.x(x0 + ((i - 0.5) / (nx - 1)) * (x1 - x0)))
        .y(([, j]) => scale.y(((j - 0.5) / (ny - 1)) * depth))
        .digits(1);
    const find = contours().size([nx, ny]).smooth(true);
    const path = (level) =>
        find
            .contour(values, level)
            .coordinates.flat()
            .map((points) => `${ring(points)}Z`)
            .join("");
    return levels.slice(1).map((level, i) => `<path class="level" fill="${colours[i + 1]}" d="${path(level)}"/>`);
}

/** A line above the frame. */
function barText({ from, to, style, name }, scale, box) {
    const [u1, u2] = [scale.x(from).toFixed(1), scale.x(to).toFixed(1)],
        v = box.top - 4;
    return `<line class="${style}" x1="${u1}" x2="${u2}" y1="${v}" y2="${v}"><title>${escaped(name)}</title></line>`;
}

/**
 * grid: values, nx * ny numbers, row by row from the surface down, at x from x0 to x1 and y from 0 to depth.
 * points: [{ x, y, name }]; surface: [{ from, to, style, name }] above the frame.
 */
export function fieldText(grid, { xLabel, yLabel, unit, points, surface }) {
    const box = fieldFrame(),
        scale = scalesOf(grid);
    const bands = bandsOf(grid.values);
    const [width, height] = [box.width - box.left - box.right, box.height - box.top - box.bottom];
    const frame = `x="${box.left}" y="${box.top}" width="${width}" height="${height}"`;
    return (
        `<clipPath id="inside"><rect ${frame}/></clipPath>` +
        `<g clip-path="url(#inside)"><rect ${frame} fill="${bands.colours[0]}"/>${bandTexts(bands, grid, scale).join("")}</g>` +
        axes(scale, xLabel, yLabel, box) +
        surface.map((bar) => barText(bar, scale, box)).join("") +
        key(bands.levels, bands.colours, box, unit) +
        points.map(({ x, y, name }) => point(scale.x(x), scale.y(y), 5, name)).join("")
    );
}

/** The place under a point of the plot, given in the units of its view box; null outside. */
export function placeAt(u, v, grid) {
    const { x0, x1, depth } = grid,
        scale = scalesOf(grid),
        x = scale.x.invert(u),
        y = scale.y.invert(v);
    return x >= x0 && x <= x1 && y >= 0 && y <= depth ? { x, y } : null;
}

export function probeText(place, grid) {
    const scale = scalesOf(grid),
        [u, v] = [scale.x(place.x).toFixed(1), scale.y(place.y).toFixed(1)];
    const cross = `d="M${u - 9},${v}H${+u + 9}M${u},${v - 9}V${+v + 9}"`;
    return `<path class="halo" ${cross}/><path class="cross" ${cross}/>`;
}
