/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dimensional quantities of one contact. */
#include <float.h>
#include <math.h>

#include "rows/rows.h"
#include "rwedge.h"
#include "references/strength.h"

static double some_unit(probe *call)
{
    return chance(call, 0.05) ? log_between(call, 1e-15, 1e15) : log_between(call, 1e-9, 1e6);
}

static double some_angle(probe *call)
{
    return log_between(call, 1e-9, 1.5707);
}

/* theta, a, A, and A P/(theta a), or A P/theta for the sharp wedge. */
static double some_geometry(probe *call, double v[3])
{
    v[0] = argument(call, "theta", some_angle(call));
    v[1] = argument(call, "a", chance(call, 0.05) ? 0 : some_unit(call));
    v[2] = argument(call, "A", some_unit(call));
    return chance(call, 0.3) ? near(call, 1.5707963267948966) : log_between(call, 1e-10, 1e20);
}

static bool draw_radius(probe *call)
{
    const double theta = argument(call, "theta", some_angle(call)),
                 a = argument(call, "a", some_unit(call));
    call->result[0] = rwedge_radius(theta, a);
    return true;
}

static void judge_radius(arb_t error, const probe *call, slong prec)
{
    arb_t R, theta;
    arb_init(R), arb_init(theta);
    arb_set_d(R, call->value[1]);
    arb_set_d(theta, call->value[0]);
    arb_div(R, R, theta, prec);
    relative_error(error, call->result[0], R, prec);
    arb_clear(R), arb_clear(theta);
}

static bool draw_rounding(probe *call)
{
    const double theta = argument(call, "theta", some_angle(call)),
                 R = argument(call, "R", some_unit(call));
    call->result[0] = rwedge_rounding(theta, R);
    return true;
}

static void judge_rounding(arb_t error, const probe *call, slong prec)
{
    arb_t a, theta;
    arb_init(a), arb_init(theta);
    arb_set_d(a, call->value[1]);
    arb_set_d(theta, call->value[0]);
    arb_mul(a, a, theta, prec);
    relative_error(error, call->result[0], a, prec);
    arb_clear(a), arb_clear(theta);
}

static bool draw_half_width(probe *call)
{
    double v[3];
    const double ratio = some_geometry(call, v);
    const double P = argument(call, "P", ratio * v[0] / v[2] * (v[1] > 0 ? v[1] : some_unit(call)));
    call->result[0] = rwedge_half_width(v[0], v[1], v[2], P);
    return isnormal(P);
}

static void judge_half_width(arb_t error, const probe *call, slong prec)
{
    const double *v = call->value;
    arb_ptr w = _arb_vec_init(4);
    arb_ptr a = w, force = w + 1, u = w + 2, b = w + 3;
    arb_set_d(a, v[1]);
    arb_set_d(force, v[2]);
    arb_set_d(u, v[3]);
    arb_mul(force, force, u, prec);
    arb_set_d(u, v[0]);
    arb_div(force, force, u, prec);
    ball_half_width(b, a, force, call->result[0], prec);
    relative_error(error, call->result[0], b, prec);
    _arb_vec_clear(w, 4);
}

static bool draw_normal_load(probe *call)
{
    double v[3];
    const double ratio = some_geometry(call, v);
    const double b = argument(call, "b", v[1] > 0 ? v[1] * sqrt(ratio) : ratio);
    call->result[0] = rwedge_normal_load(v[0], v[1], v[2], b);
    return true;
}

/* (theta/A) times the force of the half-width b. */
static void ball_normal_load(arb_t P, const double v[3], const arb_t b, slong prec)
{
    arb_t a;
    arb_init(a);
    arb_set_d(a, v[1]);
    ball_force(P, a, b, prec);
    arb_set_d(a, v[0]);
    arb_mul(P, P, a, prec);
    arb_set_d(a, v[2]);
    arb_div(P, P, a, prec);
    arb_clear(a);
}

