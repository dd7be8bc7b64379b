/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Materials, contact law, pressure, coefficients of the series. */
#include <float.h>
#include <math.h>

#include "rows/rows.h"
#include "rwedge.h"

static const double EPSILON = DBL_EPSILON;

/* ---- Materials ---- */

static double some_modulus(probe *call)
{
    return chance(call, 0.05)  ? HUGE_VAL
           : chance(call, 0.1) ? log_between(call, 1e-29, 1e29)
                               : log_between(call, 1, 1e6);
}

static double some_ratio(probe *call)
{
    const double kind = uniform(call);
    return kind < 0.6   ? between(call, -1, 0.5)
           : kind < 0.7 ? -1 + log_between(call, 1e-16, 1)
           : kind < 0.9 ? 0.5 - log_between(call, 1e-16, 0.5)
                        : 0.5 * (int)(between(call, 0, 2));
}

static void some_bodies(probe *call, double v[4])
{
    const double same = uniform(call);
    v[0] = argument(call, "E1", some_modulus(call));
    v[1] = argument(call, "nu1", some_ratio(call));
    v[2] =
        argument(call, "E2", same < 0.2 && isfinite(v[0]) ? near(call, v[0]) : some_modulus(call));
    v[3] = argument(call, "nu2", same < 0.1 ? v[1] : some_ratio(call));
}

/* The domain of both functions; all that is drawn has an A in its domain. */
static bool is_compliant(const double v[4])
{
    return v[0] > 0 && v[2] > 0 && v[1] > -1 && v[3] > -1 && !(isinf(v[0]) && isinf(v[2]));
}

/* 2(1-nu^2)/E. */
static void ball_share(arb_t share, double E, double nu, slong prec)
{
    if (isinf(E)) {
        arb_zero(share);
        return;
    }
    arb_t v;
    arb_init(v);
    arb_set_d(v, nu);
    arb_mul(v, v, v, ARF_PREC_EXACT);
    arb_sub_ui(v, v, 1, ARF_PREC_EXACT);
    arb_mul_si(v, v, -2, ARF_PREC_EXACT);
    arb_set_d(share, E);
    arb_div(share, v, share, prec);
    arb_clear(v);
}

static bool draw_compliance(probe *call)
{
    double v[4];
    some_bodies(call, v);
    call->result[0] = rwedge_compliance(v[0], v[1], v[2], v[3]);
    return is_compliant(v);
}

static void judge_compliance(arb_t error, const probe *call, slong prec)
{
    const double *v = call->value;
    arb_t A, share;
    arb_init(A), arb_init(share);
    ball_share(A, v[0], v[1], prec);
    ball_share(share, v[2], v[3], prec);
    arb_add(A, A, share, prec);
    relative_error(error, call->result[0], A, prec);
    arb_clear(A), arb_clear(share);
}

static bool draw_beta(probe *call)
{
    double v[4];
    some_bodies(call, v);
    call->result[0] = rwedge_dundurs_beta(v[0], v[1], v[2], v[3]);
    return is_compliant(v);
}

/* beta = (l2 s2 - l1 s1)/(s1 + s2), l = (1-2nu)/(2(1-nu)), as Dundurs' own form with the moduli
 * mu = E/(2(1+nu)) and kappa = 3 - 4 nu: mu (kappa -+ 1) of the other body, times 1/(mu1 mu2). */
