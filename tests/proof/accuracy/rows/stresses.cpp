/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses in full sliding and in partial slip. */
#include <math.h>

#include "rows/rows.hpp"
#include "rwedge.h"

namespace
{

/* alpha, f, c, x, y */
void some_case(probe *call, bool slides, double v[5])
{
    v[0] = argument(call, "alpha", some_alpha(call));
    v[1] = argument(call, "f", some_friction(call));
    v[2] = argument(call, "c", slides ? 0 : some_fraction(call, fmin(v[0], 1)));
    some_point(call, v[0], v[2], &v[3], &v[4]);
}

bool is_apex(const double v[5])
{
    return v[0] == 0 && v[3] == 0 && v[4] == 0;
}

template <bool slides> bool draw_stress(probe *call)
{
    double v[5], *s = call->result;
    some_case(call, slides, v);
    if (is_apex(v))
        return false;
    return gives_if(call, rwedge_stress(v[0], v[1], v[2], v[3], v[4], &s[0], &s[1], &s[2]));
}

/* The largest of the components' errors, over the larger of the norm and max(1, f)/(1+|z|). */
ball judge_stress(const probe &call)
{
    const double *v = call.value;
    const complex_ball z(v[3], v[4]);
    const potentials N = patch(v[0], 1).at(z);
    const potentials slip = v[2] > 0 ? N - patch(v[0], v[2]).at(z) : N;
    const tensor s = tensor_of(superposed(N, ball(v[1]) * slip));
    return error_over(call.result, s, max(norm_of(s), fmax(1, v[1]) / (abs(z) + 1)));
}

#define MEASURE "of max(norm, max(1, f)/(1+\\|z\\|))"

} // namespace

const row STRESS_ROWS[] = {
    {"stress, full sliding",
     "alpha; f 0 to 1e6; points at all scales around 0, ±alpha, ±1, y = 0, far to 1e60", MEASURE,
     1e-13, "1e-13", 1, draw_stress<true>, judge_stress},
    {"stress, partial slip", "also c dense at 0, alpha, 1, and around ±c", MEASURE, 1e-13, "1e-13",
     1, draw_stress<false>, judge_stress},
    {},
};
