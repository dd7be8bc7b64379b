/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses in full sliding and in partial slip. */
#include <math.h>

#include "rows/rows.hpp"
#include "rwedge.h"

namespace
{

bool is_no_apex(const probe &call)
{
    const double *v = call.value;
    return v[0] > 0 || v[3] != 0 || v[4] != 0;
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

const drawn alpha = {"alpha", some_alpha}, f = {"f", some_friction},
            none = {"c", [](probe *) { return 0.0; }}, c = {"c", some_c};

#define MEASURE "of max(norm, max(1, f)/(1+\\|z\\|))"

} // namespace

const row STRESS_ROWS[] = {
    {"stress, full sliding",
     "alpha; f 0 to 1e6; points at all scales around 0, ±alpha, ±1, y = 0, far to 1e60", MEASURE,
     1e-13, "1e-13", 1, calling(rwedge_stress, {alpha, f, none, some_point}, is_no_apex),
     judge_stress},
    {"stress, partial slip", "also c dense at 0, alpha, 1, and around ±c", MEASURE, 1e-13, "1e-13",
     1, calling(rwedge_stress, {alpha, f, c, some_point}, is_no_apex), judge_stress},
    {},
};
