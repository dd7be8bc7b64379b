/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lives from criteria, by the curves of Basquin, Coffin and Manson. Over the logarithm of the
 * number of reversals the logarithm of such a curve falls, steeper than the flatter power and less
 * steep than the other. */
#include "life/life.h"

#include "base/domain.h"
#include "base/root.h"
#include "rwedge.h"

/* log(value) = log(sum of exp(height + slope u)), less the value that is wanted; u = log(2 N). */
static double excess(double u, const void *context)
{
    const rw_life_curve *c = context;
    const double one = c->height[0] + c->slope[0] * u, other = c->height[1] + c->slope[1] * u;
    return fmax(one, other) + log1p(exp(-fabs(one - other)));
}

/* At its life one power has between half of the value and all of it. */
static double root_of(const rw_life_curve *c)
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

double rw_life(const rw_life_curve *curve, double value)
{
    if (value == 0 || value < curve->limit)
        return HUGE_VAL;
    const double wanted = log(value);
    rw_life_curve less = *curve;
    for (int i = 0; i < 2; i++)
        less.height[i] -= wanted;
    return root_of(&less);
}

static bool is_slope(double v)
{
    return isfinite(v) && v >= -2 && v <= -0.01;
}

/* A strength with its exponent b, a ductility with its exponent c. */
static bool is_curve(double strength, double b, double ductility, double c, double limit)
{
    return rw_is_positive(strength) && is_slope(b) && rw_is_positive(ductility) && is_slope(c) &&
           rw_is_magnitude(limit);
}

bool rw_smith_watson_topper_curve(double E, double sf, double b, double ef, double c, double limit,
                                  rw_life_curve *curve)
{
    if (!rw_is_positive(E) || !is_curve(sf, b, ef, c, limit))
        return false;
    *curve = (rw_life_curve){{log(sf * sf / E), log(sf * ef)}, {2 * b, b + c}, limit};
    return true;
}

bool rw_fatemi_socie_curve(double G, double tf, double b, double gf, double c, double limit,
                           rw_life_curve *curve)
{
    if (!rw_is_positive(G) || !is_curve(tf, b, gf, c, limit))
        return false;
    *curve = (rw_life_curve){{log(tf / G), log(gf)}, {b, c}, limit};
    return true;
}

double rwedge_smith_watson_topper_life(double swt, double E, double sf, double b, double ef,
                                       double c, double limit)
{
    rw_life_curve curve;
    if (!rw_is_magnitude(swt) || !rw_smith_watson_topper_curve(E, sf, b, ef, c, limit, &curve))
        return NAN;
    return rw_life(&curve, swt);
}

double rwedge_fatemi_socie_life(double fatemi_socie, double G, double tf, double b, double gf,
                                double c, double limit)
{
    rw_life_curve curve;
    if (!rw_is_magnitude(fatemi_socie) || !rw_fatemi_socie_curve(G, tf, b, gf, c, limit, &curve))
        return NAN;
    return rw_life(&curve, fatemi_socie);
}
