/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Elliptic coordinates about the contact: z = sin(zeta), zeta = v + i w. The contact is w = 0, |v| <= pi/2. */
#ifndef RW_ELLIPTIC_H
#define RW_ELLIPTIC_H

#include <float.h>
#include <math.h>
#include <stdbool.h>

/* A point with x >= 0: all of these are nonnegative, and each is accurate relatively. */
typedef struct {
    double x, y;
    double sin_v, cos_v, sinh_w, cosh_w;
} rw_elliptic;

/* x >= 0, y >= 0, both below 1e8 or so; beyond is x - 1. False where the point cannot be told from the edge
 * x = 1, y = 0 (x = 1 and y below 1e-154, where y^2 would underflow); *e is the edge then.
 * sinh(w) cos(v) = y and sinh(w)^2 - cos(v)^2 = |z|^2 - 1 =: m: a quadratic whose larger root has no cancellation. Where m
 * cancels (|z| near 1) its error is small beside 2 y. */
static inline bool rw_elliptic_coordinates(double x, double y, double beyond, rw_elliptic *e)
{
    const double m = beyond * (x + 1) + y * y;
    const double discriminant = m * m + 4 * y * y;
    *e = (rw_elliptic){.x = x, .y = y, .sin_v = 1, .cos_v = 0, .sinh_w = 0, .cosh_w = 1};
    if (discriminant < DBL_MIN)
        return false;
    const double larger = sqrt((fabs(m) + sqrt(discriminant)) / 2);
    const double smaller = y / larger;
    e->sinh_w = m >= 0 ? larger : smaller;
    e->cos_v = m >= 0 ? smaller : larger;
    e->cosh_w = sqrt(1 + e->sinh_w * e->sinh_w);
    e->sin_v = x / e->cosh_w;
    return true;
}

/* Beyond 1e8 R = 1/(2z) to the last bit. */
static inline bool rw_is_remote(double x, double y)
{
    return x > 1e8 || y > 1e8;
}

/* A point that far, from any direction; the quarter keeps the modulus of the largest doubles finite. */
typedef struct {
    double cosine, sine; /* of the angle of z */
    double R_re, R_im;   /* 1/(2z) */
} rw_ray;

static inline rw_ray rw_ray_to(double x, double y)
{
    const double r = hypot(x / 4, y / 4), cosine = x / 4 / r, sine = y / 4 / r;
    return (rw_ray){cosine, sine, cosine / 8 / r, -sine / 8 / r};
}

/* |R| = exp(-w), where R = z - sqrt(z^2-1) = -i exp(i zeta). */
static inline double rw_elliptic_shrink(const rw_elliptic *e)
{
    return 1 / (e->sinh_w + e->cosh_w);
}

#endif
