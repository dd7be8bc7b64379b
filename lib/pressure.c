/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The contact pressure, and where it is largest. */
#include "rwedge.h"

#include "domain.h"

#include <float.h>

/* Eq. (14): arcosh(1/x), for x near 1 and near 0. */
static double sharp_wedge(double x)
{
    const double s = rw_cos_asin(x);
    return -2 / RW_PI * (x > 0.5 ? asinh(s / x) : log1p(s) - log(x));
}

/* ln|sin(phi+phi0)/sin(phi-phi0)|, sin(phi +- phi0) = A +- B, x != alpha. Where one of A, B is small beside the other the
 * logarithm is small; elsewhere (A+B)(A-B) = (x+alpha)(x-alpha) gives the difference from two that are exact. */
static double log_of_ratio(double alpha, double x, double A, double B)
{
    const double large = fmax(A, B), small = fmin(A, B);
    if (2 * small < large)
        return 2 * atanh(small / large);
    const double sum = A + B;
    return log(sum / fabs(x - alpha) * (sum / (x + alpha)));
}

/* Eq. (8), 0 < alpha < 1, 0 <= x < 1. With s = cos(phi), sin(phi +- phi0) = c0 x +- alpha s and
 *     pi p = 2 ln((c0 x + alpha s)/(c0 + s)) + ((x - alpha)/alpha) ln|sin(phi+phi0)/sin(phi-phi0)| - 2 phi0 s/alpha:
 * the paper's two logarithms share their singularity at x = alpha; here it is gone from the first, and the second is
 * multiplied by its zero. */
static double rounded_wedge(double alpha, double x)
{
    const double c0 = rw_cos_asin(alpha), s = rw_cos_asin(x);
    const double A = c0 * x, B = alpha * s;
    const double below_one = (c0 * (1 - x) + s * (1 - alpha)) / (c0 + s);
    const double first = below_one < 0.5 ? log1p(-below_one) : log((A + B) / (c0 + s));
    double sum = 2 * (first - asin(alpha) / alpha * s);
    if (x != alpha)
        sum += (x - alpha) / alpha * log_of_ratio(alpha, x, A, B);
    return sum / RW_PI;
}

double rwedge_pressure(double alpha, double x)
{
    if (!rw_is_nonnegative(alpha) || !isfinite(x))
        return NAN;
    x = fabs(x);
    if (x >= 1)
        return 0;
    if (alpha >= 1)
        return -rw_cos_asin(x) / alpha;
    if (alpha == 0 && x == 0)
        return NAN;
    if (alpha == 0 || alpha < x * DBL_EPSILON * DBL_EPSILON) /* sharp to the last bit; and x/alpha might overflow */
        return sharp_wedge(x);
    return rounded_wedge(alpha, x);
}

double rwedge_peak_pressure(double alpha)
{
    if (!rw_is_nonnegative(alpha) || alpha == 0)
        return NAN;
    if (alpha >= 1)
        return 1 / alpha;
    const double c0 = rw_cos_asin(alpha); /* tan(phi0/2) = alpha/(1 + c0) */
    return 2 / RW_PI * (asin(alpha) / alpha - log(alpha / (1 + c0)));
}

double rwedge_transition_pressure(double alpha)
{
    if (!rw_is_nonnegative(alpha) || alpha == 0)
        return NAN;
    if (alpha >= 1)
        return 0;
    return 2 / RW_PI * (asin(alpha) / alpha * rw_cos_asin(alpha) - log(alpha));
}
