/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The load at which a contact with units first yields. */
#include "rwedge.h"

#include "base/root.h"
#include "formulas/size.h"

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

/* A k/theta, which may be no double where the load is one; all that is larger than any peak is
 * the same. */
static rw_scaled wanted_peak(const rw_geometry *geometry, double k)
{
    const rw_scaled compliance =
        rw_scaled_over(rw_scaled_from(geometry->A), rw_scaled_from(geometry->theta));
    const rw_scaled wanted = rw_scaled_times(compliance, rw_scaled_from(k));
    return wanted.exponent > 1000 ? rw_scaled_from(1e300) : wanted;
}

/* The peak grows as alpha falls. For alpha >= 1 it is in proportion to 1/alpha; below, a root in
 * ln(alpha), because the peak grows like a logarithm. */
double rwedge_yield_load(double theta, double a, double A, double f, double nu, double k)
{
    const rw_geometry geometry = {theta, a, A};
    if (!rw_is_geometry(&geometry) || !rw_is_friction(f) || !rw_is_poisson(nu) ||
        !rw_is_nonnegative(k) || k == 0)
        return NAN;
    const rw_scaled wanted = wanted_peak(&geometry, k), rounding = rw_scaled_from(a);
    const yielding y = {f, nu, rw_scaled_value(wanted)};
    if (a == 0)
        return rw_friction(f) == 0 && nu == 0.5 && y.wanted > peak(0, f, nu) ? HUGE_VAL : 0;
    const rw_scaled share = rw_scaled_over(wanted, rw_scaled_from(peak(1, f, nu)));
    if (rw_scaled_value(share) <= 1)
        return rw_normal_load(&geometry, rw_scaled_times(rounding, share));
    const double lowest = log(RW_SMALLEST_TIP) + 1e-9; /* exp() of it is not below */
    if (!(excess(lowest, &y) < 0))
        return HUGE_VAL;
    const double alpha = exp(rw_root(excess, &y, lowest, 0, 1e-17));
    return rw_normal_load(&geometry, rw_scaled_over(rounding, rw_scaled_from(alpha)));
}
