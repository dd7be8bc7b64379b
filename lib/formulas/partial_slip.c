/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Partial slip under a tangential force that grows: the stick zone and the shear traction. The
 * corrective traction of the stick zone is f times the pressure of the same profile pressed to
 * the half-width c, Eq. (22) to (27), so that
 *     1 - Q/(fP) = F(c)/F(1),
 *     F(t) = t A P(t)/(theta t) = (t^2 asin(alpha/t) + alpha sqrt(t^2 - alpha^2))/alpha,
 * F(t) = (pi/2) t^2/alpha for t <= alpha. */
#include "rwedge.h"

#include "base/domain.h"
#include "formulas/contact_law.h"
#include "formulas/pressure.h"

/* alpha (F(1) - F(c)), alpha <= c <= 1. With d = sqrt(1-alpha^2) - sqrt(c^2-alpha^2), the two
 * arcsines differ by asin(q), q = alpha d/c. alpha d itself cancels, except for its part (1-c). So
 * every term that is left is small when 1-c is small. */
static double load_lost_on_flank(double alpha, double c)
{
    const double lost = (1 - c) * (1 + c);
    const double d = lost / (rw_cos_asin(alpha) + sqrt((c - alpha) * (c + alpha)));
    return lost * asin(alpha) + alpha * d * (1 - c) - c * c * rw_asin_excess(alpha * d / c);
}

double rwedge_shear_ratio(double alpha, double c)
{
    if (!rw_is_magnitude(alpha) || !rw_is_stick(c))
        return NAN;
    if (alpha >= 1)
        return (1 - c) * (1 + c);
    if (alpha == 0)
        return 1 - c;
    const double whole = rwedge_load(alpha);
    if (c >= alpha)
        return fmin(1, load_lost_on_flank(alpha, c) / alpha / whole);
    return fmin(
        1, (load_lost_on_flank(alpha, alpha) / alpha + RW_HALF_PI * (alpha - c) * (1 + c / alpha)) /
               whole);
}

/* The stick zone is the contact area under the load fraction 1 - Q/(fP). */
double rwedge_stick_width(double alpha, double Q_over_fP)
{
    if (!rw_is_magnitude(alpha) || !rw_is_fraction(Q_over_fP))
        return NAN;
    const double fraction = 1 - Q_over_fP;
    if (alpha >= 1)
        return sqrt(fraction);
    if (fraction == 0 || fraction == 1 || alpha == 0)
        return fraction;
    const double whole = rwedge_load(alpha);
    return fmin(1, alpha / rwedge_a_over_b(fraction * whole / alpha));
}

/* alpha = 0: the difference of two arcosh, Eq. (14), finite at x = 0 too. */
static double sharp_wedge_shear(double c, double x)
{
    const double s = sqrt((c - x) / c * ((c + x) / c));
    return 2 / RW_PI * (log(c) + log1p(s) - log1p(rw_cos_asin(x)));
}

double rwedge_shear(double alpha, double c, double x)
{
    if (!rw_is_magnitude(alpha) || !rw_is_stick(c) || !rw_is_signed(x) ||
        (alpha == 0 && c == 0 && x == 0))
        return NAN;
    x = fabs(x);
    if (x >= c)
        return rwedge_pressure(alpha, x);
    if (alpha == 0)
        return sharp_wedge_shear(c, x);
    return rwedge_pressure(alpha, x) - rw_patch_pressure(alpha, c, x);
}
