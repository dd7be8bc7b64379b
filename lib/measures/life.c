/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lives from criteria, by the curves of Basquin, Coffin and Manson. A curve is a sum of two powers
 * of the number of reversals; over the logarithm of that number its logarithm falls, steeper than
 * the flatter power and less steep than the other. */
#include "base/domain.h"
#include "base/root.h"
#include "rwedge.h"

/* log(value) = log(sum of exp(height + slope u)), less the value that is wanted; u = log(2 N). */
typedef struct {
    double height[2], slope[2];
} curve;

static double excess(double u, const void *context)
{
    const curve *c = context;
    const double one = c->height[0] + c->slope[0] * u, other = c->height[1] + c->slope[1] * u;
    return fmax(one, other) + log1p(exp(-fabs(one - other)));
}

/* At its life one power has between half of the value and all of it. */
static double life(const curve *c)
{
    double least = -HUGE_VAL, most = -HUGE_VAL;
    for (int i = 0; i < 2; i++) {
        least = fmax(least, -c->height[i] / c->slope[i]);
        most = fmax(most, -(c->height[i] + log(2.0)) / c->slope[i]);
    }
    const double cycles = least > log(4 * RW_LARGEST)
                              ? HUGE_VAL
                              : exp(rw_root(excess, c, least - 1e-9, most + 1e-9, 1e-15)) / 2;
    return cycles > RW_LARGEST ? HUGE_VAL : cycles >= RW_SMALLEST ? cycles : NAN;
}

static bool is_slope(double v)
{
    return isfinite(v) && v >= -2 && v <= -0.01;
}

/* The life of a value on the curve first n^slope + second n^other; infinite below the limit. */
static double life_of(double value, double limit, double first, double slope, double second,
                      double other)
{
    if (value == 0 || value < limit)
        return HUGE_VAL;
    const double wanted = log(value);
    return life(&(curve){{log(first) - wanted, log(second) - wanted}, {slope, other}});
}

double rwedge_smith_watson_topper_life(double swt, double E, double sf, double b, double ef,
                                       double c, double limit)
{
    if (!rw_is_magnitude(swt) || !rw_is_positive(E) || !rw_is_positive(sf) || !is_slope(b) ||
        !rw_is_positive(ef) || !is_slope(c) || !rw_is_magnitude(limit))
        return NAN;
    return life_of(swt, limit, sf * sf / E, 2 * b, sf * ef, b + c);
}

double rwedge_fatemi_socie_life(double fatemi_socie, double G, double tf, double b, double gf,
                                double c, double limit)
{
    if (!rw_is_magnitude(fatemi_socie) || !rw_is_positive(G) || !rw_is_positive(tf) ||
        !is_slope(b) || !rw_is_positive(gf) || !is_slope(c) || !rw_is_magnitude(limit))
        return NAN;
    return life_of(fatemi_socie, limit, tf / G, b, gf, c);
}
