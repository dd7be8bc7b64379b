/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measures of a stress. */
#include <float.h>
#include <math.h>

#include "rows/rows.hpp"
#include "rwedge.h"

namespace
{

static const double EPSILON = DBL_EPSILON;

/* ---- One stress ---- */

/* From 1e-60 to 1e60, next to each other, equal, or 0. */
double some_stress(probe *call, double other)
{
    const double kind = uniform(call);
    return kind < 0.1   ? 0
           : kind < 0.3 ? either_sign(call, near(call, fmax(fabs(other), 1e-59)))
           : kind < 0.4 ? either_sign(call, other)
           : kind < 0.6 ? either_sign(call, fmax(fabs(other), 1e-59) * log_between(call, 1e-9, 1))
                        : either_sign(call, log_between(call, 1e-60, 0.5e60));
}

/* s, d, t and R of the stress. */
struct circle {
    ball s, d, t, R;
};

circle circle_of(const double s[3])
{
    const ball xx = s[0], yy = s[1], t = s[2], d = (yy - xx) / 2;
    return {(xx + yy) / 2, d, t, sqrt(sqr(d) + sqr(t))};
}

/* |(1-2nu) s| */
ball off_plane(const circle &c, double nu)
{
    return abs((1 - 2 * ball(nu)) * c.s);
}

ball von_mises(const double *v)
{
    const circle c = circle_of(v);
    return sqrt(sqr(off_plane(c, v[3])) + 3 * sqr(c.R));
}

/* The largest of |s1-s2|/2 and |s1-szz|/2, |s2-szz|/2, the larger of which is (R + |s-szz|)/2. */
ball largest_shear(const double *v)
{
    const circle c = circle_of(v);
    return max(c.R, (off_plane(c, v[3]) + c.R) / 2);
}

const drawn sxx = {"sxx", [](probe *call) { return some_stress(call, 1); }},
            syy = {"syy", [](probe *call) { return some_stress(call, call->value[0]); }},
            txy = {"txy",
                   [](probe *call) { return some_stress(call, call->value[chance(call, 0.5)]); }},
            ratio = {"nu", some_poisson};

const auto draw_principal = calling(rwedge_principal_stresses, {sxx, syy, txy});

/* Of the larger of |s1|, |s2|. */
ball judge_principal(const probe &call)
{
    const circle c = circle_of(call.value);
    const ball scale = abs(c.s) + c.R;
    return max(error_over(call.result[0], c.s + c.R, scale),
               error_over(call.result[1], c.s - c.R, scale));
}

/* Half of the angle of (d, t), which is determined where R is not 0. */
ball judge_angle(const probe &call)
{
    const circle c = circle_of(call.value);
    const ball t = is_zero(c.t) ? 0 : c.t; /* a d below 0 is at pi, not -pi */
    const ball angle = is_zero(c.R) ? 0 : atan2(t, c.d) / 2;
    const ball error = error_over(call.result[2], angle, 1);
    return min(error, abs(pi() - error)); /* angles that differ by pi are of one plane */
}

#define STRESS "1e-60 to 1e60, 0, dense where equal"

} // namespace

const row MEASURE_ROWS[] = {
    {"von_mises", STRESS "; nu", "relative", 4 * EPSILON, "4 eps", 1,
     calling(rwedge_von_mises, {sxx, syy, txy, ratio}), relative_to(von_mises)},
    {"out_of_plane_stress", "the same", "relative", 4 * EPSILON, "4 eps", 1,
     calling(rwedge_out_of_plane_stress, {sxx, syy, ratio}),
     relative_to([](const double *v) { return v[2] * (ball(v[0]) + v[1]); })},
    {"largest_shear", "the same", "relative", 4 * EPSILON, "4 eps", 1,
     calling(rwedge_largest_shear, {sxx, syy, txy, ratio}), relative_to(largest_shear)},
    {"principal_stresses", "the same", "of the larger of \\|s1\\|, \\|s2\\|", 4 * EPSILON, "4 eps",
     1, draw_principal, judge_principal},
    {"principal_stresses, angle", "the same", "absolute", 4 * EPSILON, "4 eps", 1, draw_principal,
     judge_angle},
    {},
};
