/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dimensional quantities of one contact. */
#include <float.h>
#include <math.h>

#include "rows/rows.hpp"
#include "rwedge.h"
#include "references/strength.hpp"

namespace
{

double some_unit(probe *call)
{
    return chance(call, 0.05) ? log_between(call, 1e-15, 1e15) : log_between(call, 1e-9, 1e6);
}

double some_angle(probe *call)
{
    return log_between(call, 1e-9, 1.5707);
}

/* theta, a, A; A P/(theta a), or A P/theta for the sharp wedge. */
double some_geometry(probe *call)
{
    argument(call, "theta", some_angle(call));
    argument(call, "a", chance(call, 0.05) ? 0 : some_unit(call));
    argument(call, "A", some_unit(call));
    return chance(call, 0.3) ? near(call, 1.5707963267948966) : log_between(call, 1e-10, 1e20);
}

void some_pressed(probe *call)
{
    const double ratio = some_geometry(call), *v = call->value;
    argument(call, "P", ratio * v[0] / v[2] * (v[1] > 0 ? v[1] : some_unit(call)));
}

bool is_normal_load(const probe &call)
{
    return isnormal(call.value[3]);
}

ball judge_half_width(const probe &call)
{
    const double *v = call.value;
    const ball wanted = ball(v[2]) * v[3] / v[0];
    return relative_error(call.result[0], half_width(v[1], wanted, call.result[0]));
}

void some_wide(probe *call)
{
    const double ratio = some_geometry(call), a = call->value[1];
    argument(call, "b", a > 0 ? a * sqrt(ratio) : ratio);
}

/* (theta/A) times the force of the half-width b. */
ball normal_load(const double *v)
{
    return patch(v[1], v[3]).load() * v[0] / v[2];
}

/* ---- The load at first yield ---- */

/* max sqrt(J2) over A k/theta, less 1; result[2], result[3] is where it yields. For Hertz the peak
 * is that of alpha = 1 over alpha. */
ball excess_of_peak(const probe &call, const ball &alpha)
{
    const double *v = call.value, *r = call.result;
    const ball tip = min(alpha, 1), J2 = extremum_near({tip, v[3], v[4]}, r[2], r[3]).J2;
    return sqrt(J2) * tip / alpha / (ball(v[5]) / v[0] * v[2]) - 1;
}

/* Whether it yields while the contact is less than 1e14 a wide, by more than rounding. */
bool yields_at_all(const probe &call)
{
    static const double WIDEST = 1e-14;
    const precision here(512);
    probe at = call;
    const double *v = call.value;
    double limit;
    return rwedge_yield_point(WIDEST, v[3], v[4], &limit, &at.result[2], &at.result[3]) !=
               RWEDGE_OK ||
           excess_of_peak(at, WIDEST) > 1e-13;
}

/* |d ln(P)/d ln(k)|, about. */
double condition_of(const double v[6])
{
    static const double STEP = 1e-7;
    const double P = rwedge_yield_load(v[0], v[1], v[2], v[3], v[4], v[5]),
                 less = rwedge_yield_load(v[0], v[1], v[2], v[3], v[4], v[5] * (1 - STEP));
    return log(P / less) / STEP;
}

/* The peak of sqrt(J2), in theta/A, from what a tip alpha has, so that all tips come up.
 * result[1] is alpha of the library's load, result[2], result[3] where it yields. */
bool draw_yield_load(probe *call)
{
    double *r = call->result;
    const double *v = call->value;
    some_geometry(call);
    const double f = argument(call, "f", chance(call, 0.1) ? some_friction(call) : uniform(call));
    const double nu = argument(call, "nu", some_poisson(call));
    const double tip = log_between(call, 1e-13, 100),
                 peak = rwedge_load(tip) / rwedge_elastic_limit(tip, f, nu);
    const double k = argument(call, "k", v[0] / v[2] * peak);
    if (v[1] == 0)
        return false;
    r[0] = rwedge_yield_load(v[0], v[1], v[2], f, nu, k);
    if (isinf(r[0]) && !yields_at_all(*call))
        return false;
    r[1] = v[1] / rwedge_half_width(v[0], v[1], v[2], r[0]);
    double limit;
    return gives(call,
                 isinf(r[0]) || rwedge_yield_point(fmin(1, r[1]), f, nu, &limit, &r[2], &r[3]));
}

/* How far the peak under the load is from k, times the condition: the relative error of the load to
 * first order. */
ball judge_yield_load(const probe &call)
{
    const double *v = call.value, condition = condition_of(v);
    const ball a = v[1], wanted = ball(v[2]) * call.result[0] / v[0];
    const ball alpha = a / half_width(a, wanted, v[1] / call.result[1]);
    return abs(excess_of_peak(call, alpha)) * condition / fmax(1, 1e-4 * condition);
}

#define UNITS "lengths, A 1e-15 to 1e15, all AP/(theta a)"

} // namespace

const row DESIGN_ROWS[] = {
    {"radius", "theta 1e-9 to pi/2; a 1e-15 to 1e15", "relative", DBL_EPSILON, "(1 eps)", 1,
     calling(rwedge_radius, {{"theta", some_angle}, {"a", some_unit}}),
     relative_to([](const double *v) { return ball(v[1]) / v[0]; })},
    {"rounding", "the same", "relative", DBL_EPSILON, "(1 eps)", 1,
     calling(rwedge_rounding, {{"theta", some_angle}, {"R", some_unit}}),
     relative_to([](const double *v) { return ball(v[1]) * v[0]; })},
    {"half_width", UNITS, "relative", 1e-14, "1e-14", 1,
     calling(rwedge_half_width, {some_pressed}, is_normal_load), judge_half_width},
    {"normal_load", UNITS, "relative", 1e-14, "1e-14", 1, calling(rwedge_normal_load, {some_wide}),
     relative_to(normal_load)},
    {"yield_load", "of tips 1e-13 to 100; f, nu as above", "relative, over max(1, 1e-4 dlnP/dlnk)",
     1e-11, "1e-11", 0.2, draw_yield_load, judge_yield_load},
    {},
};
