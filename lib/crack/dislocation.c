/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "crack/dislocation.h"

static rw_complex conjugate(rw_complex z)
{
    return (rw_complex){z.re, -z.im};
}

/* s22 + i s12 of the images, along and across the direction e: Phi + conj(Phi) + e^2 (conj(z) Phi'
 * + Psi) of Muskhelishvili's potentials that free the surface of A/(z - z0), with q = 1/(z -
 * conj(z0)),
 *     Phi = -A q - conj(A) (z0 - conj(z0)) q^2,   Psi = -conj(A) q - Phi - z Phi'. */
static rw_complex images(rw_complex e, double r, double t, rw_complex A)
{
    const rw_complex one = {1, 0}, apart = {(r - t) * e.re, (r + t) * e.im};
    const rw_complex q = rw_quotient(one, apart), depth = {0, 2 * t * e.im};
    const rw_complex direct = rw_product(A, q), mirrored = rw_product(conjugate(A), q);
    const rw_complex deep = rw_product(mirrored, rw_product(depth, q));
    const rw_complex Phi = rw_multiple(-1, rw_sum(direct, deep));
    const rw_complex slope = rw_product(q, rw_sum(direct, rw_multiple(2, deep)));
    const rw_complex twice_height = {0, 2 * r * e.im};
    const rw_complex turned = rw_sum(rw_sum(Phi, mirrored), rw_product(twice_height, slope));
    const rw_complex mean = {2 * Phi.re, 0};
    return rw_sum(mean, rw_multiple(-1, rw_product(rw_product(e, e), turned)));
}

rw_line_stress rw_dislocation_stress(rw_complex direction, double r, double t, double r_less_t,
                                     rw_complex density)
{
    const rw_complex image = images(direction, r, t, rw_product(density, direction));
    const rw_complex own = rw_multiple(2 / r_less_t, conjugate(density));
    return (rw_line_stress){own.re + image.re, -(own.im + image.im)};
}
