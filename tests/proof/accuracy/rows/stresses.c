/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses in full sliding and in partial slip, one point at a time and many. */
#include <math.h>

#include "references/field.h"
#include "rows/rows.h"
#include "rwedge.h"

/* alpha, f, c, x, y */
static void some_case(probe *call, bool slides, double v[5])
{
    v[0] = argument(call, "alpha", some_alpha(call));
    v[1] = argument(call, "f", some_friction(call));
    v[2] = argument(call, "c", slides ? 0 : some_fraction(call, fmin(v[0], 1)));
    some_point(call, v[0], v[2], &v[3], &v[4]);
}

static bool is_apex(const double v[5])
{
    return v[0] == 0 && v[3] == 0 && v[4] == 0;
}

static bool draw_stress(probe *call, bool slides)
{
    double v[5], *s = call->result;
    some_case(call, slides, v);
    if (is_apex(v))
        return false;
    if (rwedge_stress(v[0], v[1], v[2], v[3], v[4], &s[0], &s[1], &s[2]) != RWEDGE_OK)
        s[0] = NAN;
    return true;
}

static bool draw_sliding(probe *call)
{
    return draw_stress(call, true);
}

static bool draw_partial_slip(probe *call)
{
    return draw_stress(call, false);
}

/* One of up to 20 points, of which the others only fill the array. */
static bool draw_stresses(probe *call)
{
    enum { POINTS = 20 };
    double v[5], x[POINTS], y[POINTS], sxx[POINTS], syy[POINTS], txy[POINTS];
    some_case(call, chance(call, 0.5), v);
    const size_t n = 1 + (size_t)(POINTS * uniform(call)),
                 which = (size_t)((double)n * uniform(call));
    for (size_t i = 0; i < n; i++) {
        probe other = {.random = call->random};
        some_point(&other, v[0], v[2], &x[i], &y[i]);
        if (v[0] == 0 && x[i] == 0)
            y[i] = 1;
        call->random = other.random;
    }
    x[which] = v[3];
    y[which] = v[4];
    if (is_apex(v))
        return false;
    if (rwedge_stresses(v[0], v[1], v[2], n, x, y, sxx, syy, txy) != RWEDGE_OK)
        sxx[which] = NAN;
    call->result[0] = sxx[which];
    call->result[1] = syy[which];
    call->result[2] = txy[which];
    return true;
}

/* The largest of the components' errors, over the larger of the norm and max(1, f)/(1+|z|). */
static void tensor_error(arb_t error, const double result[3], arb_srcptr s, const acb_t z, double f,
                         slong prec)
{
    arb_t norm, far;
    arb_init(norm), arb_init(far);
    arb_mul(norm, s, s, prec);
    arb_addmul(norm, s + 1, s + 1, prec);
    arb_mul(far, s + 2, s + 2, prec);
    arb_mul_2exp_si(far, far, 1);
    arb_add(norm, norm, far, prec);
    arb_sqrtpos(norm, norm, prec);
    acb_abs(far, z, prec);
    arb_add_ui(far, far, 1, prec);
    arb_set_d(error, fmax(1, f));
    arb_div(far, error, far, prec);
    arb_max(norm, norm, far, prec);
    arb_zero(error);
    for (int i = 0; i < 3; i++) {
        error_over(far, result[i], s + i, norm, prec);
        arb_max(error, error, far, prec);
    }
    arb_clear(norm), arb_clear(far);
}

static void judge_stress(arb_t error, const probe *call, slong prec)
{
    const double *v = call->value;
    arb_ptr w = _arb_vec_init(6);
    arb_ptr s = w, one = w + 3, c = w + 4, a = w + 5;
    acb_t z;
    acb_init(z);
    acb_set_d_d(z, v[3], v[4]);
    arb_set_d(a, v[0]);
    arb_set_d(c, v[1]);
    traction t;
    traction_init(&t, a, c, 0, prec);
    arb_set_si(one, -1);
    arb_set_d(c, v[2]);
    if (v[2] > 0)
        traction_add(&t, c, one, prec); /* the stick zone's corrective traction */
    arb_one(one);
    traction_add(&t, one, one, prec);
    ball_stresses(s, s + 1, s + 2, &t, z, prec);
    tensor_error(error, call->result, s, z, v[1], prec);
    traction_clear(&t);
    acb_clear(z);
    _arb_vec_clear(w, 6);
}

#define MEASURE "of max(norm, max(1, f)/(1+\\|z\\|))"

const row STRESS_ROWS[] = {
    {"stress, full sliding",
     "alpha; f 0 to 1e6; points at all scales around 0, ±alpha, ±1, y = 0, far to 1e60", MEASURE,
     1e-13, "1e-13", 1, draw_sliding, judge_stress},
    {"stress, partial slip", "also c dense at 0, alpha, 1, and around ±c", MEASURE, 1e-13, "1e-13",
     1, draw_partial_slip, judge_stress},
    {"stresses", "the same, 1 to 20 points", MEASURE, 1e-13, "1e-13", 1, draw_stresses,
     judge_stress},
    {0},
};