static void judge_normal_load(arb_t error, const probe *call, slong prec)
{
    arb_t b, P;
    arb_init(b), arb_init(P);
    arb_set_d(b, call->value[3]);
    ball_normal_load(P, call->value, b, prec);
    relative_error(error, call->result[0], P, prec);
    arb_clear(b), arb_clear(P);
}

/* ---- The load at first yield ---- */

/* alpha d/dalpha of J2 at a point below the surface. With q = 2 phi0/(pi alpha), alpha dG/dalpha
 * = -z G' - q/X and alpha d(y G')/dalpha = -y G' - y z G'' + q y z/X^3: what a flat punch adds. */
static void J2_by_alpha_below(arb_t slope, const traction *t, const acb_t z, slong prec)
{
    const ball_patch *patch = &t->patch[0];
    acb_ptr v = _acb_vec_init(10);
    acb_ptr G = v, dG = v + 1, X = v + 2, Ga = v + 3, Ha = v + 4, u = v + 5, D = v + 6, Da = v + 7,
            mu = v + 8, K = v + 9;
    arb_ptr w = _arb_vec_init(3);
    arb_ptr q = w, s = w + 1, sa = w + 2;
    ball_potential(G, patch, z, prec);
    ball_potential_slope(dG, patch, z, prec);
    acb_sub_ui(u, z, 1, prec);
    ball_root(X, u, prec);
    acb_add_ui(u, z, 1, prec);
    ball_root(u, u, prec);
    acb_mul(X, X, u, prec);
    arb_div(q, patch->phi0, t->a, prec);
    arb_mul_2exp_si(q, q, 1);
    arb_const_pi(s, prec);
    arb_div(q, q, s, prec); /* 2 phi0/(pi alpha) */
    /* K = G'' = (2/pi) c0/(X (z^2-alpha^2)) + q/X^3 */
    acb_sub_arb(K, z, t->a, prec);
    acb_add_arb(u, z, t->a, prec);
    acb_mul(K, K, u, prec);
    acb_mul(K, K, X, prec);
    acb_inv(K, K, prec);
    acb_mul_arb(K, K, patch->c0, prec);
    acb_mul_2exp_si(K, K, 1);
    acb_div_arb(K, K, s, prec);
    acb_pow_ui(u, X, 3, prec);
    acb_inv(u, u, prec);
    acb_mul_arb(u, u, q, prec); /* q/X^3 */
    acb_add(K, K, u, prec);
    acb_sub(Ha, u, K, prec);
    acb_mul(Ha, Ha, z, prec);
    acb_sub(Ha, Ha, dG, prec);
    acb_mul_arb(Ha, Ha, acb_imagref(z), prec);
    acb_inv(Ga, X, prec);
    acb_mul_arb(Ga, Ga, q, prec);
    acb_addmul(Ga, z, dG, prec);
    acb_neg(Ga, Ga);
    /* D = f G + mu y G', mu = -1 + i f; s = Im G - f Re G */
    arb_set_si(acb_realref(mu), -1);
    arb_set(acb_imagref(mu), t->f);
    acb_mul_arb(D, dG, acb_imagref(z), prec);
    acb_mul(D, D, mu, prec);
    acb_addmul_arb(D, G, t->f, prec);
    acb_mul(Da, Ha, mu, prec);
    acb_addmul_arb(Da, Ga, t->f, prec);
    arb_set(s, acb_imagref(G));
    arb_submul(s, t->f, acb_realref(G), prec);
    arb_set(sa, acb_imagref(Ga));
    arb_submul(sa, t->f, acb_realref(Ga), prec);
    arb_mul(slope, s, sa, prec);
    arb_mul(slope, slope, t->kappa, prec);
    arb_addmul(slope, acb_realref(D), acb_realref(Da), prec);
    arb_addmul(slope, acb_imagref(D), acb_imagref(Da), prec);
    arb_mul_2exp_si(slope, slope, 1);
    _acb_vec_clear(v, 10);
    _arb_vec_clear(w, 3);
}

/* The same at the surface and for fixed x/alpha, where alpha dp/dalpha is 2 phi0/(pi alpha
 * sqrt(1-x^2)). */
