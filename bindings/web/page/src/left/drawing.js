// SPDX-License-Identifier: GPL-3.0-or-later
// The drawing of the contact: the wedge as it touches, its loads, the pressure below, the stick zone. Heights are stretched.
import { escaped } from "../elements.js";
import { placesAcross } from "../stresses.js";

const box = { width: 640, height: 300, middle: 320, surface: 178, flank: 108, deep: 78 };

/** The wedge's heights over the surface, over theta, where it touches between two edges. */
function profile({ a, tilt, left, right }) {
    const g = (x) => (Math.abs(x) < a ? (x * x) / (2 * a) : Math.abs(x) - a / 2) - tilt * x;
    return (x) => (x > right ? g(x) - g(right) : x < left ? g(x) - g(left) : 0);
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
    const parts = [arrow(box.middle, 6, box.middle, 52, "P")];
    if (Q)
        parts.push(
            Q > 0
                ? arrow(box.middle - 78, 60, box.middle - 22, 60, "Q")
                : arrow(box.middle + 78, 60, box.middle + 22, 60, "Q"),
        );
    if (M) {
        const [from, to] = M > 0 ? [-1, 1] : [1, -1],
            c = box.middle;
        parts.push(
            `<path class="arc" d="M${c + 34 * from},104A36,26 0 0 ${M > 0 ? 1 : 0} ${c + 34 * to},104"/>`,
            `<path class="arrow" d="M${c + 34 * to},114l-5,-12h10Z"/><text class="mark" x="${c + 46}" y="90">M</text>`,
        );
    }
    if (sigma) {
        const y = box.surface + 62,
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

/** The pressure, drawn downwards below the contact. */
function pressureText({ pressure, left, right }, toX) {
    if (pressure.length === 0) return "";
    const below = pressure.map(([x, p]) => `${toX(x).toFixed(1)},${(box.surface + box.deep * p).toFixed(1)}`);
    const [l, r] = [toX(left), toX(right)].map((v) => v.toFixed(1));
    return `<path class="pressure" d="M${l},${box.surface}L${below.join("L")}L${r},${box.surface}Z"/>`;
}

function stickText({ stickLeft, stickRight }, toX) {
    if (!(stickRight > stickLeft)) return "";
    const [from, to] = [toX(stickLeft), toX(stickRight)];
    return (
        `<path class="stuck" d="M${from.toFixed(1)},${box.surface}H${to.toFixed(1)}"/>` +
        `<text class="mark" x="${(from + to) / 2}" y="${box.surface + 16}" text-anchor="middle">sticks</text>`
    );
}

/** shape: { a, left, right, tilt (over theta), stickLeft, stickRight, pressure: [[x, share of the highest]], M, Q, sigma }. */
function drawingText(shape) {
    const reach = 1.7 * Math.max(Math.abs(shape.left), Math.abs(shape.right), shape.a);
    const toX = (x) => box.middle + (x / reach) * 300,
        height = profile(shape);
    const most = Math.max(height(reach), height(-reach)) || 1;
    const outline = Array.from({ length: 121 }, (_, i) => {
        const x = reach * (i / 60 - 1);
        return `${toX(x).toFixed(1)},${(box.surface - (box.flank * height(x)) / most).toFixed(1)}`;
    });
    const [l, r] = [toX(shape.left), toX(shape.right)].map((v) => v.toFixed(1));
    const title = `Wedge on half-plane: contact from ${shape.left.toPrecision(4)} to ${shape.right.toPrecision(4)}`;
    return (
        `<svg class="plot" viewBox="0 0 ${box.width} ${box.height}" role="img" aria-label="${escaped(title)}"><title>${escaped(title)}</title>` +
        `<rect class="solid2" x="0" y="${box.surface}" width="${box.width}" height="${box.height - box.surface}"/>` +
        `<path class="solid" d="M20,34L${outline.join("L")}L620,34Z"/>` +
        `<path class="surface" d="M0,${box.surface}H${box.width}"/>` +
        pressureText(shape, toX) +
        stickText(shape, toX) +
        (shape.a > 0 ? size(toX(0), toX(Math.min(shape.a, reach)), box.surface - 18, "a") : "") +
        size(+l, +r, box.height - 10, "contact") +
        loads(shape) +
        `<text class="mark" x="70" y="62">wedge, body 2</text><text class="mark" x="20" y="${box.height - 28}">half-plane, body 1</text></svg>`
    );
}

const schematic = { a: 0.4, left: -1, right: 1, tilt: 0, pressure: [], M: 0, Q: 0, sigma: 0 };

/** The drawing of a case; one of no particular contact where there are no results. */
export function drawingOf({ setup, contact, results }) {
    if (!results) return drawingText(schematic);
    const x = placesAcross(results.left, results.right, 60);
    const { p } = contact.tractions(x),
        most = Math.max(...p.map(Math.abs));
    return drawingText({
        ...setup,
        left: results.left,
        right: results.right,
        tilt: results.tilt / setup.theta,
        stickLeft: results.stick_left,
        stickRight: results.stick_right,
        pressure: Array.from(x, (v, i) => [v, Math.abs(p[i]) / most]),
    });
}
