/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Derivatives of the closed form. With X = sqrt(z^2-1), q = (z-alpha)(z+alpha), and A and R as in
 * closed_form.h, in the half-width of the patch,
 *     G''           =  (2/pi) [ c0/(X q) + (phi0/alpha)/X^3 ],
 *     G'''          = -(2/pi) z [ c0/(X^3 q) + 2 c0/(X q^2) + 3 (phi0/alpha)/X^5 ],
 *     alpha dG/da   =  (2/pi) [ z A/alpha - (phi0/alpha) R ],
 *     alpha dG'/da  = -G' - (2/pi) c0 z/(X q),
 *     c dG/dc       =  (2/pi) (phi0/alpha)/X.
 * They are written in y/X and y/(z -+ alpha), which neither under- nor overflow. Hertz: c0 = 0. The
 * two derivatives by the rounding fall like (alpha/z)^2 beside their terms. So far from the
 * rounding they are computed from
 *     alpha dG/da   = -(2/(pi alpha)) X int s^2/(z^2 - s^2) dpsi,
 * s = sin(psi), 0 <= psi <= phi0. */
#include "stress/derivatives.h"

#include "base/root.h"
#include "potential/closed_form.h"

/* y/a. The division is one of real numbers, because complex division differs between compilers. */
static double complex y_over(double y, double complex a)
{
    return y / (creal(a) * creal(a) + cimag(a) * cimag(a)) * conj(a);
}

static rw_field field_of(double complex G, double complex H)
{
    return (rw_field){creal(G), cimag(G), creal(H), cimag(H)};
}

/* A point of the right half. Where it is remote X is z, and there are no elliptic coordinates. */
typedef struct {
    rw_place at;
    bool is_remote;
    rw_elliptic e;
    double complex z, X;
} point;

static point point_at(const rw_potential *p, double x, double y)
{
    const rw_place at = rw_place_of(p, x, y);
    point right = {.at = at, .is_remote = rw_is_remote(at.x, at.y), .z = rw_number(at.x, at.y)};
    right.X = right.z;
    if (!right.is_remote) {
        right.e = rw_elliptic_at(at.x, at.y, at.beyond);
        right.X = rw_number(right.e.sin_v * right.e.sinh_w, right.e.cos_v * right.e.cosh_w);
    }
    return right;
}

/* y^2/q. */
static double complex y2_over_corners(const rw_potential *p, const point *at)
{
    const double y = at->at.y;
    return y_over(y, rw_number(at->at.past, y)) * y_over(y, rw_number(at->at.x + p->alpha, y));
}

/* ---- By the place ---- */

static rw_curvature curvature_at(const rw_potential *p, const point *at)
{
    const double y = at->at.y;
    const double complex per_X = y_over(1, at->X), y2_per_X2 = y * y * (per_X * per_X);
    const double complex y2_per_q = y2_over_corners(p, at), z_per_y = rw_number(at->at.x / y, 1);
    const double complex corner = p->c0 * y2_per_q, edge = p->phi0_over_alpha * y2_per_X2;
    const double complex steepness = corner * (y2_per_X2 + 2 * y2_per_q) + 3 * (edge * y2_per_X2);
    return (rw_curvature){.K = 2 / RW_PI * ((corner + edge) * per_X),
                          .L = -2 / RW_PI * (steepness * z_per_y * per_X)};
}

rw_field rw_potential_with_curvature(const rw_potential *potential, double x, double y,
                                     rw_curvature *curvature)
{
    const point at = point_at(potential, x, y);
    *curvature = curvature_at(potential, &at);
    return potential->alpha < 1 ? rw_rounded_field(potential, at.at, at.e)
                                : rw_hertz_field(potential, at.at, at.e);
}

/* sin(v)^2 - alpha^2 from x - alpha, which does not cancel. */
static double from_corner(const rw_potential *p, const point *at)
{
    const double tip = p->alpha * at->e.sinh_w;
    return (at->at.past * (at->at.x + p->alpha) - tip * tip) / (at->e.cosh_w * at->e.cosh_w);
}

/* A/alpha; 0 where only the rounding touches. */
static double complex A_over_alpha(const rw_potential *p, const point *at)
{
    if (p->alpha >= 1)
        return 0;
    return rw_number(angle_part_of_A(p, &at->e, rw_elliptic_shrink(&at->e), from_corner(p, at)),
                     log_part_of_A(p, &at->e, at->at.past));
}

/* G' = -(2/pi) [ A/alpha + (phi0/alpha) R/X ]; of a remote point -b_0/(2 z^2). */
static double complex slope_of(const rw_potential *p, const point *at)
{
    const rw_elliptic *e = &at->e;
    if (at->is_remote)
        return -rw_first_coefficient(p) / 2 * (y_over(1, at->z) * y_over(1, at->z));
    const double complex RX =
        rw_number(rw_elliptic_RX_re(e, rw_elliptic_shrink(e)), -(e->sin_v * e->cos_v));
    return -2 / RW_PI * (A_over_alpha(p, at) + p->phi0_over_alpha / e->cos2 * RX);
}

rw_field rw_potential_by_x(const rw_potential *potential, double x, double y)
{
    const point at = point_at(potential, x, y);
    const double complex bend = y > 0 ? curvature_at(potential, &at).K / at.at.y : 0; /* y G'' */
    const double turned = x < 0 ? -potential->per_half_width : potential->per_half_width;
    return rw_field_multiple(
        turned, rw_mirrored(potential, x, y, field_of(slope_of(potential, &at), bend)));
}

/* ---- By the rounding ---- */

/* Where |z| > 2 alpha. */
static rw_field by_rounding_outside(const rw_potential *p, const point *at)
{
    enum { NODES = 16 };
    const double complex per_z = y_over(1, at->z), per_z2 = per_z * per_z;
    const double phi0 = p->phi0_over_alpha * p->alpha;
    double node[NODES], weight[NODES];
    /* means of s^2/(1 - s^2/z^2), and of its product with ((2 - s^2)/z^2 - 1)/(1 - s^2/z^2) */
    double complex G = 0, H = 0;
    rw_gauss(NODES, node, weight);
    for (int i = 0; i < NODES; i++) {
        const double s = sin(phi0 * node[i]), s2 = s * s;
        const double complex per_rest = y_over(1, 1 - s2 * per_z2);
        const double complex value = weight[i] * s2 * per_rest;
        G += value;
        H += value * per_rest * ((2 - s2) * per_z2 - 1);
    }
    const double factor = -2 / RW_PI * p->phi0_over_alpha;
    return field_of(factor * (at->X * per_z * per_z * G),
                    factor * (at->at.y * per_z * y_over(1, at->X) * H));
}

static rw_field by_rounding_inside(const rw_potential *p, const point *at)
{
    const double y = at->at.y, per = p->phi0_over_alpha;
    const double complex R = rw_elliptic_shrink(&at->e) * rw_number(at->e.sin_v, -at->e.cos_v);
    const double complex bend =
        y > 0 ? p->c0 * (at->z / y * y2_over_corners(p, at) * y_over(1, at->X)) : 0;
    return field_of(2 / RW_PI * (at->z * A_over_alpha(p, at) - per * R),
                    -(y * slope_of(p, at) + 2 / RW_PI * bend));
}

rw_field rw_potential_by_rounding(const rw_potential *potential, double x, double y)
{
    const double alpha = potential->alpha;
    if (alpha == 0)
        return (rw_field){0, 0, 0, 0};
    if (alpha >= 1)
        return rw_field_multiple(-1, rw_potential_at(potential, x, y));
    const point at = point_at(potential, x, y);
    const bool is_outside = at.at.x * at.at.x + at.at.y * at.at.y > 4 * alpha * alpha;
    return rw_mirrored(potential, x, y,
                       is_outside ? by_rounding_outside(potential, &at)
                                  : by_rounding_inside(potential, &at));
}

/* ---- By the half-width ---- */

rw_field rw_potential_by_half_width(const rw_potential *potential, double x, double y)
{
    const point at = point_at(potential, x, y);
    const double complex per_X = y_over(1, at.X);
    const rw_field punch = field_of(per_X, -(at.z * per_X * per_X * y_over(at.at.y, at.X)));
    return rw_field_multiple(2 / RW_PI * potential->phi0_over_alpha,
                             rw_mirrored(potential, x, y, punch));
}
