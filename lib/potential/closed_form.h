/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The closed form of the potential. In elliptic coordinates z = sin(zeta), zeta = v + i w, w >=
 * 0, it is Eq. (8) read at a complex angle (lib/README.md, "The potential"). With R = z - X = -i
 * exp(i zeta), X = sqrt(z^2-1) = i cos(zeta),
 *
 *     G  =  (2/pi) [ B - ((z-alpha)/alpha) A + (phi0/alpha) R ],     S+- = sin(zeta +- phi0),
 *     G' = -(2/pi) [ A/alpha + (phi0/alpha) R/X ],
 *     A  = (i/2) ln( e^(-2i phi0) S-/S+ ),
 *     B  = i ln( -i e^(i phi0) S+/(cos(zeta) + c0) )
 *
 * for x >= 0; the other half follows by symmetry. No large terms cancel. A is infinite at z =
 * alpha, but it is multiplied by z - alpha there. Far away A, B and R are small, as G is. sin v,
 * cos v, sinh w, cosh w are nonnegative and come from z by square roots, each to full relative
 * accuracy.
 *
 * The formula for a point has no call and no branch: compilers can make vector instructions of a
 * loop over it (select.h). No divisor is 0 and no root has a negative argument, whichever value
 * is selected later. So no compiler can make it raise division by zero or invalid. */
#ifndef RW_CLOSED_FORM_H
#define RW_CLOSED_FORM_H

#include "base/domain.h"
#include "potential/elliptic.h"
#include "base/logarithm.h"
#include "potential/potential.h"

/* A point of the right half over the half-width. The two differences are taken before the
 * division, which would lose their digits. */
typedef struct {
    double x, y;
    double beyond, past; /* x - 1, x - alpha */
} rw_place;

RW_INLINE rw_place rw_place_of(const rw_potential *p, double x, double y)
{
    const double per_c = p->per_half_width, right = fabs(x);
    return (rw_place){.x = right * per_c,
                      .y = y * per_c,
                      .beyond = (right - p->half_width) * per_c,
                      .past = (right - p->a) * per_c};
}

/* Hertz: G = R/alpha, y G' = -y R/(X alpha). e are the coordinates of the place. */
RW_INLINE rw_field rw_hertz_field(const rw_potential *p, rw_place at, rw_elliptic e)
{
    const double shrink = rw_elliptic_shrink(&e), factor = -at.y / e.cos2 * p->per_alpha;
    return (rw_field){shrink * e.sin_v * p->per_alpha, -shrink * e.cos_v * p->per_alpha,
                      factor * rw_elliptic_RX_re(&e, shrink), factor * -(e.sin_v * e.cos_v)};
}

/* The imaginary part of A over alpha, (1/2) ln|S-/S+|. S+ S- is (z-alpha)(z+alpha), whose
 * factors are exact differences, and |sin(v + i w)|^2 = sin(v)^2 + sinh(w)^2, so that |S+|^2 -
 * |S-|^2 = 4 c0 alpha sin(v) cos(v). */
RW_INLINE double log_part_of_A(const rw_potential *p, const rw_elliptic *e, double past)
{
    /* Added to the product it is lost in rounding, but for z = alpha, where the product is 0.
     * There the logarithm is multiplied by 0, and any finite one will do. */
    static const double ZERO_SQUARED = 0x1p-1000;
    const double plus = e->x + p->alpha, y2 = e->y * e->y;
    const double sine = p->c0 * e->sin_v + p->alpha * e->cos_v;
    const double sum2 = sine * sine + e->sinh_w * e->sinh_w;
    const double product2 = (past * past + y2) * (plus * plus + y2) + ZERO_SQUARED;
    return -0.25 * rw_log_of_quotient_over(sum2 * sum2, product2,
                                           4 * p->c0 * e->sin_v * e->cos_v * sum2, p->alpha,
                                           p->per_alpha);
}

/* sin(v)^2 - alpha^2. Next to the corner it cancels, but there A is multiplied by z - alpha. */
RW_INLINE double from_corner_of(const rw_potential *p, const rw_elliptic *e)
{
    return e->sin_v * e->sin_v - p->alpha * p->alpha;
}

/* The real part of A over alpha, phi0/alpha less half the angle of S-/S+. `shrink` is cosh(w) -
 * sinh(w): with it neither coordinate cancels for large w. */
RW_INLINE double angle_part_of_A(const rw_potential *p, const rw_elliptic *e, double shrink,
                                 double from_corner)
{
    const double alpha = p->alpha, c0 = p->c0, cos_2phi0 = 1 - 2 * alpha * alpha,
                 sin_2phi0 = 2 * alpha * c0;
    const double x = cos_2phi0 * (from_corner + cos_2phi0 * (e->sinh_w * e->sinh_w)) +
                     sin_2phi0 * sin_2phi0 * (e->sinh_w * e->cosh_w);
    const double y = 2 * c0 * (from_corner - cos_2phi0 * (e->sinh_w * shrink));
    return 0.5 * rw_angle_over(x, y, alpha, p->per_alpha);
}

/* It holds below alpha = 1. E = S+/(cos(zeta) + c0) is (E_re + i E_im)/E_size, all three
 * nonnegative, and |E|^2 - 1 = -2 c0 cos(v)/E_size. */
RW_INLINE rw_field rw_rounded_field(const rw_potential *p, rw_place at, rw_elliptic e)
{
    const double shrink = rw_elliptic_shrink(&e), alpha = p->alpha, c0 = p->c0;
    const double A_im = log_part_of_A(p, &e, at.past),
                 A_re = angle_part_of_A(p, &e, shrink, from_corner_of(p, &e));

    const double E_re = e.sin_v + alpha * e.cosh_w, E_im = c0 * e.sinh_w;
    const double E_size = e.cosh_w + c0 * e.cos_v + alpha * e.sin_v;
    const double B_im = 0.5 * rw_log_of_quotient_over(E_re * E_re + E_im * E_im, E_size * E_size,
                                                      -2 * c0 * e.cos_v * E_size, 1, 1);
    const double B_re = rw_angle(alpha * E_re + c0 * E_im, c0 * (e.sin_v + alpha * shrink));

    const double per = p->phi0_over_alpha, per_cos2 = per / e.cos2;
    const double G_re = B_re - (at.past * A_re - at.y * A_im) + per * (shrink * e.sin_v);
    const double G_im = B_im - (at.past * A_im + at.y * A_re) - per * (shrink * e.cos_v);
    const double D_re = A_re + per_cos2 * rw_elliptic_RX_re(&e, shrink);
    const double D_im = A_im - per_cos2 * (e.sin_v * e.cos_v);
    const double y = -(2 / RW_PI) * at.y;
    return (rw_field){2 / RW_PI * G_re, 2 / RW_PI * G_im, y * D_re, y * D_im};
}

/* The field at the point itself, from that at its mirror image in the right half: p is even, so
 * G(-conj z) = -conj G(z). On the surface outside the contact the pressure is exactly 0. */
RW_INLINE rw_field rw_mirrored(const rw_potential *p, double x, double y, rw_field right)
{
    const double left = x + 0.0, inside = fabs(x) - p->half_width;
    const double pressed = rw_if_negative(inside, inside, 0 - y);
    return (rw_field){rw_if_negative(left, -right.G_re, right.G_re),
                      rw_if_negative(pressed, right.G_im, 0), right.H_re,
                      rw_if_negative(left, -right.H_im, right.H_im)};
}

#endif