static void judge_beta(arb_t error, const probe *call, slong prec)
{
    arb_ptr t = _arb_vec_init(7);
    arb_ptr above = t, below = t + 1, nu = t + 2, per_mu = t + 3, E = t + 4, kappa = t + 5;
    for (int body = 0; body < 2; body++) {
        const double *v = call->value + 2 * body;
        if (isinf(v[0]))
            continue;
        arb_set_d(E, v[0]);
        arb_set_d(nu, v[1]);
        arb_add_ui(per_mu, nu, 1, ARF_PREC_EXACT);
        arb_mul_2exp_si(per_mu, per_mu, 1);
        arb_div(per_mu, per_mu, E, prec);
        arb_mul_si(kappa, nu, -4, ARF_PREC_EXACT);
        arb_add_ui(kappa, kappa, 3, ARF_PREC_EXACT);
        arb_add_ui(E, kappa, 1, ARF_PREC_EXACT);
        arb_addmul(below, per_mu, E, prec);
        arb_sub_ui(E, kappa, 1, ARF_PREC_EXACT);
        if (body == 0)
            arb_submul(above, per_mu, E, prec);
        else
            arb_addmul(above, per_mu, E, prec);
    }
    arb_div(above, above, below, prec);
    arb_one(nu);
    error_over(error, call->result[0], above, nu, prec);
    _arb_vec_clear(t, 7);
}

/* ---- Contact law ---- */

static void ball_load(arb_t load, double alpha, slong prec)
{
    arb_t a, one;
    arb_init(a), arb_init(one);
    arb_set_d(a, alpha);
    arb_one(one);
    ball_force(load, a, one, prec);
    arb_clear(a), arb_clear(one);
}

static bool draw_load(probe *call)
{
    call->result[0] = rwedge_load(argument(call, "alpha", some_alpha(call)));
    return true;
}

static void judge_load(arb_t error, const probe *call, slong prec)
{
    arb_t load;
    arb_init(load);
    ball_load(load, call->value[0], prec);
    relative_error(error, call->result[0], load, prec);
    arb_clear(load);
}

static bool draw_a_over_b(probe *call)
{
    const double hertz = 1.5707963267948966, kind = uniform(call);
    const double load = kind < 0.3    ? near(call, hertz)
                        : kind < 0.6  ? hertz * log_between(call, 1, 100)
                        : kind < 0.8  ? log_between(call, 1, 1e17)
                        : kind < 0.9  ? log_between(call, 1e-10, hertz)
                        : kind < 0.95 ? near(call, 2e8)
                                      : log_between(call, 1e-119, 1e60);
    call->result[0] = rwedge_a_over_b(argument(call, "AP_over_theta_a", load));
    return true;
}

/* b/a, the half-width for a = 1, is what is enclosed. */
static void judge_a_over_b(arb_t error, const probe *call, slong prec)
{
    arb_t one, force, b;
    arb_init(one), arb_init(force), arb_init(b);
    arb_one(one);
    arb_set_d(force, call->value[0]);
    ball_half_width(b, one, force, 1 / call->result[0], prec);
    arb_inv(b, b, prec);
    relative_error(error, call->result[0], b, prec);
    arb_clear(one), arb_clear(force), arb_clear(b);
}

/* ---- Pressure ---- */

static bool draw_pressure(probe *call)
{
    const double alpha = argument(call, "alpha", some_alpha(call)),
                 x = argument(call, "x", some_place(call, alpha, 1));
    call->result[0] = rwedge_pressure(alpha, x);
    return alpha > 0 || x != 0;
}

static void judge_pressure(arb_t error, const probe *call, slong prec)
{
    arb_ptr t = _arb_vec_init(4);
    arb_set_d(t, call->value[0]);
    arb_one(t + 1);
    arb_set_d(t + 2, call->value[1]);
    ball_pressure(t + 3, t, t + 1, t + 2, prec);
    relative_error(error, call->result[0], t + 3, prec);
    _arb_vec_clear(t, 4);
}

static bool draw_peak(probe *call)
{
    call->result[0] = rwedge_peak_pressure(argument(call, "alpha", some_rounded_alpha(call)));
    return true;
}