static void J2_by_alpha_at_surface(arb_t slope, const traction *t, const arb_t x, slong prec)
{
    arb_ptr w = _arb_vec_init(5);
    arb_ptr one = w, p = w + 1, s = w + 2, u = w + 3, q = w + 4;
    arb_one(one);
    ball_pressure(p, t->a, one, x, prec);
    ball_angle(q, s, x, one, prec);
    arb_mul(s, s, t->a, prec);
    arb_div(q, t->patch[0].phi0, s, prec);
    arb_const_pi(s, prec);
    arb_div(q, q, s, prec);
    arb_mul_2exp_si(q, q, 2); /* twice for the square */
    arb_div(u, x, t->a, prec);
    arb_mul(u, u, t->f, prec);
    arb_sub(u, p, u, prec);
    arb_mul(u, u, t->kappa, prec);
    arb_mul(slope, t->f, t->f, prec);
    arb_mul(slope, slope, p, prec);
    arb_add(slope, slope, u, prec);
    arb_mul(slope, slope, q, prec);
    _arb_vec_clear(w, 5);
}

/* max sqrt(J2) - A k/theta, and its derivative by alpha < 1. */
static bool excess_of_peak(arb_t value, arb_t slope, const arb_t alpha, const void *context,
                           slong prec)
{
    const probe *call = context;
    const double *v = call->value, *r = call->result;
    arb_ptr w = _arb_vec_init(3);
    arb_ptr f = w, J2 = w + 1, u = w + 2;
    acb_t z;
    traction t;
    acb_init(z);
    arb_set_d(f, v[3]);
    ball_contact(&t, alpha, f, v[4], prec);
    acb_set_d_d(z, r[2], r[3]);
    bool proved;
    if (r[3] > 0) {
        proved = ball_stationary(acb_realref(z), acb_imagref(z), J2, NULL, &t, z, prec);
        J2_by_alpha_below(slope, &t, z, prec);
    } else {
        proved = ball_surface_maximum(acb_realref(z), J2, NULL, &t, r[2], prec);
        J2_by_alpha_at_surface(slope, &t, acb_realref(z), prec);
    }
    arb_div(slope, slope, alpha, prec);
    arb_sqrt(J2, J2, prec);
    arb_div(slope, slope, J2, prec);
    arb_mul_2exp_si(slope, slope, -1);
    arb_set_d(value, v[5]);
    arb_set_d(u, v[0]);
    arb_div(value, value, u, prec);
    arb_set_d(u, v[2]);
    arb_mul(value, value, u, prec);
    arb_sub(value, J2, value, prec);
    traction_clear(&t);
    acb_clear(z);
    _arb_vec_clear(w, 3);
    return proved;
}

/* Whether it yields while the contact is less than 1e14 a wide, by more than rounding. */
static bool yields_at_all(const probe *call)
{
    enum { BITS = 512 };
    static const double WIDEST = 1e-14;
    probe at = {0};
    const double *v = call->value;
    double limit;
    for (int i = 0; i < call->arguments; i++)
        at.value[i] = v[i];
    at.value[5] *= 1 + 1e-13;
    if (rwedge_yield_point(WIDEST, v[3], v[4], &limit, &at.result[2], &at.result[3]) != RWEDGE_OK)
        return true;
    arb_t alpha, excess, slope;
    arb_init(alpha), arb_init(excess), arb_init(slope);
    arb_set_d(alpha, WIDEST);
    const bool yields = excess_of_peak(excess, slope, alpha, &at, BITS) && arb_is_positive(excess);
    arb_clear(alpha), arb_clear(excess), arb_clear(slope);
    return yields;
}

/* The peak of sqrt(J2), in theta/A, from what a tip alpha has, so that all tips come up.
 * result[1] is alpha of the library's load, result[2], result[3] where it yields. */
