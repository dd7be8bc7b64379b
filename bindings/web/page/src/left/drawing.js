// SPDX-License-Identifier: GPL-3.0-or-later
// The drawing of the contact: the pad as it touches and as it was, its loads, the stick zone; the pressure apart. Heights are stretched.
import { heightOf, pads } from "../pads.js";
import { mark, plotText, point, tenth } from "../plot/axes.js";
import { placesAcross } from "../answers/stresses.js";

const box = { width: 640, height: 372, middle: 320, surface: 150, up: 88, down: 56, floor: 258, base: 362, high: 62 };

const path = (style, d) => `<path class="${style}" d="${d}"/>`;

/** Its heights over the surface where it is pressed on between two edges, and as it was, which reaches below. */
function profilesOf(shape) {
    const g = (x) => shape.height(x) - shape.tilt * x,
        edge = (x) => g(x > shape.right ? shape.right : shape.left);
    return {
        pressed: (x) => (x > shape.right || x < shape.left ? g(x) - edge(x) : 0),
        free: (x) => g(x) - Math.max(g(shape.left), g(shape.right)),
    };
}

/** Along x, with its text above the middle. */
function arrow(from, to, y, text) {
    const head = to - 9 * Math.sign(to - from);
    return (
        path("arrow", `M${from},${y}L${head},${y}M${to},${y}L${head},${y - 5}L${head},${y + 5}Z`) +
        mark((from + to) / 2, y - 8, text, "middle")
    );
}

function momentText(M) {
    const side = Math.sign(M),
        [from, to] = [box.middle - 34 * side, box.middle + 34 * side];
    return (
        path("arc", `M${from},88A36,26 0 0 ${M > 0 ? 1 : 0} ${to},88`) +
        path("arrow", `M${to},98l-5,-12h10Z`) +
        mark(box.middle + 46, 76, "M")
    );
}

function tensionText(sigma) {
    const ends = sigma > 0 ? [594, 636] : [636, 594],
        mirrored = ends.map((x) => box.width - x);
    return [ends, mirrored].map(([from, to]) => arrow(from, to, box.surface + 50, "\u03c3")).join("");
}

function loadTexts({ M, Q, sigma }) {
    const c = box.middle,
        toward = Math.sign(Q);
    return [
        path("arrow", `M${c},4L${c},35M${c},44L${c - 5},35L${c + 5},35Z`) + mark(c + 8, 16, "P"),
        Q && arrow(c - 78 * toward, c - 22 * toward, 54, "Q"),
        M && momentText(M),
        sigma && tensionText(sigma),
    ];
}

const size = (from, to, y, text) =>
    path("sizes", `M${from},${y - 4}v8M${to},${y - 4}v8M${from},${y}H${to}`) +
    mark((from + to) / 2, y - 5, text, "middle");

/** Apart from the bodies, over a line of its own. */
function pressureText({ pressure, left, right }, toX) {
    if (pressure.length === 0) return "";
    const [l, r] = [toX(left), toX(right)];
    const over = pressure.map(([x, p]) => `${toX(x)},${tenth(box.base - box.high * p)}`);
    return (
        path("dashed", `M${l},${box.surface}V${box.base}M${r},${box.surface}V${box.base}`) +
        path("pressure", `M${l},${box.base}L${over.join("L")}L${r},${box.base}Z`) +
        path("sizes", `M20,${box.base}H620`) +
        mark(20, box.base - 8, "pressure")
    );
}

/** The angle between surface and flank, at the right. */
function angleText(toX, toY, reach, pressed) {
    const x = 0.94 * reach,
        [u, top] = [toX(x), toY(pressed(x))],
        middle = tenth((box.surface + top) / 2);
    return (
        path("sizes", `M${u},${box.surface}Q${tenth(u + 6)},${middle} ${u},${top}`) + mark(u - 16, middle + 8, "\u03b8")
    );
}

/** The tip as it was, before it was pressed on, and its radius. */
function tipText({ pad, a, flat, left, right }, toX, toY, free) {
    const points = Array.from({ length: 81 }, (_, i) => left + ((right - left) * i) / 80);
    const tip = path("dashed", `M${points.map((x) => `${toX(x)},${toY(free(x))}`).join("L")}`);
    if (!(a > 0 || pad === "flat")) return tip;
    const x = pad === "flat" ? (flat + Math.max(flat, right)) / 2 : Math.min(0.6 * a, 0.6 * right),
        [u, v] = [toX(x), toY(free(x))];
    return tip + path("sizes", `M${u},${v}l34,26`) + mark(u + 38, v + 36, "R");
}

