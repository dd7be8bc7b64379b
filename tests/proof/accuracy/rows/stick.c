/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Partial slip, and the maximum tension. */
#include <math.h>

#include "rows/rows.h"
#include "rwedge.h"

/* a, 1 and c as balls. */
typedef struct {
    arb_t a, one, c;
} widths;

static void widths_init(widths *w, double alpha, double c)
{
    arb_init(w->a), arb_init(w->one), arb_init(w->c);
    arb_set_d(w->a, alpha);
    arb_one(w->one);
    arb_set_d(w->c, c);
}

static void widths_clear(widths *w)
{
    arb_clear(w->a), arb_clear(w->one), arb_clear(w->c);
}

/* ---- Stick zone ---- */

static bool draw_stick_width(probe *call)
{
    const double alpha = argument(call, "alpha", some_alpha(call));
    call->result[0] =
        rwedge_stick_width(alpha, argument(call, "Q_over_fP", some_fraction(call, 0.5)));
    return true;
}

/* The half-width under the load F(1)(1-Q/(fP)), Eq. (25). */
static void judge_stick_width(arb_t error, const probe *call, slong prec)
{
    widths w;
    arb_t force, fraction;
    widths_init(&w, call->value[0], 0);
    arb_init(force), arb_init(fraction);
    arb_set_d(fraction, call->value[1]);
    arb_sub(fraction, w.one, fraction, ARF_PREC_EXACT);
    if (!arb_is_zero(fraction)) {
        ball_force(force, w.a, w.one, prec);
        arb_mul(force, force, fraction, prec);
        ball_half_width(w.c, w.a, force, call->result[0], prec);
    }
    relative_error(error, call->result[0], w.c, prec);
    arb_clear(force), arb_clear(fraction);
    widths_clear(&w);
}

static bool draw_shear_ratio(probe *call)
{
    const double alpha = argument(call, "alpha", some_alpha(call));
    call->result[0] =
        rwedge_shear_ratio(alpha, argument(call, "c", some_fraction(call, fmin(alpha, 1))));
    return true;
}

/* 1 - F(c)/F(1). */
static void judge_shear_ratio(arb_t error, const probe *call, slong prec)
{
    widths w;
    arb_t whole, kept;
    widths_init(&w, call->value[0], call->value[1]);
    arb_init(whole), arb_init(kept);
    ball_force(whole, w.a, w.one, prec);
    if (!arb_is_zero(w.c))
        ball_force(kept, w.a, w.c, prec);
    if (!arb_equal(w.c, w.one)) {
        arb_div(kept, kept, whole, prec);
        arb_sub(kept, w.one, kept, prec);
    } else {
        arb_zero(kept);
    }
    relative_error(error, call->result[0], kept, prec);
    arb_clear(whole), arb_clear(kept);
    widths_clear(&w);
}

static bool draw_shear(probe *call)
{
    const double alpha = argument(call, "alpha", some_alpha(call));
    const double c = argument(call, "c", some_fraction(call, fmin(alpha, 1)));
    const double x = argument(call, "x", some_place(call, alpha, c));
    call->result[0] = rwedge_shear(alpha, c, x);
    return alpha > 0 || x != 0;
}

/* p(x; 1) - p(x; c) over 1 + |p|, Eq. (23), (26), (27). */
static void judge_shear(arb_t error, const probe *call, slong prec)
{
    widths w;
    arb_t x, p, q;
    widths_init(&w, call->value[0], call->value[1]);
    arb_init(x), arb_init(p), arb_init(q);
    arb_set_d(x, call->value[2]);
    ball_pressure(p, w.a, w.one, x, prec);
    if (!arb_is_zero(w.c))
        ball_pressure(q, w.a, w.c, x, prec);
    arb_sub(q, p, q, prec);
    arb_sub(p, w.one, p, prec);
    error_over(error, call->result[0], q, p, prec);
    arb_clear(x), arb_clear(p), arb_clear(q);
    widths_clear(&w);
}

/* ---- Maximum tension ---- */

static bool draw_max_tension(probe *call)
{
    call->result[0] = rwedge_max_tension(argument(call, "alpha", some_alpha(call)));
    return true;
}

/* sxx = 2 f at the trailing edge over f load: 2 alpha/(phi0 + alpha c0); for alpha >= 1 as for
 * 1. */
static void judge_max_tension(arb_t error, const probe *call, slong prec)
{
    widths w;
    arb_t force;
    widths_init(&w, fmin(call->value[0], 1), 0);
    arb_init(force);
    ball_force(force, w.a, w.one, prec);
    arb_ui_div(force, 2, force, prec);
    relative_error(error, call->result[0], force, prec);
    arb_clear(force);
    widths_clear(&w);
}

const row STICK_ROWS[] = {
    {"stick_width", "alpha; Q/(fP) dense at 0, 1", "relative", 1e-14, "1e-14", 1, draw_stick_width,
     judge_stick_width},
    {"shear_ratio", "alpha; c dense at 0, alpha, 1", "relative", 1e-14, "1e-14", 1,
     draw_shear_ratio, judge_shear_ratio},
    {"shear", "alpha, c; x dense at 0, ±alpha, ±c, ±1", "of 1 + \\|A p/theta\\|", 1e-14, "1e-14", 1,
     draw_shear, judge_shear},
    {"max_tension", "alpha", "relative", 1e-14, "1e-14", 1, draw_max_tension, judge_max_tension},
    {0},
};
