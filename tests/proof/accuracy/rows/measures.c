/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measures of a stress; the critical plane. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "rows/rows.h"
#include "rwedge.h"

static const double EPSILON = DBL_EPSILON;

/* ---- One stress ---- */

/* From 1e-60 to 1e60, next to each other, equal, or 0. */
static double some_stress(probe *call, double other)
{
    const double kind = uniform(call);
    return kind < 0.1   ? 0
           : kind < 0.3 ? either_sign(call, near(call, fmax(fabs(other), 1e-59)))
           : kind < 0.4 ? either_sign(call, other)
           : kind < 0.6 ? either_sign(call, fmax(fabs(other), 1e-59) * log_between(call, 1e-9, 1))
                        : either_sign(call, log_between(call, 1e-60, 0.5e60));
}

static void draw_stress(probe *call, double s[3])
{
    s[0] = argument(call, "sxx", some_stress(call, 1));
    s[1] = argument(call, "syy", some_stress(call, s[0]));
    s[2] = argument(call, "txy", some_stress(call, s[chance(call, 0.5)]));
}

/* s, d, t and R of the stress. */
typedef struct {
    arb_t s, d, t, R;
} circle;

static void circle_init(circle *c, const double s[3], slong prec)
{
    arb_init(c->s), arb_init(c->d), arb_init(c->t), arb_init(c->R);
    arb_set_d(c->s, s[0]);
    arb_set_d(c->t, s[1]);
    arb_sub(c->d, c->t, c->s, prec);
    arb_add(c->s, c->t, c->s, prec);
    arb_mul_2exp_si(c->s, c->s, -1);
    arb_mul_2exp_si(c->d, c->d, -1);
    arb_set_d(c->t, s[2]);
    arb_mul(c->R, c->d, c->d, prec);
    arb_addmul(c->R, c->t, c->t, prec);
    arb_sqrtpos(c->R, c->R, prec);
}

static void circle_clear(circle *c)
{
    arb_clear(c->s), arb_clear(c->d), arb_clear(c->t), arb_clear(c->R);
}

/* |(1-2nu) s| */
static void ball_off(arb_t off, const circle *c, double nu, slong prec)
{
    arb_set_d(off, -2 * nu);
    arb_add_ui(off, off, 1, ARF_PREC_EXACT);
    arb_mul(off, off, c->s, prec);
    arb_abs(off, off);
}

static bool draw_von_mises(probe *call)
{
    double s[3];
    draw_stress(call, s);
    call->result[0] = rwedge_von_mises(s[0], s[1], s[2], argument(call, "nu", some_poisson(call)));
    return true;
}

static void judge_von_mises(arb_t error, const probe *call, slong prec)
{
    circle c;
    arb_t off;
    circle_init(&c, call->value, prec);
    arb_init(off);
    ball_off(off, &c, call->value[3], prec);
    arb_mul(off, off, off, prec);
    arb_mul(c.R, c.R, c.R, prec);
    arb_addmul_ui(off, c.R, 3, prec);
    arb_sqrtpos(off, off, prec);
    relative_error(error, call->result[0], off, prec);
    arb_clear(off);
    circle_clear(&c);
}

static bool draw_largest_shear(probe *call)
{
    double s[3];
    draw_stress(call, s);
    call->result[0] =
        rwedge_largest_shear(s[0], s[1], s[2], argument(call, "nu", some_poisson(call)));
    return true;
}

/* The largest of |s1-s2|/2 and |s1-szz|/2, |s2-szz|/2, the larger of which is (R + |s-szz|)/2. */
static void judge_largest_shear(arb_t error, const probe *call, slong prec)
{
    circle c;
    arb_t off;
    circle_init(&c, call->value, prec);
    arb_init(off);
    ball_off(off, &c, call->value[3], prec);
    arb_add(off, off, c.R, prec);
    arb_mul_2exp_si(off, off, -1);
    arb_max(off, off, c.R, prec);
    relative_error(error, call->result[0], off, prec);
    arb_clear(off);
    circle_clear(&c);
}