static bool draw_yield_load(probe *call)
{
    double v[3], *r = call->result;
    some_geometry(call, v);
    const double f = argument(call, "f", chance(call, 0.1) ? some_friction(call) : uniform(call));
    const double nu = argument(call, "nu", some_poisson(call));
    const double tip = log_between(call, 1e-13, 100),
                 peak = rwedge_load(tip) / rwedge_elastic_limit(tip, f, nu);
    const double k = argument(call, "k", v[0] / v[2] * peak);
    if (v[1] == 0)
        return false;
    r[0] = rwedge_yield_load(v[0], v[1], v[2], f, nu, k);
    if (isinf(r[0]) && !yields_at_all(call))
        return false;
    r[1] = v[1] / rwedge_half_width(v[0], v[1], v[2], r[0]);
    double limit;
    if (isinf(r[0]) || rwedge_yield_point(fmin(1, r[1]), f, nu, &limit, &r[2], &r[3]) != RWEDGE_OK)
        r[0] = NAN;
    return true;
}

/* For Hertz the peak is that of alpha = 1 over alpha. */
static bool hertz_alpha(arb_t alpha, const probe *call, slong prec)
{
    arb_ptr w = _arb_vec_init(4);
    arb_ptr excess = w, slope = w + 1, wanted = w + 2, u = w + 3;
    arb_one(alpha);
    const bool proved = excess_of_peak(excess, slope, alpha, call, prec);
    arb_set_d(wanted, call->value[5]);
    arb_set_d(u, call->value[0]);
    arb_div(wanted, wanted, u, prec);
    arb_set_d(u, call->value[2]);
    arb_mul(wanted, wanted, u, prec);
    arb_div(alpha, excess, wanted, prec);
    arb_add_ui(alpha, alpha, 1, prec);
    _arb_vec_clear(w, 4);
    return proved;
}

/* |d ln(alpha)/d ln(k)|, about. */
static double condition_of(const arb_t alpha, const probe *call, slong prec)
{
    const double *v = call->value;
    arb_t value, slope;
    arb_init(value), arb_init(slope);
    double condition = 1;
    if (call->result[1] < 1 && excess_of_peak(value, slope, alpha, call, prec)) {
        arb_mul(slope, slope, alpha, prec);
        condition = fabs(v[5] / v[0] * v[2] / arf_get_d(arb_midref(slope), ARF_RND_NEAR));
    }
    arb_clear(value), arb_clear(slope);
    return condition;
}

static void judge_yield_load(arb_t error, const probe *call, slong prec)
{
    arb_t alpha, P;
    arb_init(alpha), arb_init(P);
    const bool proved = call->result[1] >= 1
                            ? hertz_alpha(alpha, call, prec)
                            : ball_parameter(alpha, call->result[1], excess_of_peak, call, prec);
    if (proved) {
        arb_set_d(P, call->value[1]);
        const double condition = condition_of(alpha, call, prec);
        arb_div(alpha, P, alpha, prec);
        ball_normal_load(P, call->value, alpha, prec);
        relative_error(error, call->result[0], P, prec);
        arb_set_d(P, fmax(1, 1e-4 * condition));
        arb_div(error, error, P, prec);
    } else {
        arb_indeterminate(error);
    }
    arb_clear(alpha), arb_clear(P);
}

#define UNITS "lengths, A 1e-15 to 1e15, all AP/(theta a)"

const row DESIGN_ROWS[] = {
    {"radius", "theta 1e-9 to pi/2; a 1e-15 to 1e15", "relative", DBL_EPSILON, "(1 eps)", 1,
     draw_radius, judge_radius},
    {"rounding", "the same", "relative", DBL_EPSILON, "(1 eps)", 1, draw_rounding, judge_rounding},
    {"half_width", UNITS, "relative", 1e-14, "1e-14", 1, draw_half_width, judge_half_width},
    {"normal_load", UNITS, "relative", 1e-14, "1e-14", 1, draw_normal_load, judge_normal_load},
    {"yield_load", "of tips 1e-13 to 100; f, nu as above", "relative, over max(1, 1e-4 dlnP/dlnk)",
     1e-11, "1e-11", 0.2, draw_yield_load, judge_yield_load},
    {0},
};