/* Eq. (10): (2/pi) [phi0/alpha - ln tan(phi0/2)]. */
static void judge_peak(arb_t error, const probe *call, slong prec)
{
    arb_ptr t = _arb_vec_init(5);
    arb_ptr a = t, one = t + 1, phi0 = t + 2, p = t + 3;
    arb_set_d(a, call->value[0]);
    arb_one(one);
    ball_angle(phi0, p, a, one, prec);
    arb_div(p, phi0, a, prec);
    if (call->value[0] < 1) {
        arb_mul_2exp_si(phi0, phi0, -1);
        arb_tan(phi0, phi0, prec);
        arb_log(phi0, phi0, prec);
        arb_sub(p, p, phi0, prec);
    }
    arb_const_pi(one, prec);
    arb_div(p, p, one, prec);
    arb_mul_2exp_si(p, p, 1);
    relative_error(error, call->result[0], p, prec);
    _arb_vec_clear(t, 5);
}

static bool draw_transition(probe *call)
{
    call->result[0] = rwedge_transition_pressure(argument(call, "alpha", some_rounded_alpha(call)));
    return true;
}

/* Eq. (9): (1/pi) [2 phi0 cot(phi0) - ln(tan(phi0) sin(2 phi0)/2)]. */
static void judge_transition(arb_t error, const probe *call, slong prec)
{
    arb_ptr t = _arb_vec_init(6);
    arb_ptr a = t, one = t + 1, phi0 = t + 2, p = t + 3, u = t + 4;
    arb_set_d(a, call->value[0]);
    arb_one(one);
    ball_angle(phi0, p, a, one, prec);
    if (call->value[0] < 1) {
        arb_cot(p, phi0, prec);
        arb_mul(p, p, phi0, prec);
        arb_mul_2exp_si(p, p, 1);
        arb_mul_2exp_si(u, phi0, 1);
        arb_sin(u, u, prec);
        arb_tan(phi0, phi0, prec);
        arb_mul(u, u, phi0, prec);
        arb_mul_2exp_si(u, u, -1);
        arb_log(u, u, prec);
        arb_sub(p, p, u, prec);
        arb_const_pi(u, prec);
        arb_div(p, p, u, prec);
    } else {
        arb_zero(p);
    }
    relative_error(error, call->result[0], p, prec);
    _arb_vec_clear(t, 6);
}

/* ---- Coefficients ---- */

/* pi b_n m (m^2-1)/4 = (-1)^n [m sin(m phi0) cot(phi0) - cos(m phi0)], and its derivative by
 * phi0. */
static void ball_bracket(arb_t bracket, arb_t slope, const arb_t phi0, ulong m, slong prec)
{
    arb_ptr t = _arb_vec_init(5);
    arb_ptr sine = t, cosine = t + 1, cot = t + 2, u = t + 3, v = t + 4;
    arb_mul_ui(u, phi0, m, prec);
    arb_sin_cos(sine, cosine, u, prec);
    arb_cot(cot, phi0, prec);
    arb_mul(u, sine, cot, prec);
    arb_mul_ui(u, u, m, prec);
    arb_sub(bracket, u, cosine, prec);
    arb_mul(u, cosine, cot, prec); /* m^2 cos cot - m sin/sin(phi0)^2 + m sin */
    arb_mul_ui(u, u, m, prec);
    arb_mul(v, cot, cot, prec);
    arb_submul(u, v, sine, prec);
    arb_mul_ui(slope, u, m, prec);
    if (m / 2 % 2 == 1)
        arb_neg(bracket, bracket);
    _arb_vec_clear(t, 5);
}

static bool draw_coefficient(probe *call)
{
    const double alpha = argument(call, "alpha", some_alpha(call));
    const double kind = uniform(call);
    const double n = argument(
        call, "n", floor(kind < 0.4 ? between(call, 0, 20) : log_between(call, 1, 2147483647.0)));
    call->result[0] = rwedge_coefficient(alpha, (int32_t)n);
    return true;
}

/* Within 1e-9 of a zero, the zero at alpha = 1 not counted, the error is taken of the values
 * around, sqrt(1 + (m cot)^2) of the bracket, 1e8 times smaller, as the promise there is: 1e-22
 * for 1e-14. */