static bool draw_out_of_plane(probe *call)
{
    const double sxx = argument(call, "sxx", some_stress(call, 1)),
                 syy = argument(call, "syy", some_stress(call, sxx));
    call->result[0] =
        rwedge_out_of_plane_stress(sxx, syy, argument(call, "nu", some_poisson(call)));
    return true;
}

static void judge_out_of_plane(arb_t error, const probe *call, slong prec)
{
    const double s[3] = {call->value[0], call->value[1], 0};
    circle c;
    circle_init(&c, s, prec);
    arb_set_d(c.t, 2 * call->value[2]);
    arb_mul(c.t, c.t, c.s, prec);
    relative_error(error, call->result[0], c.t, prec);
    circle_clear(&c);
}

static bool draw_principal(probe *call)
{
    double s[3], *r = call->result;
    draw_stress(call, s);
    if (rwedge_principal_stresses(s[0], s[1], s[2], &r[0], &r[1], &r[2]) != RWEDGE_OK)
        r[0] = NAN;
    return true;
}

/* Of the larger of |s1|, |s2|. */
static void judge_principal(arb_t error, const probe *call, slong prec)
{
    circle c;
    arb_t scale, one;
    circle_init(&c, call->value, prec);
    arb_init(scale), arb_init(one);
    arb_abs(scale, c.s);
    arb_add(scale, scale, c.R, prec);
    arb_add(one, c.s, c.R, prec);
    error_over(error, call->result[0], one, scale, prec);
    arb_sub(one, c.s, c.R, prec);
    error_over(c.t, call->result[1], one, scale, prec);
    arb_max(error, error, c.t, prec);
    arb_clear(scale), arb_clear(one);
    circle_clear(&c);
}

/* Half of the angle of (d, t), which is determined where R is not 0. */
static void judge_angle(arb_t error, const probe *call, slong prec)
{
    circle c;
    arb_t one;
    circle_init(&c, call->value, prec);
    arb_init(one);
    arb_one(one);
    if (arb_is_zero(c.t))
        arb_abs(c.t, c.t); /* a d below 0 is at pi, not -pi */
    if (arb_is_zero(c.d) && arb_is_zero(c.t))
        arb_zero(c.R);
    else
        arb_atan2(c.R, c.t, c.d, prec);
    arb_mul_2exp_si(c.R, c.R, -1);
    error_over(error, call->result[2], c.R, one, prec);
    arb_const_pi(c.s, prec); /* angles that differ by pi are of one plane */
    arb_sub(c.s, c.s, error, prec);
    arb_abs(c.s, c.s);
    arb_min(error, error, c.s, prec);
    arb_clear(one);
    circle_clear(&c);
}

/* ---- The critical plane of three loads ---- */

enum { LOADS = 3, BITS = 192 };

/* mean + cosine cos(phi) + sine sin(phi) */
typedef struct {
    arb_t part[3];
} wave;

static void wave_init(wave *w)
{
    for (int i = 0; i < 3; i++)
        arb_init(w->part[i]);
}

static void wave_clear(wave *w)
{
    for (int i = 0; i < 3; i++)
        arb_clear(w->part[i]);
}

static void wave_at(arb_t value, arb_t slope, const wave *w, const arb_t cosine, const arb_t sine)
{
    arb_mul(value, w->part[1], cosine, BITS);
    arb_addmul(value, w->part[2], sine, BITS);
    arb_add(value, value, w->part[0], BITS);
    arb_mul(slope, w->part[2], cosine, BITS);
    arb_submul(slope, w->part[1], sine, BITS);
}

/* |mean| + |cosine| + |sine|: above the wave and its derivatives. */
static void wave_bound(arb_t bound, const wave *w)
{
    arb_t v;
    arb_init(v);
    arb_zero(bound);
    for (int i = 0; i < 3; i++) {
        arb_abs(v, w->part[i]);
        arb_add(bound, bound, v, BITS);
    }
    arb_clear(v);
}

