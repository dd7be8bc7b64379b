/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "strength/limit_load.h"

#include "base/domain.h"
#include "base/root.h"
#include "formulas/size.h"
#include "rwedge.h"

typedef struct {
    const rw_limit *limit;
    double f, nu, wanted; /* wanted: the peak, A k/theta */
} search;

static double peak_at(const search *s, double alpha)
{
    return s->limit->peak(alpha, s->f, s->nu);
}

static double excess(double log_alpha, const void *context)
{
    const search *s = context;
    return s->wanted - peak_at(s, exp(log_alpha));
}

/* The sharp wedge. Its stresses are infinite at the apex under any load, so the load is 0. For
 * f = 0 with nu = 0.5 the peak is finite, and the same under every load. It is then reached at
 * once, or never. */
static double sharp_load(const search *s)
{
    return s->f == 0 && s->nu == 0.5 && s->wanted > peak_at(s, 0) ? HUGE_VAL : 0;
}

/* Below alpha = 1 the peak grows like a logarithm, so the unknown is ln(alpha). */
static double half_width(const search *s, double a)
{
    const double share = s->wanted / peak_at(s, 1);
    if (share <= 1)
        return a * share;
    const double lowest = log(s->limit->smallest_tip) + 1e-9; /* exp() of it is not below */
    if (!(excess(lowest, s) < 0))
        return HUGE_VAL;
    return a / exp(rw_root(excess, s, lowest, 0, s->limit->nearest));
}

double rw_limit_load(const rw_limit *limit, double theta, double a, double A, double f, double nu,
                     double k)
{
    const rw_geometry geometry = {.theta = theta, .a = a, .A = A};
    if (!rw_is_geometry(&geometry) || !rw_is_friction(f) || !rw_is_poisson(nu) ||
        !rw_is_positive(k))
        return NAN;
    const search s = {limit, f, nu, A / theta * k};
    if (a == 0)
        return sharp_load(&s);
    const double b = half_width(&s, a);
    return b == HUGE_VAL ? b : rwedge_normal_load(theta, a, A, b);
}
