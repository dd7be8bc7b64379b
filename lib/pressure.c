/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The contact pressure, and where it is largest. */
#include "pressure.h"

#include "domain.h"
#include "rwedge.h"

#include <float.h>

/* Eq. (14): arcosh(c/x), for x near c and near 0. */
static double sharp_wedge(double c, double x)
{
    const double s = sqrt((c - x) / c * ((c + x) / c)), t = x / c;
    return -2 / RW_PI * (t > 0.5 ? asinh(s / t) : log1p(s) - log(t));
}

/* ln|sin(phi+phi0)/sin(phi-phi0)|, sin(phi +- phi0) = A +- B over c, x != a. Where one of A, B is small beside the other the
 * logarithm is small; elsewhere (A+B)(A-B) = (x+a)(x-a) gives the difference from two that are exact. */
static double log_of_ratio(double a, double x, double A, double B)
{
    const double large = fmax(A, B), small = fmin(A, B);
    if (2 * small < large)
        return 2 * atanh(small / large);
    const double sum = A + B;
    return log(sum / fabs(x - a) * (sum / (x + a)));
}

/* Eq. (8), 0 < a < c, 0 <= x < c. With s = cos(phi), c0 = cos(phi0) and sin(phi +- phi0) = c0 x +- a s, over c,
 *     pi p = 2 ln((c0 x + a s)/(c0 + s)) + ((x - a)/a) ln|sin(phi+phi0)/sin(phi-phi0)| - 2 phi0 s c/a:
 * the paper's two logarithms share their singularity at x = a; here it is gone from the first, and the second is multiplied
 * by its zero. */
static double rounded_wedge(double a, double c, double x)
{
    const double c0 = sqrt((c - a) / c * ((c + a) / c)), s = sqrt((c - x) / c * ((c + x) / c));
    const double A = c0 * x, B = a * s;
    const double below_one = (c0 * ((c - x) / c) + s * ((c - a) / c)) / (c0 + s);
    const double first = below_one < 0.5 ? log1p(-below_one) : log((A + B) / c) - log(c0 + s);
    const double alpha = a / c;
    double sum = 2 * (first - atan2(alpha, c0) / alpha * s);
    if (x != a)
        sum += (x - a) / a * log_of_ratio(a, x, A, B);
    return sum / RW_PI;
}

double rw_patch_pressure(double a, double c, double x)
{
    x = fabs(x);
    if (x >= c)
        return 0;
    if (a >= c)
        return -sqrt((c - x) / c * ((c + x) / c)) / (a / c);
    if (a == 0 || a < x * DBL_EPSILON * DBL_EPSILON) /* sharp to the last bit; and x/a might overflow */
        return sharp_wedge(c, x);
    return rounded_wedge(a, c, x);
}

double rwedge_pressure(double alpha, double x)
{
    if (!rw_is_nonnegative(alpha) || !isfinite(x))
        return NAN;
    if (alpha == 0 && x == 0)
        return NAN;
    return rw_patch_pressure(alpha, 1, x);
}

double rwedge_peak_pressure(double alpha)
{
    if (!rw_is_nonnegative(alpha) || alpha == 0)
        return NAN;
    if (alpha >= 1)
        return 1 / alpha;
    const double c0 = rw_cos_asin(alpha); /* tan(phi0/2) = alpha/(1 + c0) */
    return 2 / RW_PI * (asin(alpha) / alpha + log1p(c0) - log(alpha));
}

double rwedge_transition_pressure(double alpha)
{
    if (!rw_is_nonnegative(alpha) || alpha == 0)
        return NAN;
    if (alpha >= 1)
        return 0;
    return 2 / RW_PI * (asin(alpha) / alpha * rw_cos_asin(alpha) - log(alpha));
}
