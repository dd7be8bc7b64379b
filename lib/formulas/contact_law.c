/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The contact law: load and half-width. */
#include "rwedge.h"

#include "base/domain.h"
#include "base/root.h"

double rwedge_load(double alpha)
{
    if (!rw_is_magnitude(alpha))
        return NAN;
    if (alpha == 0)
        return 2;
    if (alpha >= 1)
        return RW_HALF_PI / alpha; /* only the rounded part touches */
    return asin(alpha) / alpha + rw_cos_asin(alpha);
}

/* The difference of the two sides of A P/(theta b) = (A P/(theta a)) alpha. It grows with alpha. */
static double excess(double alpha, const void *AP_over_theta_a)
{
    return *(const double *)AP_over_theta_a * alpha - rwedge_load(alpha);
}

/* The load lies between pi/2 (Hertz, alpha = 1) and 2 (sharp). This brackets alpha. The ends of the
 * bracket are moved outwards by a few bits, because rounding may put a root just outside. */
static double solve_for_alpha(double load)
{
    if (load <= RW_HALF_PI) /* Hertz */
        return sqrt(RW_HALF_PI) / sqrt(load);
    if (load > 2e8)
        return 2 / load; /* the next term is alpha^2/6 of it */
    const double outwards = 4e-16;
    const double lo = RW_HALF_PI / load * (1 - outwards);
    const double hi = fmin(1, 2 / load * (1 + outwards));
    return rw_root(excess, &load, lo, hi, 0);
}

double rwedge_a_over_b(double AP_over_theta_a)
{
    if (!isfinite(AP_over_theta_a) || AP_over_theta_a <= 0)
        return NAN;
    const double alpha = solve_for_alpha(AP_over_theta_a);
    return rw_is_positive(alpha) ? alpha : NAN;
}
