/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The one transcendental function of unlike bodies that slide,
 *     Phi(w; a) = int_0^1 v^(a-1)/(1 - w v) dv,   0 < a < 1,
 * which is 2F1(1, a; 1 + a; w)/a, for |w| <= 1. Where |1 - w| >= 1/2 it is Gauss's and Jacobi's
 * rule of NODES points; nearer to 1 a series in 1 - w with its logarithm. Error below 1e-13 of the
 * value for 0.05 <= a <= 0.95. */
#ifndef RW_POWER_INTEGRAL_H
#define RW_POWER_INTEGRAL_H

#include "base/complex.h"

enum { RW_POWER_NODES = 20, RW_POWER_TERMS = 52 };

/* What depends on a alone. */
typedef struct {
    double a;
    double node[RW_POWER_NODES], weight[RW_POWER_NODES];
    double coefficient[RW_POWER_TERMS], shift[RW_POWER_TERMS]; /* of (1 - w)^k; beside -ln(1 - w) */
} rw_power_rule;

void rw_power_rule_init(rw_power_rule *rule, double a);

/* `rest` is 1 - w, and `angle` its argument, so that w may be on the cut beyond 1. */
rw_complex rw_power_integral(const rw_power_rule *rule, rw_complex w, rw_complex rest,
                             double angle);

/* The same for a real w <= 0. */
double rw_power_integral_below(const rw_power_rule *rule, double w);

#endif
