/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Elastic limits, and the points that yield. */
#include <math.h>

#include "references/absence.h"
#include "rows/rows.h"
#include "rwedge.h"
#include "references/strength.h"

static double some_tip(probe *call)
{
    const double alpha = some_rounded_alpha(call);
    return alpha < 1e-14 ? log_between(call, 1e-14, 1) : alpha;
}

/* Not the sharp wedge, whose limits are exact. */
static void some_strength(probe *call, double v[3])
{
    v[0] = argument(call, "alpha", some_tip(call));
    v[1] = argument(call, "f", some_friction(call));
    v[2] = argument(call, "nu", some_poisson(call));
}

/* A contact as all judges of this file need it. */
typedef struct {
    arb_t alpha, f, x, y, J2, limit;
    traction t;
} strength;

static void strength_init(strength *s, const double v[3], slong prec)
{
    arb_init(s->alpha), arb_init(s->f), arb_init(s->x), arb_init(s->y), arb_init(s->J2),
        arb_init(s->limit);
    arb_set_d(s->alpha, fmin(v[0], 1));
    arb_set_d(s->f, v[1]);
    ball_contact(&s->t, s->alpha, s->f, v[2], prec);
}

static void strength_clear(strength *s)
{
    arb_clear(s->alpha), arb_clear(s->f), arb_clear(s->x), arb_clear(s->y), arb_clear(s->J2),
        arb_clear(s->limit);
    traction_clear(&s->t);
}

/* Encloses the maximum at (x, y) and the limit that belongs to it. */
static bool enclose(strength *s, double x, double y, double *flatness, slong prec)
{
    bool proved;
    if (y > 0) {
        acb_t z;
        acb_init(z);
        acb_set_d_d(z, x, y);
        proved = ball_stationary(s->x, s->y, s->J2, flatness, &s->t, z, prec);
        acb_clear(z);
    } else {
        proved = ball_surface_maximum(s->x, s->J2, flatness, &s->t, x, prec);
    }
    if (proved)
        ball_limit(s->limit, s->alpha, s->J2, prec);
    return proved;
}

/* result[0] is a limit, result[1], result[2] where it is. */
static void judge_limit(arb_t error, const probe *call, slong prec)
{
    strength s;
    strength_init(&s, call->value, prec);
    if (enclose(&s, call->result[1], call->result[2], NULL, prec))
        relative_error(error, call->result[0], s.limit, prec);
    else
        arb_indeterminate(error);
    strength_clear(&s);
}

/* The limit is the smaller one of the two branches, and neither of them is below it. */
static bool draw_elastic_limit(probe *call)
{
    double v[3], *r = call->result, limit, x, y;
    some_strength(call, v);
    if (rwedge_yield_point(v[0], v[1], v[2], &r[0], &r[1], &r[2]) != RWEDGE_OK)
        r[0] = NAN;
    if (rwedge_surface_yield(v[0], v[1], v[2], &limit, &x) == RWEDGE_OK && !(r[0] <= limit))
        r[0] = NAN;
    if (rwedge_subsurface_yield(v[0], v[1], v[2], &limit, &x, &y) == RWEDGE_OK && !(r[0] <= limit))
        r[0] = NAN;
    if (rwedge_elastic_limit(v[0], v[1], v[2]) != r[0])
        r[0] = NAN;
    return v[1] > 0 || v[2] < 0.5 || v[0] < 1; /* the whole surface yields */
}

static bool draw_elastic_limits(probe *call)
{
    double v[3], alpha[3], f[3], limit[3], *r = call->result;
    some_strength(call, v);
    for (int i = 0; i < 3; i++) {
        alpha[i] = i == 1 ? v[0] : 0.1 * (i + 1);
        f[i] = i == 1 ? v[1] : 0.5;
    }
    double own;
    if (rwedge_yield_point(v[0], v[1], v[2], &own, &r[1], &r[2]) != RWEDGE_OK ||
        rwedge_elastic_limits(3, alpha, f, v[2], limit) != RWEDGE_OK)
        limit[1] = NAN;
    r[0] = limit[1];
    return true;
}

