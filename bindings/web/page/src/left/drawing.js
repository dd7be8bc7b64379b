// SPDX-License-Identifier: GPL-3.0-or-later
// The drawing of the contact: the pad as it touches and as it was, its loads, the stick zone; the pressure apart. Heights are stretched.
import { escaped } from "../elements.js";
import { heightOf, pads } from "../pads.js";
import { placesAcross } from "../stresses.js";

const box = { width: 640, height: 372, middle: 320, surface: 150, up: 88, down: 56, floor: 258, base: 362, high: 62 };

/** Its heights over the surface where it is pressed on between two edges, and as it was, which reaches below. */
function profilesOf(shape) {
    const g = (x) => shape.height(x) - shape.tilt * x,
        edge = (x) => g(x > shape.right ? shape.right : shape.left);
    return {
        pressed: (x) => (x > shape.right || x < shape.left ? g(x) - edge(x) : 0),
        free: (x) => g(x) - Math.max(g(shape.left), g(shape.right)),
    };
}

function arrow(x1, y1, x2, y2, text, anchor = "middle") {
    const length = Math.hypot(x2 - x1, y2 - y1),
        [u, v] = [(x2 - x1) / length, (y2 - y1) / length];
    const [x, y] = [x2 - 9 * u, y2 - 9 * v];
    const [textX, textY] = v !== 0 ? [x1 + 8, y1 + 12] : [(x1 + x2) / 2, y1 - 8];
    return (
        `<path class="arrow" d="M${x1},${y1}L${x},${y}M${x2},${y2}L${x - 5 * v},${y + 5 * u}L${x + 5 * v},${y - 5 * u}Z"/>` +
        `<text class="mark" x="${textX}" y="${textY}" text-anchor="${v !== 0 ? "start" : anchor}">${text}</text>`
    );
}

function loads({ M, Q, sigma }) {
    const parts = [arrow(box.middle, 4, box.middle, 44, "P")];
    if (Q)
        parts.push(
            Q > 0
                ? arrow(box.middle - 78, 54, box.middle - 22, 54, "Q")
                : arrow(box.middle + 78, 54, box.middle + 22, 54, "Q"),
        );
    if (M) {
        const [from, to] = M > 0 ? [-1, 1] : [1, -1],
            c = box.middle;
        parts.push(
            `<path class="arc" d="M${c + 34 * from},88A36,26 0 0 ${M > 0 ? 1 : 0} ${c + 34 * to},88"/>`,
            `<path class="arrow" d="M${c + 34 * to},98l-5,-12h10Z"/><text class="mark" x="${c + 46}" y="76">M</text>`,
        );
    }
    if (sigma) {
        const y = box.surface + 50,
            out = sigma > 0;
        parts.push(
            arrow(out ? 594 : 636, y, out ? 636 : 594, y, "\u03c3"),
            arrow(out ? 46 : 4, y, out ? 4 : 46, y, "\u03c3"),
        );
    }
    return parts.join("");
}

const size = (from, to, y, text) =>
    `<path class="sizes" d="M${from},${y - 4}v8M${to},${y - 4}v8M${from},${y}H${to}"/><text class="mark" x="${(from + to) / 2}" y="${y - 5}" text-anchor="middle">${text}</text>`;

/** Apart from the bodies, over a line of its own. */
function pressureText({ pressure, left, right }, toX) {
    if (pressure.length === 0) return "";
    const [l, r] = [toX(left), toX(right)].map((v) => v.toFixed(1));
    const over = pressure.map(([x, p]) => `${toX(x).toFixed(1)},${(box.base - box.high * p).toFixed(1)}`);
    return (
        `<path class="dashed" d="M${l},${box.surface}V${box.base}M${r},${box.surface}V${box.base}"/>` +
        `<path class="pressure" d="M${l},${box.base}L${over.join("L")}L${r},${box.base}Z"/>` +
        `<path class="sizes" d="M20,${box.base}H620"/><text class="mark" x="20" y="${box.base - 8}">pressure</text>`
    );
}

/** The angle between surface and flank, at the right. */
function angleText(toX, toY, reach, pressed) {
    const x = 0.94 * reach,
        [u, top] = [toX(x), toY(pressed(x))];
    return (
        `<path class="sizes" d="M${u.toFixed(1)},${box.surface}Q${(u + 6).toFixed(1)},${((box.surface + top) / 2).toFixed(1)} ${u.toFixed(1)},${top.toFixed(1)}"/>` +
        `<text class="mark" x="${(u - 16).toFixed(1)}" y="${((box.surface + top) / 2 + 8).toFixed(1)}">\u03b8</text>`
    );
}

/** The tip as it was, before it was pressed on, and its radius. */
function tipText({ pad, a, flat, left, right }, toX, toY, free) {
    const points = Array.from({ length: 81 }, (_, i) => left + ((right - left) * i) / 80);
    const path = points.map((x) => `${toX(x).toFixed(1)},${toY(free(x)).toFixed(1)}`).join("L");
    const x = pad === "flat" ? (flat + Math.max(flat, right)) / 2 : Math.min(0.6 * a, 0.6 * right),
        [u, v] = [toX(x), toY(free(x))];
    const radius = `<path class="sizes" d="M${u.toFixed(1)},${v.toFixed(1)}L${(u + 34).toFixed(1)},${(v + 26).toFixed(1)}"/><text class="mark" x="${(u + 38).toFixed(1)}" y="${(v + 36).toFixed(1)}">R</text>`;
    return `<path class="dashed" d="M${path}"/>${a > 0 || pad === "flat" ? radius : ""}`;
}

