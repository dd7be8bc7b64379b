/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The size of a contact with units: its rounding, its half-width and the load that makes it. */
#include "formulas/size.h"

#include "rwedge.h"

#include <float.h>

/* NaN where the result is too large for a double: nothing here may overflow, which a host may
 * have made to trap. */

double rwedge_radius(double theta, double a)
{
    if (!rw_is_angle(theta) || !rw_is_nonnegative(a))
        return NAN;
    return a == 0 ? 0 : rw_scaled_value(rw_scaled_over(rw_scaled_from(a), rw_scaled_from(theta)));
}

double rwedge_rounding(double theta, double R)
{
    if (!rw_is_angle(theta) || !rw_is_nonnegative(R))
        return NAN;
    return R == 0 ? 0 : rw_scaled_value(rw_scaled_times(rw_scaled_from(theta), rw_scaled_from(R)));
}

/* Eq. (11) for the sharp wedge; with a rounding, from the ratio A P/(theta a). */
static rw_scaled half_width(const rw_geometry *geometry, double P)
{
    const rw_scaled product = rw_scaled_times(rw_scaled_from(geometry->A), rw_scaled_from(P));
    const rw_scaled length = rw_scaled_over(product, rw_scaled_from(geometry->theta));
    const rw_scaled sharp = {length.mantissa, length.exponent - 1};
    if (geometry->a == 0)
        return sharp;
    const rw_scaled a = rw_scaled_from(geometry->a), scaled_ratio = rw_scaled_over(length, a);
    if (scaled_ratio.exponent > 2 * DBL_MANT_DIG) /* sharp to the last bit */
        return sharp;
    const double ratio = rw_scaled_value(scaled_ratio);
    if (ratio <= RW_HALF_PI)
        return rw_scaled_times(rw_scaled_root(rw_scaled_over(length, rw_scaled_from(RW_HALF_PI))),
                               rw_scaled_root(a));
    return rw_scaled_over(a, rw_scaled_from(rwedge_a_over_b(ratio)));
}

double rw_half_width(const rw_geometry *geometry, double P)
{
    return P > 0 ? rw_scaled_value(half_width(geometry, P)) : 0;
}

double rwedge_half_width(double theta, double a, double A, double P)
{
    const rw_geometry geometry = {theta, a, A};
    if (!rw_is_geometry(&geometry) || !rw_is_nonnegative(P))
        return NAN;
    return rw_half_width(&geometry, P);
}

/* A P/(theta b). For Hertz a/b may be too large for a double, and for a sharp wedge, all but,
 * too small. */
static rw_scaled load_per_width(double a, rw_scaled b)
{
    if (a == 0)
        return rw_scaled_from(rwedge_load(0));
    const rw_scaled alpha = rw_scaled_over(rw_scaled_from(a), b);
    if (alpha.exponent < 1)
        return rw_scaled_from(rwedge_load(rw_scaled_value(alpha)));
    return rw_scaled_over(rw_scaled_times(rw_scaled_from(RW_HALF_PI), b), rw_scaled_from(a));
}

double rw_normal_load(const rw_geometry *geometry, rw_scaled b)
{
    const rw_scaled sharp = rw_scaled_times(rw_unit_stress(geometry), b);
    return rw_scaled_value(rw_scaled_times(sharp, load_per_width(geometry->a, b)));
}

double rwedge_normal_load(double theta, double a, double A, double b)
{
    const rw_geometry geometry = {theta, a, A};
    if (!rw_is_geometry(&geometry) || !rw_is_nonnegative(b))
        return NAN;
    return b == 0 ? 0 : rw_normal_load(&geometry, rw_scaled_from(b));
}
