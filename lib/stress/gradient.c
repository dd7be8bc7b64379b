/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Derivatives of the closed form. With X = sqrt(z^2-1), q = (z-alpha)(z+alpha), and A and R as in
 * closed_form.h, in the half-width of the patch,
 *     G''           =  (2/pi) [ c0/(X q) + (phi0/alpha)/X^3 ],
 *     alpha dG/da   =  (2/pi) [ z A/alpha - (phi0/alpha) R ],
 *     alpha dG'/da  = -G' - (2/pi) c0 z/(X q),
 *     c dG/dc       =  (2/pi) (phi0/alpha)/X.
 * The two derivatives by the rounding fall like (alpha/z)^2 beside their terms. So far from the
 * rounding they are computed from
 *     alpha dG/da   = -(2/(pi alpha)) X int s^2/(z^2 - s^2) dpsi,
 * s = sin(psi), 0 <= psi <= phi0. */
#include "stress/gradient.h"

#include "base/complex.h"
#include "base/root.h"
#include "rwedge.h"
#include "potential/closed_form.h"

static rw_complex root_of(const rw_elliptic *e)
{
    return (rw_complex){e->sin_v * e->sinh_w, e->cos_v * e->cosh_w};
}

static rw_field field_of(rw_complex G, rw_complex H)
{
    return (rw_field){G.re, G.im, H.re, H.im};
}

/* ---- By the place ---- */

/* sin(v)^2 - alpha^2 from x - alpha, which does not cancel. */
static double from_corner(const rw_potential *p, rw_place at, const rw_elliptic *e)
{
    const double tip = p->alpha * e->sinh_w;
    return (at.past * (at.x + p->alpha) - tip * tip) / (e->cosh_w * e->cosh_w);
}

/* A/alpha; 0 where only the rounding touches. */
static rw_complex A_over_alpha(const rw_potential *p, rw_place at, const rw_elliptic *e)
{
    if (p->alpha >= 1)
        return (rw_complex){0, 0};
    return (rw_complex){angle_part_of_A(p, e, rw_elliptic_shrink(e), from_corner(p, at, e)),
                        log_part_of_A(p, e, at.past)};
}

/* G' = -(2/pi) [ A/alpha + (phi0/alpha) R/X ]. */
static rw_complex slope_of(const rw_potential *p, rw_place at, const rw_elliptic *e)
{
    const double per_cos2 = p->phi0_over_alpha / e->cos2;
    const rw_complex A = A_over_alpha(p, at, e);
    const rw_complex edge = {per_cos2 * rw_elliptic_RX_re(e, rw_elliptic_shrink(e)),
                             -per_cos2 * (e->sin_v * e->cos_v)};
    return rw_multiple(-2 / RW_PI, rw_sum(A, edge));
}

/* y c0/(X q). */
static rw_complex corner_of(const rw_potential *p, rw_place at, rw_complex X)
{
    const rw_complex left = {at.x + p->alpha, at.y}, right = {at.past, at.y};
    const rw_complex y_over_X = rw_quotient((rw_complex){p->c0 * at.y, 0}, X);
    return p->c0 > 0 ? rw_quotient(rw_quotient(y_over_X, left), right) : (rw_complex){0, 0};
}

/* y/X^3, as the one quotient that is small is taken first. */
static rw_complex y_over_cube(double y, rw_complex X)
{
    return rw_quotient(rw_quotient(rw_quotient((rw_complex){y, 0}, X), X), X);
}

static rw_field by_x(const rw_potential *p, rw_place at)
{
    const rw_elliptic e = rw_elliptic_at(at.x, at.y, at.beyond);
    const rw_complex X = root_of(&e);
    const rw_complex edge = rw_multiple(p->phi0_over_alpha, y_over_cube(at.y, X));
    return field_of(slope_of(p, at, &e), rw_multiple(2 / RW_PI, rw_sum(corner_of(p, at, X), edge)));
}

/* G' = -b_0/(2 z^2), y G'' = 2 y b_0/(2 z^3); H = -y b_0/(2 z^2). */
static rw_field remote_by_x(const rw_potential *p, rw_place at)
{
    const rw_ray ray = rw_ray_to(at.x, at.y);
    const rw_complex turn = {ray.cosine, -ray.sine}, R = {ray.R_re, ray.R_im};
    const double b0 = rw_first_coefficient(p), per_z = 2 * sqrt(R.re * R.re + R.im * R.im);
    const rw_complex slope = rw_multiple(-b0 * per_z, rw_product(R, turn));
    return field_of(slope, rw_multiple(-2 * ray.sine, rw_product(slope, turn)));
}

rw_field rw_potential_by_x(const rw_potential *potential, double x, double y)
{
    const rw_place at = rw_place_of(potential, x, y);
    const rw_field right =
        rw_is_remote(at.x, at.y) ? remote_by_x(potential, at) : by_x(potential, at);
    const double turned = x < 0 ? -potential->per_half_width : potential->per_half_width;
    return rw_field_multiple(turned, rw_mirrored(potential, x, y, right));
}

/* ---- By the rounding ---- */

/* The integrals of s^2/(1 - s^2/z^2), and of its product with ((2 - s^2)/z^2 - 1)/(1 - s^2/z^2):
 * their real and imaginary parts. */