/* The stress of a load, and the peak and the range as the header defines them, in the unit of its
 * error: s^2 (1+nu)/E or (1 + s k/sy) s (1+nu)/E is 1. */
typedef struct {
    wave peak[LOADS], range[LOADS];
    arb_t best, nearly; /* the largest product so far, and what is as good */
} plane_problem;

static bool is_fatemi_socie(const probe *call)
{
    return call->arguments == 12;
}

static void largest_principal(arb_t s, const probe *call)
{
    arb_zero(s);
    for (int i = 0; i < LOADS; i++) {
        circle c;
        circle_init(&c, call->value + 3 * i, BITS);
        arb_abs(c.s, c.s);
        arb_add(c.s, c.s, c.R, BITS);
        arb_max(s, s, c.s, BITS);
        circle_clear(&c);
    }
}

/* Stresses over s; the peak of Fatemi and Socie over 1 + s k/sy. */
static void problem_init(plane_problem *p, const probe *call)
{
    const bool shear = is_fatemi_socie(call);
    arb_t s, k, nu;
    arb_init(s), arb_init(k), arb_init(nu), arb_init(p->best), arb_init(p->nearly);
    largest_principal(s, call);
    if (arb_is_zero(s))
        arb_one(s);
    arb_set_d(k, shear ? call->value[11] : 1);
    if (shear)
        arb_mul(k, k, s, BITS);
    arb_set_d(nu, call->value[10]);
    for (int i = 0; i < LOADS; i++) {
        circle c;
        circle_init(&c, call->value + 3 * i, BITS);
        wave_init(&p->peak[i]);
        wave_init(&p->range[i]);
        arb_div(c.s, c.s, s, BITS);
        arb_div(c.d, c.d, s, BITS);
        arb_div(c.t, c.t, s, BITS);
        arb_set(p->peak[i].part[0], c.s);
        arb_set(p->peak[i].part[1], c.d);
        arb_set(p->peak[i].part[2], c.t);
        if (shear) {
            for (int j = 0; j < 3; j++)
                arb_mul(p->peak[i].part[j], p->peak[i].part[j], k, BITS);
            arb_add_ui(p->peak[i].part[0], p->peak[i].part[0], 1, BITS);
            arb_add_ui(c.R, k, 1, BITS);
            for (int j = 0; j < 3; j++)
                arb_div(p->peak[i].part[j], p->peak[i].part[j], c.R, BITS);
            arb_set(p->range[i].part[1], c.t);
            arb_neg(p->range[i].part[2], c.d);
        } else {
            arb_mul_si(c.R, nu, -2, BITS);
            arb_add_ui(c.R, c.R, 1, BITS);
            arb_mul(p->range[i].part[0], c.R, c.s, BITS);
            for (int j = 0; j < 3; j++) /* half of the range counts */
                arb_mul_2exp_si(p->range[i].part[j],
                                j == 0   ? p->range[i].part[0]
                                : j == 1 ? c.d
                                         : c.t,
                                -1);
        }
        circle_clear(&c);
    }
    arb_clear(s), arb_clear(k), arb_clear(nu);
}

static void problem_clear(plane_problem *p)
{
    for (int i = 0; i < LOADS; i++) {
        wave_clear(&p->peak[i]);
        wave_clear(&p->range[i]);
    }
    arb_clear(p->best), arb_clear(p->nearly);
}

/* The best from here on is this product, and what is hardly more is as good. */
static void set_best(plane_problem *p, const arb_t product)
{
    arb_set(p->best, product);
    arb_set_ui(p->nearly, 1);
    arb_mul_2exp_si(p->nearly, p->nearly, -67);
    arb_add(p->nearly, p->nearly, product, BITS);
}