function stickText({ sticks }, toX) {
    const drawn = sticks.map(({ from, to }) => [toX(from), toX(to)]).map(
        ([from, to]) => path("stuck", `M${from},${box.surface}H${to}`) + mark((from + to) / 2, box.surface + 16, "sticks", "middle"),
    );
    return drawn.join("");
}

/** Where the stress is largest; depths are half as large as widths. */
function hardestText(hardest, reach, toX) {
    const [u, v] = hardest ? [toX(hardest.x), box.surface + (150 * hardest.y) / reach] : [NaN, NaN];
    if (!(v < box.floor - 8)) return "";
    return point(u, v, 4) + mark(u - 8, v + (v < box.surface + 12 ? 18 : 4), "yields first", "end");
}

/** The worst place of a cycle on the surface; nothing where it is undefined. */
function worstText(x, toX) {
    const u = toX(x);
    return u > 0 && u < box.width ? point(u, box.surface, 5) + mark(u, box.surface - 10, "worst", "middle") : "";
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
    const toX = (x) => tenth(box.middle + (x / reach) * 300),
        toY = (h) => tenth(box.surface - scale * h);
    return { reach, pressed, free, toX, toY };
}

/** shape: { pad, height, a, flat, left, right, tilt, sticks: [{ from, to }], pressure: [[x, share of the highest]], M, Q, sigma, hardest, worst }. */
function drawingText(shape) {
    const { reach, pressed, free, toX, toY } = placed(shape);
    const outline = Array.from({ length: 121 }, (_, i) => reach * (i / 60 - 1)).map(
        (x) => `${toX(x)},${toY(pressed(x))}`,
    );
    const { name } = pads[shape.pad],
        marked = markedOf(shape);
    const title = `Body 2, a ${name}, on a half-plane: contact from ${shape.left.toPrecision(4)} to ${shape.right.toPrecision(4)}`;
    const parts = [
        `<rect class="solid2" x="0" y="${box.surface}" width="${box.width}" height="${box.floor - box.surface}"/>`,
        path("solid", `M20,30L${outline.join("L")}L620,30Z`),
        path("surface", `M0,${box.surface}H${box.width}`),
        tipText(shape, toX, toY, free),
        pressureText(shape, toX),
        stickText(shape, toX),
        marked > 0 && size(toX(0), toX(Math.min(marked, reach)), box.surface - 14, "a"),
        size(toX((shape.left + shape.right) / 2), toX(shape.right), box.floor + 20, "b"),
        shape.pad === "wedge" && angleText(toX, toY, reach, pressed),
        hardestText(shape.hardest, reach, toX),
        ...loadTexts(shape),
        mark(34, 52, `${name.replace(", pasted", "")}, body 2`),
        mark(16, box.floor - 10, "half-plane, body 1"),
        mark(624, box.floor - 10, "not to scale", "end"),
        `<g class="worst">${worstText(shape.worst, toX)}</g>`,
    ];
    return plotText(box, title, parts);
}

const schematic = { a: 0.4, radius: 0.4, left: -1, right: 1, tilt: 0, sticks: [], pressure: [], M: 0, Q: 0, sigma: 0 };
const shapes = {
    wedge: { theta: 1 },
    cylinder: { theta: 1, a: 4 },
    flat: { flat: 0.5, radius: 1 },
    profile: { theta: 1, a: 1 },
};

/** The drawing of a case, with the worst place of its cycle, if there is one; a drawing of no particular contact where there are no results. */
export function drawingOf({ pad, setup, contact, results, zones, hardest }, worst) {
    if (!results) {
        const shape = { ...schematic, pad, ...shapes[pad] };
        return drawingText({ ...shape, height: heightOf({ ...shape, places: [] }) });
    }
    const x = placesAcross(results.left, results.right, 60);
    const { p } = contact.tractions(x),
        most = Math.max(...p.map(Math.abs));
    return drawingText({
        ...results,
        ...setup,
        pad,
        worst,
        sticks: setup.f === 0 ? [] : zones.filter(({ slip }) => slip === 0),
        hardest: setup.k === null ? null : hardest,
        height: heightOf(setup),
        pressure: Array.from(x, (v, i) => [v, Math.abs(p[i]) / most]),
    });
}
