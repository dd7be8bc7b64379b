/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Complex numbers, as a compiler without C99's own has to have them spelt out. */
#ifndef RW_COMPLEX_H
#define RW_COMPLEX_H

#include "base/select.h"
#include "base/logarithm.h"

typedef struct {
    double re, im;
} rw_complex;

RW_INLINE rw_complex rw_sum(rw_complex a, rw_complex b)
{
    return (rw_complex){a.re + b.re, a.im + b.im};
}

RW_INLINE rw_complex rw_multiple(double factor, rw_complex a)
{
    return (rw_complex){factor * a.re, factor * a.im};
}

RW_INLINE rw_complex rw_product(rw_complex a, rw_complex b)
{
    return (rw_complex){a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

RW_INLINE rw_complex rw_quotient(rw_complex a, rw_complex b)
{
    const double scale = 1 / (b.re * b.re + b.im * b.im);
    return (rw_complex){(a.re * b.re + a.im * b.im) * scale, (a.im * b.re - a.re * b.im) * scale};
}

/* The root in the right half-plane. */
static inline rw_complex rw_complex_root(rw_complex z)
{
    const double r = sqrt(z.re * z.re + z.im * z.im);
    const double large = sqrt((r + fabs(z.re)) / 2);
    const double small = large > 0 ? fabs(z.im) / (2 * large) : 0;
    return z.re >= 0 ? (rw_complex){large, copysign(small, z.im)}
                     : (rw_complex){small, copysign(large, z.im)};
}

#endif
