/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measures of one stress, in plane strain. With the mean s = (sxx+syy)/2, d = (syy-sxx)/2 and
 * R = sqrt(d^2+txy^2), the principal stresses are s + R, s - R and szz = 2 nu s. */
#include "base/domain.h"
#include "planes/plane_search.h"
#include "rwedge.h"

/* Mohr's circle. */
typedef struct {
    double s, d, R;
} circle;

static bool is_stress(double sxx, double syy, double txy)
{
    return rw_is_stress(sxx) && rw_is_stress(syy) && rw_is_stress(txy);
}

static circle circle_of(double sxx, double syy, double txy)
{
    const double d = (syy - sxx) / 2;
    return (circle){(sxx + syy) / 2, d, sqrt(d * d + txy * txy)};
}

/* (1-2nu) s is how far the mean of the two others is from szz. */
double rwedge_von_mises(double sxx, double syy, double txy, double nu)
{
    if (!is_stress(sxx, syy, txy) || !rw_is_poisson(nu))
        return NAN;
    const circle c = circle_of(sxx, syy, txy);
    const double off = (1 - 2 * nu) * c.s;
    return sqrt(3 * (c.R * c.R) + off * off);
}

double rwedge_out_of_plane_stress(double sxx, double syy, double nu)
{
    return is_stress(sxx, syy, 0) && rw_is_poisson(nu) ? nu * (sxx + syy) : NAN;
}

double rwedge_largest_shear(double sxx, double syy, double txy, double nu)
{
    if (!is_stress(sxx, syy, txy) || !rw_is_poisson(nu))
        return NAN;
    const circle c = circle_of(sxx, syy, txy);
    return fmax(c.R, (c.R + (1 - 2 * nu) * fabs(c.s)) / 2);
}

int32_t rwedge_principal_stresses(double sxx, double syy, double txy, double *s1, double *s2,
                                  double *angle)
{
    if (!s1 || !s2 || !angle)
        return RWEDGE_ENULL;
    if (!is_stress(sxx, syy, txy))
        return RWEDGE_EDOMAIN;
    const circle c = circle_of(sxx, syy, txy);
    *s1 = c.s + c.R;
    *s2 = c.s - c.R;
    *angle = c.R > 0 ? rw_plane_angle(c.d, txy) : 0;
    return RWEDGE_OK;
}
