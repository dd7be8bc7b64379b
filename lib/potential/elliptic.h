/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Elliptic coordinates about the contact: z = sin(zeta), zeta = v + i w. The contact is w = 0,
 * |v| <= pi/2. */
#ifndef RW_ELLIPTIC_H
#define RW_ELLIPTIC_H

#include "base/complex.h"
#include "potential/potential.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>

/* A point with x >= 0. All members are nonnegative and have a small relative error. */
typedef struct {
    double x, y;
    double sin_v, cos_v, sinh_w, cosh_w;
    double cos2; /* |cos(zeta)|^2, not 0 */
} rw_elliptic;

/* The place has x >= 0, y >= 0, both below 1e8 or so; beyond is x - 1.
 *
 * sinh(w) cos(v) = y and sinh(w)^2 - cos(v)^2 = |z|^2 - 1 =: m make a quadratic equation. Its
 * larger root has no cancellation, and the smaller one is y over it. m itself cancels for |z|
 * near 1, but its error is then small beside 2 y. The root of the discriminant is |cos(zeta)|^2.
 * DBL_MIN keeps it away from 0 at the edge x = 1, y = 0; elsewhere it is lost in rounding. */
RW_INLINE rw_elliptic rw_elliptic_at(double x, double y, double beyond)
{
    const double m = beyond * (x + 1) + y * y;
    const double cos2 = sqrt(m * m + 4 * y * y + DBL_MIN);
    const double larger = sqrt((fabs(m) + cos2) / 2), smaller = y / larger;
    const double sinh_w = rw_if_negative(m, smaller, larger), cosh_w = sqrt(1 + sinh_w * sinh_w);
    return (rw_elliptic){.x = x,
                         .y = y,
                         .sin_v = x / cosh_w,
                         .cos_v = rw_if_negative(m, larger, smaller),
                         .sinh_w = sinh_w,
                         .cosh_w = cosh_w,
                         .cos2 = cos2};
}

/* Beyond 1e8 half-widths R is 1/(2z) to the last bit. */
static inline bool rw_is_remote(double x, double y)
{
    return x > 1e8 || y > 1e8;
}

/* A remote point. */
typedef struct {
    double cosine, sine; /* of the angle of z */
    double R_re, R_im;   /* 1/(2z) */
} rw_ray;

static inline rw_ray rw_ray_to(double x, double y)
{
    const double large = x > y ? x : y, u = x / large, v = y / large;
    const double r = sqrt(u * u + v * v), cosine = u / r, sine = v / r;
    return (rw_ray){cosine, sine, cosine / 2 / r / large, -sine / 2 / r / large};
}

/* |R| = exp(-w), where R = z - sqrt(z^2-1) = -i exp(i zeta). */
RW_INLINE double rw_elliptic_shrink(const rw_elliptic *e)
{
    return 1 / (e->sinh_w + e->cosh_w);
}

/* The real part of R/X times |cos(zeta)|^2; the imaginary part is -sin(v) cos(v). */
RW_INLINE double rw_elliptic_RX_re(const rw_elliptic *e, double shrink)
{
    return shrink * (e->sin_v * e->sin_v * e->sinh_w - e->cos_v * e->cos_v * e->cosh_w);
}

/* R and y/X at x >= 0, y >= 0, or at the mirror image of that place, sign = -1. */
typedef struct {
    rw_complex R, y_over_X;
} rw_outer_place;

static inline rw_outer_place rw_outer_place_of(double x, double y, double beyond, double sign)
{
    if (rw_is_remote(x, y)) { /* X = z */
        const rw_ray ray = rw_ray_to(x, y);
        return (rw_outer_place){{sign * ray.R_re, ray.R_im},
                                {sign * ray.sine * ray.cosine, -(ray.sine * ray.sine)}};
    }
    const rw_elliptic e = rw_elliptic_at(x, y, beyond);
    const double shrink = rw_elliptic_shrink(&e), scale = y / e.cos2;
    return (rw_outer_place){{sign * shrink * e.sin_v, -shrink * e.cos_v},
                            {sign * (scale * (e.sin_v * e.sinh_w)), -scale * (e.cos_v * e.cosh_w)}};
}

/* The field of G = sum a_k R^(k+1), by Horner's rule: -X G' is the sum with the weights (k+1)
 * a_k. */
static inline rw_field rw_series_field(size_t terms, const double a[], rw_outer_place at)
{
    rw_complex sum = {0, 0}, steep = {0, 0};
    for (size_t k = terms; k > 0; k--) {
        sum.re += a[k - 1];
        steep.re += (double)k * a[k - 1];
        sum = rw_product(sum, at.R);
        steep = rw_product(steep, at.R);
    }
    const rw_complex H = rw_product(steep, at.y_over_X);
    return (rw_field){sum.re, sum.im, -H.re, -H.im};
}

#endif
