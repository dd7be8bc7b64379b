/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lives: how far the curve at the life is from the value, over its slope. Critical distances. */
#include <float.h>

#include "rows/rows.hpp"
#include "rwedge.h"

namespace
{

enum { VALUE, MODULUS, STRENGTH, B, DUCTILITY, C };

/* Of a metal; its life may be told. */
std::function<bool(probe *)>
living(double (*life)(double, double, double, double, double, double, double),
       const std::array<const char *, 6> &names, double strength, double modulus)
{
    return [=](probe *call) {
        const double *v = call->value, &n = call->result[0];
        argument(call, names[VALUE], log_between(call, 1e-4, 10));
        argument(call, names[MODULUS], modulus * between(call, 0.5, 2));
        argument(call, names[STRENGTH], strength * between(call, 0.5, 2));
        argument(call, names[B], -between(call, 0.05, 0.2));
        argument(call, names[DUCTILITY], between(call, 0.05, 2));
        argument(call, names[C], -between(call, 0.4, 0.9));
        gives(call, life(v[VALUE], v[MODULUS], v[STRENGTH], v[B], v[DUCTILITY], v[C], 0));
        return isnan(n) || (n > 1e-20 && n < 1e40);
    };
}

/* How far the curve first (2N)^slope + second (2N)^other is from the value, over its slope at N:
 * the relative error of N to first order. */
ball error_of_life(const probe &call, const ball &first, const ball &slope, const ball &second,
                   const ball &other)
{
    const ball u = log(2 * ball(call.result[0]));
    const ball one = first * exp(slope * u), two = second * exp(other * u);
    return abs((one + two - ball(call.value[VALUE])) / (slope * one + other * two));
}

ball judge_smith_watson_topper(const probe &call)
{
    const ball E = call.value[MODULUS], sf = call.value[STRENGTH], b = call.value[B],
               ef = call.value[DUCTILITY], c = call.value[C];
    return error_of_life(call, sqr(sf) / E, 2 * b, sf * ef, b + c);
}

ball judge_fatemi_socie(const probe &call)
{
    const ball G = call.value[MODULUS], tf = call.value[STRENGTH];
    return error_of_life(call, tf / G, call.value[B], call.value[DUCTILITY], call.value[C]);
}

double some_size(probe *call)
{
    return log_between(call, 1e-60, 1e60);
}

} // namespace

#define METALS "constants of metals, no limit"

const row LIFE_ROWS[] = {
    {"smith_watson_topper_life", METALS, "relative", 1e-11, "1e-11", 1,
     living(rwedge_smith_watson_topper_life, {{"swt", "E", "sf", "b", "ef", "c"}}, 1000, 150e3),
     judge_smith_watson_topper},
    {"fatemi_socie_life", METALS, "relative", 1e-11, "1e-11", 1,
     living(rwedge_fatemi_socie_life, {{"fatemi_socie", "G", "tf", "b", "gf", "c"}}, 600, 60e3),
     judge_fatemi_socie},
    {"critical_distance", "1e-60 to 1e60", "relative", 4 * DBL_EPSILON, "4 eps", 1,
     calling(rwedge_critical_distance, {{{"dK_th", some_size}, {"ds0", some_size}}}),
     relative_to([](const double *v) { return sqr(ball(v[0]) / v[1]) / pi(); })},
    {},
};