static bool draw_subsurface(probe *call)
{
    double v[3], *r = call->result;
    some_strength(call, v);
    const int32_t status = rwedge_subsurface_yield(v[0], v[1], v[2], &r[0], &r[1], &r[2]);
    if (status == RWEDGE_EABSENT && !has_maximum_below(v[0], v[1], v[2]))
        return false;
    if (status != RWEDGE_OK)
        r[0] = NAN;
    return true;
}

static bool draw_surface(probe *call)
{
    double v[3], *r = call->result;
    some_strength(call, v);
    if (rwedge_surface_yield(v[0], v[1], v[2], &r[0], &r[1]) != RWEDGE_OK)
        r[0] = NAN;
    return v[2] < 0.5 || v[1] > 0;
}

/* Over |z|, or over alpha at the surface, and times the flatness where the maximum is flat: next
 * to it J2 falls by 1 - flatness (distance/depth)^2/2. */
static void judge_place(arb_t error, const probe *call, slong prec)
{
    strength s;
    double flatness = 1;
    arb_t distance;
    arb_init(distance);
    strength_init(&s, call->value, prec);
    if (enclose(&s, call->result[1], call->result[2], &flatness, prec)) {
        arb_hypot(s.limit, s.x, s.y, prec);
        if (call->result[2] == 0) /* on the surface: over the rounding */
            arb_set(s.limit, s.alpha);
        error_over(error, call->result[1], s.x, s.limit, prec);
        error_over(distance, call->result[2], s.y, s.limit, prec);
        arb_hypot(error, error, distance, prec);
        arb_set_d(distance, fmin(1, flatness));
        arb_mul(error, error, distance, prec);
    } else {
        arb_indeterminate(error);
    }
    arb_clear(distance);
    strength_clear(&s);
}

/* ---- Critical friction ---- */

/* d/df of J2 where the traction is f times the pressure, at a fixed point: D_f = i y G' + G, s_f
 * = -Re G. */
static void J2_by_friction(arb_t slope, const traction *t, const acb_t z, slong prec)
{
    acb_ptr v = _acb_vec_init(4);
    acb_ptr G = v, H = v + 1, D = v + 2, Df = v + 3;
    arb_t s;
    arb_init(s);
    ball_potential(G, &t->patch[0], z, prec);
    ball_potential_slope_by_depth(H, &t->patch[0], z, prec);
    acb_mul_onei(Df, H);
    acb_add(Df, Df, G, prec);
    acb_mul_arb(D, Df, t->f, prec);
    acb_sub(D, D, H, prec);
    arb_mul(slope, acb_realref(D), acb_realref(Df), prec);
    arb_addmul(slope, acb_imagref(D), acb_imagref(Df), prec);
    arb_mul(s, t->f, acb_realref(G), prec);
    arb_sub(s, s, acb_imagref(G), prec); /* -s */
    arb_mul(s, s, acb_realref(G), prec);
    arb_addmul(slope, s, t->kappa, prec);
    arb_mul_2exp_si(slope, slope, 1);
    arb_clear(s);
    _acb_vec_clear(v, 4);
}

/* By how much the maximum below exceeds that of the surface, for all f of the ball, and its
 * derivative by f (that of J2 at the maxima). False where one of them is not proved. */