/* The product of two waves, both positive, within `reach` of phi: raises the best, and halves the
 * interval until Taylor's bound of the second order says that nothing better is there. */
static void climb(plane_problem *p, const wave *x, const wave *y, const arb_t x_bound,
                  const arb_t y_bound, double phi, double reach)
{
    arb_ptr t = _arb_vec_init(9);
    arb_ptr cosine = t, sine = t + 1, X = t + 2, dX = t + 3, Y = t + 4, dY = t + 5, top = t + 6,
            r = t + 7, product = t + 8;
    arb_set_d(r, phi);
    arb_sin_cos(sine, cosine, r, BITS);
    arb_set_d(r, reach);
    wave_at(X, dX, x, cosine, sine);
    wave_at(Y, dY, y, cosine, sine);
    arb_mul(product, X, Y, BITS);
    if (arb_is_positive(X) && arb_is_positive(Y) && arb_gt(product, p->best))
        set_best(p, product);
    /* |X|'', |Y|'' are below their bounds, (XY)'' below four times the product of these */
    arb_mul(top, dX, Y, BITS);
    arb_addmul(top, X, dY, BITS);
    arb_abs(top, top);
    arb_mul(top, top, r, BITS);
    arb_add(product, product, top, BITS);
    arb_mul(r, r, r, BITS);
    arb_mul_2exp_si(r, r, 1);
    arb_mul(top, x_bound, y_bound, BITS);
    arb_addmul(product, top, r, BITS);
    /* X, Y below 0 throughout */
    arb_set_d(r, reach);
    arb_addmul(X, x_bound, r, BITS);
    arb_addmul(Y, y_bound, r, BITS);
    const bool done = arb_le(product, p->nearly) || arb_is_nonpositive(X) || arb_is_nonpositive(Y);
    _arb_vec_clear(t, 9);
    if (done)
        return;
    if (reach < 1e-13) { /* nothing is known: an infinite error */
        arb_indeterminate(p->best);
        return;
    }
    climb(p, x, y, x_bound, y_bound, phi - reach / 2, reach / 2);
    climb(p, x, y, x_bound, y_bound, phi + reach / 2, reach / 2);
}

/* For each load whose stress may be the peak, and each two whose difference may be the range. It
 * begins with the best known. The circle is within 4 of 0. */
static void largest_product(plane_problem *p)
{
    wave difference;
    arb_t x_bound, y_bound;
    wave_init(&difference);
    arb_init(x_bound), arb_init(y_bound);
    for (int i = 0; i < LOADS; i++)
        for (int j = 0; j < LOADS * LOADS; j++) {
            for (int k = 0; k < 3; k++)
                arb_sub(difference.part[k], p->range[j / LOADS].part[k],
                        p->range[j % LOADS].part[k], BITS);
            wave_bound(x_bound, &p->peak[i]);
            wave_bound(y_bound, &difference);
            climb(p, &p->peak[i], &difference, x_bound, y_bound, 0, 4);
        }
    arb_union(p->best, p->best, p->nearly, BITS);
    arb_clear(x_bound), arb_clear(y_bound);
    wave_clear(&difference);
}

/* The parameter of the plane at the angle. */
static void product_at(arb_t product, const plane_problem *p, double angle)
{
    arb_ptr t = _arb_vec_init(7);
    arb_ptr cosine = t, sine = t + 1, value = t + 2, slope = t + 3, most = t + 4, top = t + 5,
            bottom = t + 6;
    arb_set_d(value, 2 * angle);
    arb_sin_cos(sine, cosine, value, BITS);
    for (int i = 0; i < LOADS; i++) {
        wave_at(value, slope, &p->peak[i], cosine, sine);
        arb_max(most, most, value, BITS); /* from 0 */
        wave_at(value, slope, &p->range[i], cosine, sine);
        if (i == 0) {
            arb_set(top, value);
            arb_set(bottom, value);
        }
        arb_max(top, top, value, BITS);
        arb_min(bottom, bottom, value, BITS);
    }
    arb_sub(product, top, bottom, BITS);
    arb_mul(product, product, most, BITS);
    _arb_vec_clear(t, 7);
}

