/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Partial slip, and the maximum tension. */
#include <math.h>

#include "rows/rows.hpp"
#include "rwedge.h"

namespace
{

/* ---- Stick zone ---- */

bool draw_stick_width(probe *call)
{
    const double alpha = argument(call, "alpha", some_alpha(call));
    return gives(call,
                 rwedge_stick_width(alpha, argument(call, "Q_over_fP", some_fraction(call, 0.5))));
}

/* The half-width under the load F(1)(1-Q/(fP)), Eq. (25). */
ball judge_stick_width(const probe &call)
{
    const ball sticking = 1 - ball(call.value[1]), a = call.value[0];
    const ball c = is_zero(sticking) ? 0 : half_width(a, force(a, 1) * sticking, call.result[0]);
    return relative_error(call.result[0], c);
}

bool draw_shear_ratio(probe *call)
{
    const double alpha = argument(call, "alpha", some_alpha(call));
    return gives(
        call, rwedge_shear_ratio(alpha, argument(call, "c", some_fraction(call, fmin(alpha, 1)))));
}

/* 1 - F(c)/F(1). */
ball judge_shear_ratio(const probe &call)
{
    const double a = call.value[0], c = call.value[1];
    const ball ratio = c == 1 ? 0 : c == 0 ? 1 : 1 - force(a, c) / force(a, 1);
    return relative_error(call.result[0], ratio);
}

bool draw_shear(probe *call)
{
    const double alpha = argument(call, "alpha", some_alpha(call));
    const double c = argument(call, "c", some_fraction(call, fmin(alpha, 1)));
    const double x = argument(call, "x", some_place(call, alpha, c));
    call->result[0] = rwedge_shear(alpha, c, x);
    return alpha > 0 || x != 0;
}

/* p(x; 1) - p(x; c) over 1 + |p|, Eq. (23), (26), (27). */
ball judge_shear(const probe &call)
{
    const double a = call.value[0], c = call.value[1], x = call.value[2];
    const ball p = pressure(a, 1, x);
    return error_over(call.result[0], p - (c > 0 ? pressure(a, c, x) : 0), 1 - p);
}

/* ---- Maximum tension ---- */

bool draw_max_tension(probe *call)
{
    return gives(call, rwedge_max_tension(argument(call, "alpha", some_alpha(call))));
}

/* sxx = 2 f at the trailing edge over f load: 2 alpha/(phi0 + alpha c0); for alpha >= 1 as for
 * 1. */
ball judge_max_tension(const probe &call)
{
    return relative_error(call.result[0], 2 / force(fmin(call.value[0], 1), 1));
}

} // namespace

const row STICK_ROWS[] = {
    {"stick_width", "alpha; Q/(fP) dense at 0, 1", "relative", 1e-14, "1e-14", 1, draw_stick_width,
     judge_stick_width},
    {"shear_ratio", "alpha; c dense at 0, alpha, 1", "relative", 1e-14, "1e-14", 1,
     draw_shear_ratio, judge_shear_ratio},
    {"shear", "alpha, c; x dense at 0, ±alpha, ±c, ±1", "of 1 + \\|A p/theta\\|", 1e-14, "1e-14", 1,
     draw_shear, judge_shear},
    {"max_tension", "alpha", "relative", 1e-14, "1e-14", 1, draw_max_tension, judge_max_tension},
    {},
};
