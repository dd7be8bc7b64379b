/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The contact pressure, and where it is largest. */
#include "formulas/pressure.h"

#include "base/domain.h"
#include "base/logarithm.h"
#include "rwedge.h"

#include <float.h>

/* Eq. (14): -arcosh(1/t), t = x/c, of which 1 - t is given. */
static double sharp_wedge(double t, double from_edge)
{
    const double s = sqrt(from_edge * (1 + t));
    return 2 / RW_PI * rw_log_of_quotient_over(t, 1 + s, -(from_edge + s), 1, 1);
}

/* ln|sin(phi+phi0)/sin(phi-phi0)|, sin(phi +- phi0) = A +- B over c, x != a. The difference A - B
 * would cancel. (A+B)(A-B) = (x+a)(x-a) gives it from factors that do not cancel. If one of A, B is
 * small beside the other, the quotient is near 1, and its distance from 1 is a product. */
static double log_of_ratio(double a, double x, double A, double B)
{
    const double sum = A + B, small = fmin(A, B), past = fabs(x - a), both = x + a;
    return rw_log_of_quotient_over(sum / past * (sum / both), 1, 2 * (sum / past) * (small / both),
                                   1, 1);
}

/* Eq. (8), 0 < a < c, 0 <= x < c. With s = cos(phi), c0 = cos(phi0) and sin(phi +- phi0) = c0 x
 * +- a s, over c,
 *     pi p = 2 ln((c0 x + a s)/(c0 + s))
 *            + ((x - a)/a) ln|sin(phi+phi0)/sin(phi-phi0)| - 2 phi0 s c/a.
 * Both of the paper's logarithms are infinite at x = a. Here the first is not, and the second is
 * multiplied by x - a. */
static double rounded_wedge(double a, double c, double x)
{
    const double c0 = sqrt((c - a) / c * ((c + a) / c)), s = sqrt((c - x) / c * ((c + x) / c)),
                 alpha = a / c;
    const double A = c0 * x, B = a * s;
    const double first = rw_log_of_quotient_over((A + B) / c, c0 + s,
                                                 -(c0 * ((c - x) / c) + s * ((c - a) / c)), 1, 1);
    const double edge = rw_angle(c0, alpha) / alpha * s;
    const double corner = x == a ? 0 : (x - a) / a * log_of_ratio(a, x, A, B);
    return (2 * (first - edge) + corner) / RW_PI;
}

double rw_patch_pressure(double a, double c, double x)
{
    x = fabs(x);
    if (x >= c)
        return 0;
    if (a >= c)
        return -sqrt((c - x) / c * ((c + x) / c)) / (a / c);
    if (a < x * DBL_EPSILON * DBL_EPSILON) /* sharp to the last bit */
        return sharp_wedge(x / c, (c - x) / c);
    return rounded_wedge(a, c, x);
}

double rwedge_pressure(double alpha, double x)
{
    if (!rw_is_magnitude(alpha) || !rw_is_signed(x))
        return NAN;
    if (alpha == 0 && x == 0)
        return NAN;
    return rw_patch_pressure(alpha, 1, x);
}

double rwedge_peak_pressure(double alpha)
{
    if (!rw_is_positive(alpha))
        return NAN;
    if (alpha >= 1)
        return 1 / alpha;
    const double c0 = rw_cos_asin(alpha); /* tan(phi0/2) = alpha/(1 + c0) */
    return 2 / RW_PI * (asin(alpha) / alpha + log1p(c0) - log(alpha));
}

double rwedge_transition_pressure(double alpha)
{
    if (!rw_is_positive(alpha))
        return NAN;
    if (alpha >= 1)
        return 0;
    return 2 / RW_PI * (asin(alpha) / alpha * rw_cos_asin(alpha) - log(alpha));
}
