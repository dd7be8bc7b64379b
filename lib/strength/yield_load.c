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
    double f, nu, wanted; /* wanted: the peak at yield, A k/theta */
} yielding;

static double excess(double log_alpha, const void *context)
{
    const yielding *y = context;
    return y->wanted - peak(exp(log_alpha), y->f, y->nu);
}

/* The sharp wedge. Its stresses are infinite at the apex under any load, so the yield load is 0.
 * For f = 0 with nu = 0.5 the peak of sqrt(J2) is finite, and the same under every load. Yield is
 * then reached at once, or never. */
static double sharp_yield_load(const yielding *y)
{
    return y->f == 0 && y->nu == 0.5 && y->wanted > peak(0, 0, 0.5) ? HUGE_VAL : 0;
}

/* The half-width at yield; HUGE_VAL if there is none. The peak grows as alpha falls. For alpha >= 1
 * it is proportional to 1/alpha. Below 1 it grows like a logarithm, so the unknown is ln(alpha). */
static double half_width_at_yield(double a, const yielding *y)
{
    const double share = y->wanted / peak(1, y->f, y->nu);
    if (share <= 1)
        return a * share;
    const double lowest = log(RW_SMALLEST_TIP) + 1e-9; /* exp() of it is not below */
    if (!(excess(lowest, y) < 0))
        return HUGE_VAL;
    return a / exp(rw_root(excess, y, lowest, 0, 1e-17));
}

double rwedge_yield_load(double theta, double a, double A, double f, double nu, double k)
{
    const rw_geometry geometry = {.theta = theta, .a = a, .A = A};
    if (!rw_is_geometry(&geometry) || !rw_is_friction(f) || !rw_is_poisson(nu) ||
        !rw_is_positive(k))
        return NAN;
    const yielding y = {f, nu, A / theta * k};
    if (a == 0)
        return sharp_yield_load(&y);
    const double b = half_width_at_yield(a, &y);
    return b == HUGE_VAL ? b : rwedge_normal_load(theta, a, A, b);
}