static bool excess_below(arb_t excess, arb_t slope, const arb_t f, const void *context, slong prec)
{
    const probe *call = context;
    const double *r = call->result;
    arb_ptr w = _arb_vec_init(7);
    arb_ptr alpha = w, J2_below = w + 1, J2_surface = w + 2, by_f = w + 3, zero = w + 4;
    traction t;
    acb_t z;
    acb_init(z);
    arb_set_d(alpha, fmin(call->value[0], 1));
    ball_contact(&t, alpha, f, call->value[1], prec);
    acb_set_d_d(z, r[1], r[2]);
    bool proved = ball_stationary(acb_realref(z), acb_imagref(z), J2_below, NULL, &t, z, prec);
    if (proved) {
        J2_by_friction(slope, &t, z, prec);
        proved = ball_surface_maximum(acb_realref(z), J2_surface, NULL, &t, r[3], prec);
        arb_set(acb_imagref(z), zero);
        J2_by_friction(by_f, &t, z, prec);
        arb_sub(slope, slope, by_f, prec);
        arb_sub(excess, J2_below, J2_surface, prec);
    }
    traction_clear(&t);
    acb_clear(z);
    _arb_vec_clear(w, 7);
    return proved;
}

/* The places of both maxima for that friction, in the probe's results. */
static bool find_places(probe *call, double f)
{
    double *r = call->result, limit;
    const double alpha = call->value[0], nu = call->value[1];
    return rwedge_subsurface_yield(alpha, f, nu, &limit, &r[1], &r[2]) == RWEDGE_OK &&
           rwedge_surface_yield(alpha, f, nu, &limit, &r[3]) == RWEDGE_OK;
}

/* The promise lets 0 stand for what is below 1e-7: it is wrong where the maximum below is still
 * the higher one there. */
static bool is_wrongly_zero(probe *call)
{
    enum { BITS = 512 };
    static const double LEAST = 1e-7;
    if (!find_places(call, LEAST))
        return false;
    arb_t f, excess, slope;
    arb_init(f), arb_init(excess), arb_init(slope);
    arb_set_d(f, LEAST);
    const bool wrong = excess_below(excess, slope, f, call, BITS) && arb_is_positive(excess);
    arb_clear(f), arb_clear(excess), arb_clear(slope);
    return wrong;
}

static bool draw_critical_friction(probe *call)
{
    const double alpha = argument(call, "alpha", some_tip(call)),
                 nu = argument(call, "nu", some_poisson(call));
    double *r = call->result;
    r[0] = rwedge_critical_friction(alpha, nu);
    if (r[0] == 0 && !is_wrongly_zero(call))
        return false;
    if (r[0] == 0 || !find_places(call, r[0]))
        r[0] = NAN;
    return true;
}

/* The promise is 1e-11 f, or 1e-14/f. */
static void judge_critical_friction(arb_t error, const probe *call, slong prec)
{
    arb_t f, scale;
    arb_init(f), arb_init(scale);
    if (ball_parameter(f, call->result[0], excess_below, call, prec)) {
        arb_set_d(scale, 1e-3);
        arb_div(scale, scale, f, prec);
        arb_max(scale, scale, f, prec);
        error_over(error, call->result[0], f, scale, prec);
    } else {
        arb_indeterminate(error);
    }
    arb_clear(f), arb_clear(scale);
}

const row STRENGTH_ROWS[] = {
    {"elastic_limit, yield_point", "alpha 1e-14 to 1e60; f 0 to 1e6; nu 0 to 0.5", "relative",
     1e-12, "1e-12", 1, draw_elastic_limit, judge_limit},
    {"elastic_limits", "the same", "relative", 1e-12, "1e-12", 1, draw_elastic_limits, judge_limit},
    {"subsurface_yield", "where it exists", "relative", 1e-12, "1e-12", 1, draw_subsurface,
     judge_limit},
    {"surface_yield", "the same", "relative", 1e-12, "1e-12", 1, draw_surface, judge_limit},
    {"subsurface_yield, place", "where it exists", "of \\|z\\|, times flatness", 1e-12,
     "about 1e-12", 0.1, draw_subsurface, judge_place},
    {"surface_yield, place", "the same", "of alpha, times flatness", 1e-12, "about 1e-12", 0.1,
     draw_surface, judge_place},
    {"critical_friction", "alpha, nu, where not 0", "of max(f, 0.001/f)", 1e-11, "1e-11", 0.1,
     draw_critical_friction, judge_critical_friction},
    {0},
};
