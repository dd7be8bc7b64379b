/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The one transcendental function of unlike bodies that slide,
 *     Phi(w; a) = int_0^1 v^(a-1)/(1 - w v) dv,   0 < a < 1,
 * which is 2F1(1, a; 1 + a; w)/a, for |w| <= 1. It is analytic but for the cut beyond w = 1, which
 *     u = (1 - root(1 - w))/(1 + root(1 - w))
 * makes a circle: a series in u. Nearer to 1, where Re w > 1/2, Phi + w^(-a) ln(1 - w) is a series
 * in u of 1 - w. In both |u| is at most tan(pi/12). Error below 1e-15 of the value for 0.05 <= a <=
 * 0.95. */
#ifndef RW_POWER_INTEGRAL_H
#define RW_POWER_INTEGRAL_H

#include "base/complex.h"

enum { RW_POWER_TERMS = 27 };

/* What depends on a alone: the coefficients of both series. */
typedef struct {
    double a, whole; /* whole: pi/sin(pi a) */
    double far[RW_POWER_TERMS], near[RW_POWER_TERMS];
} rw_power_rule;

void rw_power_rule_init(rw_power_rule *rule, double a);

/* Below 0 where w is near 1. */
RW_INLINE double rw_power_farness(rw_complex w)
{
    return 0.5 - w.re;
}

/* u from w and 1 - w, which is used near 1. */
RW_INLINE rw_complex rw_power_place(rw_complex w, rw_complex rest)
{
    const double is_far = rw_power_farness(w);
    const rw_complex m = {rw_if_negative(is_far, w.re, 1 - w.re),
                          rw_if_negative(is_far, w.im, -w.im)},
                     other = {rw_if_negative(is_far, rest.re, w.re),
                              rw_if_negative(is_far, rest.im, w.im)};
    /* its root is right of the axis, because m.re >= 1/2 */
    const double root = sqrt((m.re + sqrt(m.re * m.re + m.im * m.im)) / 2);
    return rw_quotient(other,
                       (rw_complex){1 + m.re + 2 * root, m.im + m.im / root}); /* (1 + root)^2 */
}

/* Phi for a real w, -1 <= w <= 0. */
double rw_power_integral_below(const rw_power_rule *rule, double w);

#endif