typedef struct {
    rw_complex per_z2;
    bool of_H, imaginary;
} kernel;

static double kernel_at(double psi, const void *context)
{
    const kernel *k = context;
    const double s2 = sin(psi) * sin(psi);
    const rw_complex rest = {1 - s2 * k->per_z2.re, -s2 * k->per_z2.im};
    const rw_complex G = rw_quotient((rw_complex){s2, 0}, rest);
    const rw_complex factor = {(2 - s2) * k->per_z2.re - 1, (2 - s2) * k->per_z2.im};
    const rw_complex value = k->of_H ? rw_quotient(rw_product(G, factor), rest) : G;
    return k->imaginary ? value.im : value.re;
}

static rw_complex kernel_integral(rw_complex per_z2, bool of_H, double phi0)
{
    const kernel re = {per_z2, of_H, false}, im = {per_z2, of_H, true};
    return (rw_complex){rw_integral(kernel_at, &re, 0, phi0), rw_integral(kernel_at, &im, 0, phi0)};
}

/* Where |z| > 2 alpha. */
static rw_field by_rounding_outside(const rw_potential *p, rw_place at)
{
    const rw_elliptic e = rw_elliptic_at(at.x, at.y, at.beyond);
    const double factor = -2 / RW_PI * p->per_alpha, phi0 = p->phi0_over_alpha * p->alpha;
    const rw_complex X = root_of(&e), one = {1, 0};
    const rw_complex per_z = rw_quotient(one, (rw_complex){at.x, at.y});
    const rw_complex per_z2 = rw_product(per_z, per_z);
    const rw_complex G = rw_product(rw_product(X, per_z), per_z);
    const rw_complex H = rw_quotient(rw_multiple(at.y, per_z), X);
    return field_of(rw_multiple(factor, rw_product(G, kernel_integral(per_z2, false, phi0))),
                    rw_multiple(factor, rw_product(H, kernel_integral(per_z2, true, phi0))));
}

static rw_field by_rounding_inside(const rw_potential *p, rw_place at)
{
    const rw_elliptic e = rw_elliptic_at(at.x, at.y, at.beyond);
    const rw_complex z = {at.x, at.y}, shrink = {rw_elliptic_shrink(&e), 0};
    const rw_complex R = rw_product(shrink, (rw_complex){e.sin_v, -e.cos_v});
    const rw_complex zA = rw_product(z, A_over_alpha(p, at, &e));
    const rw_complex bend = rw_product(z, corner_of(p, at, root_of(&e)));
    const rw_complex slope = slope_of(p, at, &e);
    return field_of(
        rw_multiple(2 / RW_PI, rw_sum(zA, rw_multiple(-p->phi0_over_alpha, R))),
        rw_multiple(-1, rw_sum(rw_multiple(at.y, slope), rw_multiple(2 / RW_PI, bend))));
}

/* a d/da of ln b_0, b_0 = (2/pi) (phi0/alpha + c0). c0 has digits next to alpha = 1 that alpha has
 * not; for small alpha the difference would cancel. */
static double rate_of_force(const rw_potential *p)
{
    const double rate =
        p->alpha < 0.5 ? p->alpha * rwedge_load_derivative(p->alpha) : p->c0 - p->phi0_over_alpha;
    return rate / (p->phi0_over_alpha + p->c0);
}

rw_field rw_potential_by_rounding(const rw_potential *potential, double x, double y)
{
    const rw_place at = rw_place_of(potential, x, y);
    const double alpha = potential->alpha;
    if (alpha == 0)
        return (rw_field){0, 0, 0, 0};
    if (alpha >= 1)
        return rw_field_multiple(-1, rw_potential_at(potential, x, y));
    if (rw_is_remote(at.x, at.y)) /* G = b_0/(2z) */
        return rw_field_multiple(rate_of_force(potential), rw_potential_at(potential, x, y));
    const bool outside = at.x * at.x + at.y * at.y > 4 * alpha * alpha;
    return rw_mirrored(potential, x, y,
                       outside ? by_rounding_outside(potential, at)
                               : by_rounding_inside(potential, at));
}

/* ---- By the half-width ---- */

static rw_field flat_punch(rw_place at)
{
    const rw_elliptic e = rw_elliptic_at(at.x, at.y, at.beyond);
    const rw_complex X = root_of(&e), z = {at.x, at.y};
    return field_of(rw_quotient((rw_complex){1, 0}, X),
                    rw_multiple(-1, rw_product(z, y_over_cube(at.y, X))));
}

/* 1/z, -y/z^2. */
static rw_field remote_force(rw_place at)
{
    const rw_ray ray = rw_ray_to(at.x, at.y);
    const rw_complex R = {2 * ray.R_re, 2 * ray.R_im}, turn = {ray.cosine, -ray.sine};
    return field_of(R, rw_multiple(-ray.sine, rw_product(R, turn)));
}

rw_field rw_potential_by_half_width(const rw_potential *potential, double x, double y)
{
    const rw_place at = rw_place_of(potential, x, y);
    const rw_field right = rw_is_remote(at.x, at.y) ? remote_force(at) : flat_punch(at);
    return rw_field_multiple(2 / RW_PI * potential->phi0_over_alpha,
                             rw_mirrored(potential, x, y, right));
}
