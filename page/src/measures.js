// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of the stresses at many points: one number each. The library has the same for one point; the tests compare.

const inPlane = (sxx, syy, txy) => Math.hypot((sxx - syy) / 2, txy);

/** nu: Poisson's ratio, plane strain. */
export const measures = {
    von_mises: { name: "von Mises", of: (sxx, syy, txy, nu) => {
        const szz = nu * (sxx + syy), [a, b, c] = [sxx - syy, syy - szz, szz - sxx];
        return Math.sqrt((a * a + b * b + c * c) / 2 + 3 * txy * txy);
    } },
    s1: { name: "largest principal stress s1", of: (sxx, syy, txy) => (sxx + syy) / 2 + inPlane(sxx, syy, txy) },
    tau_max: { name: "largest shear stress \u03c4max", of: (sxx, syy, txy, nu) => {
        const mean = (sxx + syy) / 2, radius = inPlane(sxx, syy, txy), szz = nu * (sxx + syy);
        return (Math.max(mean + radius, szz) - Math.min(mean - radius, szz)) / 2;
    } },
    sxx: { name: "stress along the surface sxx", of: (sxx) => sxx },
    syy: { name: "stress across the surface syy", of: (sxx, syy) => syy },
    txy: { name: "shear stress txy", of: (sxx, syy, txy) => txy },
};