/* The value over its unit: s^2 (1+nu)/E or (1 + s k/sy) s (1+nu)/E. */
static void in_units(arb_t value, const probe *call)
{
    arb_t s, factor;
    arb_init(s), arb_init(factor);
    largest_principal(s, call);
    arb_set_d(value, call->result[0]);
    if (!arb_is_zero(s)) {
        arb_div(value, value, s, BITS);
        arb_set_d(factor, is_fatemi_socie(call) ? call->value[11] : 1);
        arb_mul(s, s, factor, BITS);
        if (is_fatemi_socie(call))
            arb_add_ui(s, s, 1, BITS);
        arb_div(value, value, s, BITS);
    }
    arb_set_d(factor, call->value[9]);
    arb_mul(value, value, factor, BITS);
    arb_set_d(factor, call->value[10]);
    arb_add_ui(factor, factor, 1, BITS);
    arb_div(value, value, factor, BITS);
    arb_clear(s), arb_clear(factor);
}

/* How far the value is from the largest of all planes, and the named plane's from it. */
static void judge_plane(arb_t error, const probe *call, slong prec)
{
    (void)prec;
    arb_t value, own;
    arb_init(value), arb_init(own);
    plane_problem p;
    problem_init(&p, call);
    in_units(value, call);
    product_at(own, &p, call->result[1]);
    set_best(&p, own); /* a plane like any other */
    largest_product(&p);
    arb_sub(error, value, p.best, BITS);
    arb_abs(error, error);
    arb_sub(own, own, p.best, BITS);
    arb_abs(own, own);
    arb_max(error, error, own, BITS);
    problem_clear(&p);
    arb_clear(value), arb_clear(own);
}

/* Cycles of one size, in which stresses are often 0, equal or opposite. */
static void draw_cycle(probe *call, double s[3][LOADS])
{
    static const char *const NAMES[] = {"sxx1", "syy1", "txy1", "sxx2", "syy2",
                                        "txy2", "sxx3", "syy3", "txy3"};
    const double size = log_between(call, 1e-56, 1e56), kind = uniform(call);
    for (int i = 0; i < 3 * LOADS; i++) {
        double v = chance(call, 0.1) ? 0 : size * between(call, -1, 1);
        if (i >= 3 && kind < 0.3)
            v = kind < 0.1 ? s[i % 3][0] : kind < 0.2 ? -s[i % 3][0] : i * s[i % 3][0];
        if (i >= 3 && kind >= 0.3 && kind < 0.4)
            v = near(call, s[i % 3][i / 3 - 1]);
        s[i % 3][i / 3] = argument(call, NAMES[i], v);
    }
}

static bool draw_smith_watson_topper(probe *call)
{
    double s[3][LOADS];
    draw_cycle(call, s);
    const double E = argument(call, "E", log_between(call, 1e-3, 1e6)),
                 nu = argument(call, "nu", some_poisson(call));
    if (rwedge_smith_watson_topper(LOADS, s[0], s[1], s[2], E, nu, &call->result[0],
                                   &call->result[1]) != RWEDGE_OK)
        call->result[0] = NAN;
    return true;
}

/* The cycle at the second of two points. */
typedef struct {
    double sxx[2 * LOADS], syy[2 * LOADS], txy[2 * LOADS], value[2], angle[2];
} pair_of_points;

static pair_of_points beside_another(double s[3][LOADS])
{
    pair_of_points p;
    for (int i = 0; i < LOADS; i++) {
        p.sxx[2 * i] = s[1][i] / 3, p.syy[2 * i] = s[2][i], p.txy[2 * i] = s[0][i];
        p.sxx[2 * i + 1] = s[0][i], p.syy[2 * i + 1] = s[1][i], p.txy[2 * i + 1] = s[2][i];
    }
    return p;
}

