/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The contact law: load and half-width. */
#include "formulas/contact_law.h"

#include "base/domain.h"
#include "base/root.h"
#include "rwedge.h"

double rw_asin_excess(double q)
{
    if (q > 0.5)
        return asin(q) - q;
    /* q^3/6 + 3 q^5/40 + ...: at q = 0.5 the 24th term is below 2e-16 of the first */
    double term = q, sum = 0;
    for (int n = 1; n < 26; n++) {
        term *= q * q * (2 * n - 1) / (2 * n);
        sum += term / (2 * n + 1);
    }
    return sum;
}

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

/* -(phi0 - alpha c0)/alpha^2, of which phi0 - alpha and 1 - c0 are taken apart. */
double rwedge_load_derivative(double alpha)
{
    if (!rw_is_magnitude(alpha))
        return NAN;
    if (alpha >= 1)
        return -RW_HALF_PI / alpha / alpha;
    const double rise = alpha > 0 ? rw_asin_excess(alpha) / alpha / alpha : 0;
    return -rise - alpha / (1 + rw_cos_asin(alpha));
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
