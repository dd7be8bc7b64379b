/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "crack/dislocation.h"

static rw_complex conjugate(rw_complex z)
{
    return (rw_complex){z.re, -z.im};
}

/* A times i, without a rounding. */
static rw_complex turned(rw_complex A)
{
    return (rw_complex){-A.im, A.re};
}

/* What the images of A and of i A have in common: A q, conj(A) q, conj(A) (z0 - conj(z0)) q^2. */
typedef struct {
    rw_complex direction, q, direct, mirrored, deep, height;
} image_parts;

static image_parts parts_of(rw_complex e, double r, double t)
{
    const rw_complex one = {1, 0}, apart = {(r - t) * e.re, (r + t) * e.im};
    image_parts p = {.direction = e, .q = rw_quotient(one, apart), .height = {0, 2 * r * e.im}};
    const rw_complex depth = {0, 2 * t * e.im};
    p.direct = rw_product(e, p.q);
    p.mirrored = rw_product(conjugate(e), p.q);
    p.deep = rw_product(p.mirrored, rw_product(depth, p.q));
    return p;
}

/* s22 + i s12 of the images, along and across the direction e: Phi + conj(Phi) + e^2 (conj(z) Phi'
 * + Psi) of Muskhelishvili's potentials that free the surface of A/(z - z0), with q = 1/(z -
 * conj(z0)),
 *     Phi = -A q - conj(A) (z0 - conj(z0)) q^2,   Psi = -conj(A) q - Phi - z Phi'. */
static rw_complex images(const image_parts *p)
{
    const rw_complex Phi = rw_multiple(-1, rw_sum(p->direct, p->deep));
    const rw_complex slope = rw_product(p->q, rw_sum(p->direct, rw_multiple(2, p->deep)));
    const rw_complex around = rw_sum(rw_sum(Phi, p->mirrored), rw_product(p->height, slope));
    const rw_complex mean = {2 * Phi.re, 0};
    return rw_sum(mean,
                  rw_multiple(-1, rw_product(rw_product(p->direction, p->direction), around)));
}

void rw_dislocation_stresses(rw_complex direction, double r, double t, double r_less_t,
                             rw_line_stress stress[2])
{
    image_parts p = parts_of(direction, r, t);
    const double own = 2 / r_less_t;
    const rw_complex opening = images(&p);
    p.direct = turned(p.direct);
    p.mirrored = rw_multiple(-1, turned(p.mirrored));
    p.deep = rw_multiple(-1, turned(p.deep));
    const rw_complex sliding = images(&p);
    stress[0] = (rw_line_stress){own + opening.re, -opening.im};
    stress[1] = (rw_line_stress){sliding.re, own - sliding.im};
}