static void give_second(probe *call, const pair_of_points *p, int32_t status)
{
    call->result[0] = status == RWEDGE_OK ? p->value[1] : NAN;
    call->result[1] = status == RWEDGE_OK ? p->angle[1] : NAN;
}

static bool draw_smith_watson_topper_field(probe *call)
{
    double s[3][LOADS];
    draw_cycle(call, s);
    const double E = argument(call, "E", log_between(call, 1e-3, 1e6)),
                 nu = argument(call, "nu", some_poisson(call));
    pair_of_points p = beside_another(s);
    give_second(
        call, &p,
        rwedge_smith_watson_topper_field(LOADS, 2, p.sxx, p.syy, p.txy, E, nu, p.value, p.angle));
    return true;
}

static double some_k_over_sy(probe *call, double s[3][LOADS])
{
    const double k = log_between(call, 1e-3, 1e3) / fmax(fabs(s[0][0]), 1e-56);
    return argument(call, "k_over_sy", chance(call, 0.1) ? 0 : k);
}

static bool draw_fatemi_socie_field(probe *call)
{
    double s[3][LOADS];
    draw_cycle(call, s);
    const double E = argument(call, "E", log_between(call, 1e-3, 1e6)),
                 nu = argument(call, "nu", some_poisson(call)), k = some_k_over_sy(call, s);
    pair_of_points p = beside_another(s);
    give_second(
        call, &p,
        rwedge_fatemi_socie_field(LOADS, 2, p.sxx, p.syy, p.txy, E, nu, k, p.value, p.angle));
    return true;
}

static bool draw_fatemi_socie(probe *call)
{
    double s[3][LOADS];
    draw_cycle(call, s);
    const double E = argument(call, "E", log_between(call, 1e-3, 1e6)),
                 nu = argument(call, "nu", some_poisson(call)), k = some_k_over_sy(call, s);
    if (rwedge_fatemi_socie(LOADS, s[0], s[1], s[2], E, nu, k, &call->result[0],
                            &call->result[1]) != RWEDGE_OK)
        call->result[0] = NAN;
    return true;
}

#define STRESS "1e-60 to 1e60, 0, dense where equal"

const row MEASURE_ROWS[] = {
    {"von_mises", STRESS "; nu", "relative", 4 * EPSILON, "4 eps", 1, draw_von_mises,
     judge_von_mises},
    {"out_of_plane_stress", "the same", "relative", 4 * EPSILON, "4 eps", 1, draw_out_of_plane,
     judge_out_of_plane},
    {"largest_shear", "the same", "relative", 4 * EPSILON, "4 eps", 1, draw_largest_shear,
     judge_largest_shear},
    {"principal_stresses", "the same", "of the larger of \\|s1\\|, \\|s2\\|", 4 * EPSILON, "4 eps",
     1, draw_principal, judge_principal},
    {"principal_stresses, angle", "the same", "absolute", 4 * EPSILON, "4 eps", 1, draw_principal,
     judge_angle},
    {"smith_watson_topper", "three loads, often equal or opposite", "of s^2 (1+nu)/E", 1e-14,
     "1e-14", 0.1, draw_smith_watson_topper, judge_plane},
    {"smith_watson_topper_field", "the same, at two points", "of s^2 (1+nu)/E", 1e-14, "1e-14", 0.1,
     draw_smith_watson_topper_field, judge_plane},
    {"fatemi_socie_field", "the same; k/sy", "of (1 + s k/sy) s (1+nu)/E", 1e-14, "1e-14", 0.1,
     draw_fatemi_socie_field, judge_plane},
    {"fatemi_socie", "the same; k/sy", "of (1 + s k/sy) s (1+nu)/E", 1e-14, "1e-14", 0.1,
     draw_fatemi_socie, judge_plane},
    {0},
};
