/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lives: how far the curve at the life is from the value, over its slope. Critical distances, and
 * the threshold of short cracks. */
#include <float.h>
#include <math.h>

#include <array>

#include "rows/rows.hpp"
#include "rwedge.h"

namespace
{

enum { VALUE, MODULUS, STRENGTH, B, DUCTILITY, C };

/* Of a metal. */
std::vector<drawn> metal(const std::array<const char *, 6> &names, double modulus, double strength)
{
    static const double LOW[] = {1e-4, 0.5, 0.5, 0.05, 0.05, 0.4}, HIGH[] = {10, 2, 2, 0.2, 2, 0.9};
    const double unit[] = {1, modulus, strength, -1, 1, -1};
    std::vector<drawn> all;
    for (size_t i = 0; i < names.size(); i++)
        all.push_back({names[i], [scale = unit[i], i](probe *call) {
                           return scale *
                                  (i == VALUE ? log_between : between)(call, LOW[i], HIGH[i]);
                       }});
    return all;
}

bool may_be_told(const probe &call)
{
    const double n = call.result[0];
    return isnan(n) || (n > 1e-20 && n < 1e40);
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

/* Without a limit. */
double swt_life(double swt, double E, double sf, double b, double ef, double c)
{
    const double constants[] = {E, sf, b, ef, c, 0};
    return rwedge_life(RWEDGE_MEASURE_SWT, constants, swt);
}

double fatemi_socie_life(double fatemi_socie, double G, double tf, double b0, double gf, double c0)
{
    const double constants[] = {1, 1, 1, G, tf, b0, gf, c0, 0};
    return rwedge_life(RWEDGE_MEASURE_FATEMI_SOCIE, constants, fatemi_socie);
}

double some_size(probe *call)
{
    return log_between(call, 1e-60, 1e60);
}

} // namespace

#define METALS "constants of metals, no limit"

const row LIFE_ROWS[] = {
    {"life, swt", METALS, "relative", 1e-11, "1e-11", 1,
     calling(swt_life, metal({"swt", "E", "sf", "b", "ef", "c"}, 150e3, 1000), may_be_told),
     judge_smith_watson_topper},
    {"life, fatemi_socie", METALS, "relative", 1e-11, "1e-11", 1,
     calling(fatemi_socie_life, metal({"fatemi_socie", "G", "tf", "b0", "gf", "c0"}, 60e3, 600),
             may_be_told),
     judge_fatemi_socie},
    {"critical_distance", "1e-60 to 1e60", "relative", 4 * DBL_EPSILON, "4 eps", 1,
     calling(rwedge_critical_distance, {{"dK_th", some_size}, {"ds0", some_size}}),
     relative_to([](const double *v) { return sqr(ball(v[0]) / v[1]) / pi(); })},
    {"short_crack_threshold", "1e-60 to 1e60", "relative", 4 * DBL_EPSILON, "4 eps", 1,
     calling(rwedge_short_crack_threshold,
             {{"length", some_size}, {"dK_th", some_size}, {"ds0", some_size}}),
     relative_to([](const double *v) {
         /* K/(sigma sqrt(pi l)) of an edge crack, 1.12152225523105526228077, by the closed form */
         const ball edge = ball(1.1215222552310553) - ball(4.71848858483295e-17);
         const ball root = ball(v[1]) / (edge * v[2]);
         return v[1] / sqrt(1 + sqr(root) / (pi() * v[0]));
     })},
    {},
};