function stickText({ stickLeft, stickRight }, toX) {
    if (!(stickRight > stickLeft)) return "";
    const [from, to] = [toX(stickLeft), toX(stickRight)];
    return (
        `<path class="stuck" d="M${from.toFixed(1)},${box.surface}H${to.toFixed(1)}"/>` +
        `<text class="mark" x="${(from + to) / 2}" y="${box.surface + 16}" text-anchor="middle">sticks</text>`
    );
}

/** Where the stress is largest; depths are half as large as widths. */
function hardestText({ hardest, reach }, toX) {
    const [u, v] = hardest ? [toX(hardest.x), box.surface + (150 * hardest.y) / reach] : [NaN, NaN];
    if (!(v < box.floor - 8)) return "";
    return (
        `<circle class="point" cx="${u.toFixed(1)}" cy="${v.toFixed(1)}" r="4"/>` +
        `<text class="mark" x="${(u - 8).toFixed(1)}" y="${(v + (v < box.surface + 12 ? 18 : 4)).toFixed(1)}" text-anchor="end">yields first</text>`
    );
}

/** Half of what is marked as a: the rounding of a wedge, the flat. */
const markedOf = ({ pad, a, flat }) => (pad === "wedge" ? a : pad === "flat" ? flat : 0);

/** Lines of the pad, and how x and heights become pixels: the pad above and its tip below have room. */
function placed(shape) {
    const reach =
            1.7 * Math.max(Math.abs(shape.left), Math.abs(shape.right), Math.min(markedOf(shape), 2 * shape.right)),
        { pressed, free } = profilesOf(shape);
    const most = Math.max(pressed(reach), pressed(-reach)),
        scale = Math.min(box.up / most, box.down / (-free(0) || most));
    return { reach, pressed, free, toX: (x) => box.middle + (x / reach) * 300, toY: (h) => box.surface - scale * h };
}

/** shape: { pad, height, a, flat, left, right, tilt, stickLeft, stickRight, pressure: [[x, share of the highest]], M, Q, sigma }. */
function drawingText(shape) {
    const { reach, pressed, free, toX, toY } = placed(shape);
    const outline = Array.from({ length: 121 }, (_, i) => reach * (i / 60 - 1)).map(
        (x) => `${toX(x).toFixed(1)},${toY(pressed(x)).toFixed(1)}`,
    );
    const { title: name } = pads[shape.pad],
        marked = markedOf(shape);
    const title = `Body 2, a ${name}, on a half-plane: contact from ${shape.left.toPrecision(4)} to ${shape.right.toPrecision(4)}`;
    const middle = (shape.left + shape.right) / 2;
    return (
        `<svg class="plot" data-reach="${reach}" viewBox="0 0 ${box.width} ${box.height}" role="img" aria-label="${escaped(title)}"><title>${escaped(title)}</title>` +
        `<rect class="solid2" x="0" y="${box.surface}" width="${box.width}" height="${box.floor - box.surface}"/>` +
        `<path class="solid" d="M20,30L${outline.join("L")}L620,30Z"/>` +
        `<path class="surface" d="M0,${box.surface}H${box.width}"/>` +
        tipText(shape, toX, toY, free) +
        pressureText(shape, toX) +
        stickText(shape, toX) +
        (marked > 0 ? size(toX(0), toX(Math.min(marked, reach)), box.surface - 14, "a") : "") +
        size(toX(middle), toX(shape.right), box.floor + 20, "b") +
        (shape.pad === "wedge" ? angleText(toX, toY, reach, pressed) : "") +
        hardestText({ ...shape, reach }, toX) +
        loads(shape) +
        `<text class="mark" x="34" y="52">${escaped(name.replace(", pasted", ""))}, body 2</text><text class="mark" x="16" y="${box.floor - 10}">half-plane, body 1</text>` +
        `<text class="mark" x="624" y="${box.floor - 10}" text-anchor="end">not to scale</text><g class="worst"></g></svg>`
    );
}

/** Marks the worst place of a cycle on the surface; none where x is undefined. */
export function markWorst(svg, x) {
    const u = box.middle + (x / Number(svg.dataset.reach)) * 300;
    svg.querySelector(".worst").innerHTML =
        u > 0 && u < box.width
            ? `<circle class="point" cx="${u.toFixed(1)}" cy="${box.surface}" r="5"/><text class="mark" x="${u.toFixed(1)}" y="${box.surface - 10}" text-anchor="middle">worst</text>`
            : "";
}

const schematic = { a: 0.4, radius: 0.4, left: -1, right: 1, tilt: 0, pressure: [], M: 0, Q: 0, sigma: 0 };
const shapes = {
    wedge: { theta: 1 },
    cylinder: { theta: 1, a: 4 },
    flat: { flat: 0.5, radius: 1 },
    profile: { theta: 1, a: 1 },
};

/** The drawing of a case; one of no particular contact where there are no results. */
export function drawingOf({ pad, setup, contact, results, hardest }) {
    if (!results) {
        const shape = { ...schematic, pad, ...shapes[pad] };
        return drawingText({ ...shape, height: heightOf({ ...shape, places: [] }) });
    }
    const x = placesAcross(results.left, results.right, 60);
    const { p } = contact.tractions(x),
        most = Math.max(...p.map(Math.abs));
    return drawingText({
        ...setup,
        pad,
        hardest: Number.isNaN(setup.k) ? null : hardest,
        height: heightOf(setup),
        left: results.left,
        right: results.right,
        tilt: results.tilt,
        stickLeft: results.stick_left,
        stickRight: results.stick_right,
        pressure: Array.from(x, (v, i) => [v, Math.abs(p[i]) / most]),
    });
}
