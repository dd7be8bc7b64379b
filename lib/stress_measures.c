/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a stress amounts to, in plane strain. With the mean s = (sxx+syy)/2, d = (syy-sxx)/2 and
 * R = sqrt(d^2+txy^2), the principal stresses are s + R, s - R and szz = 2 nu s. */
#include "rwedge.h"

#include "domain.h"
#include "plane_search.h"
#include "scaled.h"

/* Mohr's circle, each length times 2^-exponent: squares of it stay in range. */
typedef struct {
    double s, d, txy, R;
    int exponent;
} circle;

static bool is_stress(double sxx, double syy, double txy)
{
    return isfinite(sxx) && isfinite(syy) && isfinite(txy);
}

static circle circle_of(double sxx, double syy, double txy)
{
    const double largest = fmax(fmax(fabs(sxx), fabs(syy)), fabs(txy));
    if (largest == 0)
        return (circle){0};
    const int exponent = rw_magnitude(largest);
    const double scale = rw_power_of_two(-exponent);
    const double xx = scale * sxx, yy = scale * syy, xy = scale * txy;
    const double d = (yy - xx) / 2;
    return (circle){(xx + yy) / 2, d, xy, sqrt(d * d + xy * xy), exponent};
}

/* NaN where it is too large for a double. */
static double stress_of(const circle *c, double length)
{
    rw_scaled stress = rw_scaled_from(length);
    stress.exponent += c->exponent;
    return rw_scaled_value(stress);
}

/* (1-2nu) s is how far szz is from the mean of the two others. */
double rwedge_von_mises(double sxx, double syy, double txy, double nu)
{
    if (!is_stress(sxx, syy, txy) || !rw_is_poisson(nu))
        return NAN;
    const circle c = circle_of(sxx, syy, txy);
    const double off = (1 - 2 * nu) * c.s;
    return stress_of(&c, sqrt(3 * c.R * c.R + off * off));
}

double rwedge_out_of_plane_stress(double sxx, double syy, double nu)
{
    return is_stress(sxx, syy, 0) && rw_is_poisson(nu) ? 2 * nu * (sxx / 2 + syy / 2) : NAN;
}

double rwedge_largest_shear(double sxx, double syy, double txy, double nu)
{
    if (!is_stress(sxx, syy, txy) || !rw_is_poisson(nu))
        return NAN;
    const circle c = circle_of(sxx, syy, txy);
    return stress_of(&c, fmax(c.R, (c.R + (1 - 2 * nu) * fabs(c.s)) / 2));
}

int32_t rwedge_principal_stresses(double sxx, double syy, double txy, double *s1, double *s2,
                                  double *angle)
{
    if (!s1 || !s2 || !angle)
        return RWEDGE_ENULL;
    if (!is_stress(sxx, syy, txy))
        return RWEDGE_EDOMAIN;
    const circle c = circle_of(sxx, syy, txy);
    const double most = stress_of(&c, c.s + c.R), least = stress_of(&c, c.s - c.R);
    if (isnan(most) || isnan(least))
        return RWEDGE_ERANGE;
    *s1 = most;
    *s2 = least;
    *angle = c.R > 0 ? rw_plane_angle(c.d, c.txy) : 0;
    return RWEDGE_OK;
}
