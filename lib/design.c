/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dimensional quantities of one contact: its size and load, and the load at which it yields. */
#include "rwedge.h"

#include "geometry.h"
#include "solve.h"

#include <float.h>

double rwedge_radius(double theta, double a)
{
    return rw_is_angle(theta) && rw_is_nonnegative(a) ? a / theta : NAN;
}

double rwedge_rounding(double theta, double R)
{
    return rw_is_angle(theta) && rw_is_nonnegative(R) ? theta * R : NAN;
}

/* Eq. (15) for the sharp wedge; Hertz has a form of its own because A P/(theta a) might underflow. */
double rw_half_width(const rw_geometry *geometry, double P)
{
    const double length = geometry->A * P / geometry->theta, a = geometry->a;
    if (length <= RW_HALF_PI * a)
        return sqrt(length / RW_HALF_PI) * sqrt(a);
    const double ratio = length / a;
    if (!(ratio < 1 / DBL_EPSILON / DBL_EPSILON)) /* sharp to the last bit */
        return length / 2;
    return a / rwedge_a_over_b(ratio);
}

double rwedge_half_width(double theta, double a, double A, double P)
{
    const rw_geometry geometry = {theta, a, A};
    if (!rw_is_geometry(&geometry) || !rw_is_nonnegative(P))
        return NAN;
    return rw_half_width(&geometry, P);
}

double rwedge_normal_load(double theta, double a, double A, double b)
{
    const rw_geometry geometry = {theta, a, A};
    if (!rw_is_geometry(&geometry) || !rw_is_nonnegative(b))
        return NAN;
    if (b == 0)
        return 0;
    const double per_width = b > a ? rwedge_load(a / b) : RW_HALF_PI * b / a;
    return theta / A * b * per_width;
}

/* The peak of sqrt(J2) in theta/A, from the elastic limit P/(bk): P = (theta/A) b load(alpha). */
static double peak(double alpha, double f, double nu)
{
    return rwedge_load(alpha) / rwedge_elastic_limit(alpha, f, nu);
}

typedef struct {
    double f, nu, wanted;
} yielding;

static double excess(double log_alpha, const void *context)
{
    const yielding *y = context;
    return y->wanted - peak(exp(log_alpha), y->f, y->nu);
}

/* The peak grows as alpha falls. For alpha >= 1 it is in proportion to 1/alpha; below, a root in ln(alpha), because the
 * peak grows like a logarithm. */
double rwedge_yield_load(double theta, double a, double A, double f, double nu, double k)
{
    const rw_geometry geometry = {theta, a, A};
    if (!rw_is_geometry(&geometry) || !rw_is_nonnegative(f) || !rw_is_poisson(nu) || !rw_is_nonnegative(k) || k == 0)
        return NAN;
    const yielding y = {f, nu, A / theta * k};
    if (a == 0)
        return f == 0 && nu == 0.5 && y.wanted > peak(0, f, nu) ? HUGE_VAL : 0;
    const double hertz = peak(1, f, nu);
    if (y.wanted <= hertz)
        return rwedge_normal_load(theta, a, A, a * (y.wanted / hertz));
    const double lowest = log(RW_SMALLEST_TIP) + 1e-9; /* exp() of it is not below */
    if (!(excess(lowest, &y) < 0))
        return HUGE_VAL;
    return rwedge_normal_load(theta, a, A, a / exp(rw_root(excess, &y, lowest, 0, 1e-17)));
}
