// SPDX-License-Identifier: GPL-3.0-or-later
// Where stresses are looked at, and what of them: places across the contact, a grid below it, one number or all of a place.
import { orNull, rwedge } from "./library.js";

/** One number of the stresses, at a place or on a grid. */
export const measures = {
    von_mises: { name: "von Mises", along: ({ sxx, syy, txy }, nu) => rwedge.von_mises(sxx, syy, txy, nu) },
    s1: {
        name: "largest principal stress s1",
        along: ({ sxx, syy, txy }) => rwedge.principal_stresses(sxx, syy, txy).s1,
    },
    tau_max: {
        name: "largest shear stress \u03c4max",
        along: ({ sxx, syy, txy }, nu) => rwedge.largest_shear(sxx, syy, txy, nu),
    },
    sxx: { name: "stress along the surface sxx", along: ({ sxx }) => sxx },
    syy: { name: "stress across the surface syy", along: ({ syy }) => syy },
    txy: { name: "shear stress txy", along: ({ txy }) => txy },
};

/** Places across the contact, dense at its edges; none is the apex of a sharp wedge, where the pressure is infinite. */
export function placesAcross(left, right, count) {
    const middle = (left + right) / 2;
    const half = (right - left) / 2;
    const x = Float64Array.from({ length: count }, (_, i) => {
        const angle = (Math.PI / 2) * ((2 * i) / (count - 1) - 1);
        return middle + half * Math.sin(angle) || 1e-9 * half;
    });
    x[0] = left;
    x[count - 1] = right;
    return x;
}

const CELLS = [200, 150],
    FEW_CELLS = [100, 75]; // while a slider moves

/** The grid, square cells: as wide as 3.2 half-widths of the contact. */
export function gridOf({ left, right }, isMoving) {
    const [nx, ny] = isMoving ? FEW_CELLS : CELLS;
    const half = (right - left) / 2,
        middle = (left + right) / 2,
        depth = (3.2 * half * (ny - 1)) / (nx - 1);
    const x = new Float64Array(nx * ny),
        y = new Float64Array(nx * ny);
    const [x0, x1] = [middle - 1.6 * half, middle + 1.6 * half];
    for (let j = 0, n = 0; j < ny; j++)
        for (let i = 0; i < nx; i++, n++) {
            x[n] = x0 + ((x1 - x0) * i) / (nx - 1) || 1e-9 * half; // not the apex of a sharp wedge
            y[n] = (depth * j) / (ny - 1);
        }
    return { x, y, nx, ny, x0, x1, depth };
}

/** The pad, body 2, is seen from its own side: its stresses at (x, -y) are those of body 1, in its place, at (-x, y). */
const stressesAt = ({ contact, setup }, x, y) =>
    contact.stresses(setup.body === 2 ? (typeof x === "number" ? -x : x.map((v) => -v)) : x, y);

/** The stresses on the grid, and one measure of them. In the pad y is the height. */
export function fieldOf({ contact, setup }, grid, measure) {
    const stresses = stressesAt({ contact, setup }, grid.x, grid.y);
    return { ...stresses, values: measures[measure].along(stresses, setup.nu1) };
}

/** All numbers of one place; null where there are none. */
export function valuesAt({ contact, setup }, place) {
    const s = orNull(() => stressesAt({ contact, setup }, place.x, place.y));
    if (!s) return null;
    const { s2, angle } = rwedge.principal_stresses(s.sxx, s.syy, s.txy);
    return {
        ...Object.fromEntries(Object.entries(measures).map(([name, { along }]) => [name, along(s, setup.nu1)])),
        szz: rwedge.out_of_plane_stress(s.sxx, s.syy, setup.nu1),
        s2,
        angle: (angle * 180) / Math.PI,
    };
}
