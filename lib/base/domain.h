/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The domains of the arguments, and the constants that several rooms need. Comparing a NaN with
 * >= would raise the invalid-operation flag in the host: isfinite() comes first, or a comparison
 * that does not. */
#ifndef RW_DOMAIN_H
#define RW_DOMAIN_H

#include <math.h>
#include <stdbool.h>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "rwedge relies on IEEE arithmetic: build it without -ffast-math"
#endif

#define RW_PI 3.14159265358979323846
#define RW_HALF_PI 1.57079632679489661923

/* What a contact can have: the domain of every length, load, modulus and stress, and of their
 * ratios a/b, x/b, c/b. The header says so once, for all functions. The squares and fourth powers
 * of such numbers, and their products with each other, stay in the range of a double. */
#define RW_SMALLEST 1e-60
#define RW_LARGEST 1e60

/* The comparisons raise no exception for NaN. */
static inline bool rw_is_positive(double v)
{
    return isgreaterequal(v, RW_SMALLEST) && islessequal(v, RW_LARGEST);
}

/* A number of that domain, or 0: a ratio a/b, a depth, a load. */
static inline bool rw_is_magnitude(double v)
{
    return v == 0 || rw_is_positive(v);
}

/* The same with any sign: a place along the surface, a tangential force. */
static inline bool rw_is_signed(double v)
{
    return rw_is_magnitude(fabs(v));
}

/* A stress to be measured. It may come from anywhere, and be as small as it likes. */
static inline bool rw_is_stress(double v)
{
    return islessequal(fabs(v), RW_LARGEST);
}

/* The smallest tip that has a strength, besides the sharp wedge, 0. At smaller ones, for nu near
 * 1/2 and little friction, J2 is flat to rounding between the depths a and sqrt(a b), and its
 * maximum there cannot be found. */
#define RW_SMALLEST_TIP 1e-14

static inline bool rw_is_tip(double alpha)
{
    return rw_is_magnitude(alpha) && (alpha == 0 || alpha >= RW_SMALLEST_TIP);
}

/* A coefficient of friction: at 10^6 the traction is nearly tangential. */
static inline bool rw_is_friction(double f)
{
    return rw_is_magnitude(f) && f <= 1e6;
}

/* A half-width of the stick zone c/b. */
static inline bool rw_is_stick(double c)
{
    return rw_is_magnitude(c) && c <= 1;
}

/* A load ratio Q/(fP). */
static inline bool rw_is_fraction(double v)
{
    return isfinite(v) && v >= 0 && v <= 1;
}

/* Poisson's ratio where it enters the yield criterion. */
static inline bool rw_is_poisson(double nu)
{
    return isfinite(nu) && nu >= 0 && nu <= 0.5;
}

/* cos(asin(v)), with no cancellation near v = 1. */
static inline double rw_cos_asin(double v)
{
    return sqrt((1 - v) * (1 + v));
}

#endif