static void widen_next_to_zero(arb_t scale, const arb_t bracket, const arb_t slope,
                               const arb_t phi0, ulong m, slong prec)
{
    arb_ptr t = _arb_vec_init(3);
    /* d ln(alpha) = cot(phi0) d phi0: the zero is at the relative distance bracket/(tan slope) */
    arb_tan(t, phi0, prec);
    arb_mul(t + 1, t, slope, prec);
    arb_div(t + 1, bracket, t + 1, prec);
    arb_abs(t + 1, t + 1);
    const double distance = arf_get_d(arb_midref(t + 1), ARF_RND_NEAR);
    if (distance < 1e-9 && arf_cmp_d(arb_midref(t), 1e6) < 0) {
        arb_ui_div(t, m, t, prec);
        arb_mul(t, t, t, prec);
        arb_add_ui(t, t, 1, prec);
        arb_sqrt(t, t, prec);
        arb_set_d(t + 1, 1e-8);
        arb_mul(t, t, t + 1, prec);
        arb_max(scale, scale, t, prec);
    }
    _arb_vec_clear(t, 3);
}

static void judge_coefficient(arb_t error, const probe *call, slong prec)
{
    const double alpha = call->value[0];
    const ulong m = 2 * (ulong)call->value[1] + 1;
    arb_ptr t = _arb_vec_init(6);
    arb_ptr phi0 = t, b = t + 1, slope = t + 2, scale = t + 3, u = t + 4, factor = t + 5;
    arb_const_pi(u, prec);
    arb_ui_div(factor, 4, u, prec);
    if (m == 1) { /* (2/pi) load */
        ball_load(b, alpha, prec);
        arb_mul(b, b, factor, prec);
        arb_mul_2exp_si(b, b, -1);
        relative_error(error, call->result[0], b, prec);
    } else if (alpha >= 1) {
        relative_error(error, call->result[0], b, prec);
    } else if (alpha == 0) {
        arb_div_ui(b, factor, m, prec);
        if (m / 2 % 2 == 1)
            arb_neg(b, b);
        relative_error(error, call->result[0], b, prec);
    } else {
        arb_set_d(u, alpha);
        arb_asin(phi0, u, prec);
        ball_bracket(b, slope, phi0, m, prec);
        arb_abs(scale, b);
        widen_next_to_zero(scale, b, slope, phi0, m, prec);
        arb_div_ui(factor, factor, m, prec);
        arb_div_ui(factor, factor, m - 1, prec);
        arb_div_ui(factor, factor, m + 1, prec);
        arb_mul(b, b, factor, prec);
        arb_mul(scale, scale, factor, prec);
        error_over(error, call->result[0], b, scale, prec);
    }
    _arb_vec_clear(t, 6);
}

#define ALPHA "0, 1e-60 to 1e60; dense at 1"

const row LAW_ROWS[] = {
    {"compliance", "E 1e-29 to 1e29, rigid; nu -1 to 0.5", "relative", 4 * EPSILON, "4 eps", 1,
     draw_compliance, judge_compliance},
    {"dundurs_beta", "the same", "absolute", 4 * EPSILON, "4 eps", 1, draw_beta, judge_beta},
    {"load", ALPHA, "relative", 4 * EPSILON, "4 eps", 1, draw_load, judge_load},
    {"a_over_b", "1e-119 to 1e60; dense at pi/2, 2e8", "relative", 1e-14, "1e-14", 1, draw_a_over_b,
     judge_a_over_b},
    {"pressure", "alpha; x dense at 0, ±alpha, ±1", "relative", 1e-12, "1e-12", 1, draw_pressure,
     judge_pressure},
    {"peak_pressure", ALPHA, "relative", 1e-14, "1e-14", 1, draw_peak, judge_peak},
    {"transition_pressure", ALPHA, "relative", 1e-14, "1e-14", 1, draw_transition,
     judge_transition},
    {"coefficient", "alpha; n 0 to 2^31-1", "relative; at zeros 1e-8 of values around", 1e-14,
     "1e-14", 1, draw_coefficient, judge_coefficient},
    {0},
};
