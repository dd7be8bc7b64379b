/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "references/strength.h"

#include <math.h>

void ball_contact(traction *t, const arb_t alpha, const arb_t f, double nu, slong prec)
{
    arb_t one;
    arb_init(one);
    arb_one(one);
    traction_init(t, alpha, f, nu, prec);
    traction_add(t, one, one, prec);
    arb_clear(one);
}

/* ---- On the surface, x = alpha sin(psi): J2 = f^2 (u^2 + P^2) + kappa (P + f u)^2, u =
 * sin(psi), P = |p| ---- Next to x = alpha, where P has a vertical tangent, psi gives way to t
 * with cos(psi) = exp(-t). */

typedef struct {
    const traction *t;
    bool at_corner;
} surface;

/* u = sin(psi), v = cos(psi). */
static void sine_and_cosine(arb_t u, arb_t v, const surface *s, const arb_t parameter, slong prec)
{
    if (!s->at_corner) {
        arb_sin_cos(u, v, parameter, prec);
        return;
    }
    arb_neg(v, parameter);
    arb_exp(v, v, prec);
    arb_mul(u, v, v, prec);
    arb_sub_ui(u, u, 1, prec);
    arb_neg(u, u);
    arb_sqrt(u, u, prec);
}

/* (1/2) dJ2/du = f^2 (u - P F) + kappa (P + f u)(f - F) with F = -dP/du = (2/pi) [phi0 x/s +
 * ln((s + c0 u)/v)], s = sqrt(1-x^2), and its derivative by psi, or by t: dpsi = (v/u) dt. */
static void slope_of_J2(arb_ptr value, arb_ptr slope, const arb_t parameter, const void *context,
                        slong prec)
{
    const surface *at = context;
    const traction *t = at->t;
    arb_ptr w = _arb_vec_init(12);
    arb_ptr u = w, v = w + 1, x = w + 2, s = w + 3, one = w + 4, P = w + 5, F = w + 6, r = w + 7,
            q = w + 8, g = w + 9, half_pi = w + 10, dF = w + 11;
    const arb_srcptr alpha = t->a, f = t->f, phi0 = t->patch[0].phi0, c0 = t->patch[0].c0;
    arb_one(one);
    sine_and_cosine(u, v, at, parameter, prec);
    arb_mul(x, alpha, u, prec);
    ball_angle(r, s, x, one, prec);
    ball_pressure(P, alpha, one, x, prec);
    arb_neg(P, P);
    arb_mul(q, c0, u, prec);
    arb_add(q, q, s, prec); /* s + c0 u */
    arb_div(F, q, v, prec);
    arb_log(F, F, prec);
    arb_mul(r, phi0, x, prec);
    arb_div(r, r, s, prec);
    arb_add(F, F, r, prec);
    arb_const_pi(half_pi, prec);
    arb_mul_2exp_si(half_pi, half_pi, -1);
    arb_div(F, F, half_pi, prec);
    arb_mul(g, f, u, prec);
    arb_add(g, g, P, prec); /* P + f u */
    if (value) {
        arb_mul(value, P, F, prec);
        arb_sub(value, u, value, prec);
        arb_mul(value, value, f, prec);
        arb_mul(value, value, f, prec);
        arb_sub(r, f, F, prec);
        arb_mul(r, r, g, prec);
        arb_addmul(value, r, t->kappa, prec);
    }
    if (slope) {
        /* (pi/2) dF/dpsi = phi0 alpha v/s^3 + (c0 v - x alpha v/s)/(s + c0 u) + u/v */
        arb_mul(r, alpha, v, prec);
        arb_mul(dF, s, s, prec);
        arb_mul(dF, dF, s, prec);
        arb_div(dF, phi0, dF, prec);
        arb_mul(dF, dF, r, prec);
        arb_mul(r, r, x, prec);
        arb_div(r, r, s, prec);
        arb_neg(r, r);
        arb_addmul(r, c0, v, prec);
        arb_div(r, r, q, prec);
        arb_add(dF, dF, r, prec);
        arb_div(r, u, v, prec);
        arb_add(dF, dF, r, prec);
        arb_div(dF, dF, half_pi, prec);
        /* f^2 (v + F^2 v - P dF) + kappa [(f - F)^2 v - (P + f u) dF] */
        arb_mul(q, F, F, prec);
        arb_add_ui(q, q, 1, prec);
        arb_mul(q, q, v, prec);
        arb_submul(q, P, dF, prec);
        arb_mul(q, q, f, prec);
        arb_mul(slope, q, f, prec);
        arb_sub(q, f, F, prec);
        arb_mul(q, q, q, prec);
        arb_mul(q, q, v, prec);
        arb_submul(q, g, dF, prec);
        arb_addmul(slope, q, t->kappa, prec);
        if (at->at_corner) {
            arb_mul(slope, slope, v, prec);
            arb_div(slope, slope, u, prec);
        }
    }
    _arb_vec_clear(w, 12);
}

/* J2 with the slope u and the pressure at x = alpha at: at u = sin(psi) both are the same. */
static void surface_J2(arb_t J2, const traction *t, const arb_t u, const arb_t at, slong prec)
{
    arb_ptr w = _arb_vec_init(3);
    arb_ptr x = w, one = w + 1, P = w + 2;
    arb_one(one);
    arb_mul(x, t->a, at, prec);
    ball_pressure(P, t->a, one, x, prec);
    arb_neg(P, P);
    arb_mul(x, u, u, prec);
    arb_addmul(x, P, P, prec);
    arb_mul(x, x, t->f, prec);
    arb_mul(J2, x, t->f, prec);
    arb_addmul(P, t->f, u, prec);
    arb_mul(P, P, P, prec);
    arb_addmul(J2, P, t->kappa, prec);
    _arb_vec_clear(w, 3);
}

/* Hertz: f^2 + kappa (1 + f^2) at x = f/sqrt(1+f^2). */
static void hertz_surface(arb_t x, arb_t J2, const traction *t, slong prec)
{
    arb_mul(J2, t->f, t->f, prec);
    arb_add_ui(x, J2, 1, prec);
    arb_addmul(J2, x, t->kappa, prec);
    arb_rsqrt(x, x, prec);
    arb_mul(x, x, t->f, prec);
}

/* The parameter of a place, psi or t. Where x is alpha to rounding, a parameter that is far on the
 * way there. */
static void parameter_of(arb_t parameter, surface *at, double x, slong prec)
{
    arb_set_d(parameter, x);
    arb_div(parameter, parameter, at->t->a, prec);
    const double sine = arf_get_d(arb_midref(parameter), ARF_RND_NEAR);
    at->at_corner = sine > 0.9;
    if (!at->at_corner)
        arb_asin(parameter, parameter, prec);
    else
        arb_set_d(parameter, -0.5 * log(fmax((1 - sine) * (1 + sine), 1e-16)));
}

/* From anywhere: the slope of J2 falls through its zero; t is halved in its logarithm, up to
 * where x is alpha to half of the bits. False where the slope is still positive there. */
static bool search(arb_t parameter, surface *at, slong prec)
{
    arb_t slope;
    arb_init(slope);
    double low = -40, high = log((double)prec / 4);
    at->at_corner = true;
    for (int i = 0; i < 60; i++) {
        const double middle = i == 0 ? high : (low + high) / 2;
        arb_set_d(parameter, exp(middle));
        slope_of_J2(slope, NULL, parameter, at, prec);
        if (arf_sgn(arb_midref(slope)) <= 0)
            high = middle;
        else if (i == 0)
            break;
        else
            low = middle;
    }
    const bool found = arf_sgn(arb_midref(slope)) <= 0 || low > -40;
    arb_clear(slope);
    if (found && high < log(0.5)) {
        at->at_corner = false;
        arb_set_d(parameter, high > -30 ? sqrt(2 * exp(high)) : 0);
    }
    return found;
}

/* The maximum is beyond the parameter, whose slope is positive: u rises and P falls from there
 * to x = alpha. */
static bool beyond(arb_t u, arb_t J2, const surface *at, const arb_t parameter, slong prec)
{
    arb_ptr w = _arb_vec_init(3);
    arb_ptr slope = w, one = w + 1, corner = w + 2;
    slope_of_J2(slope, NULL, parameter, at, prec);
    const bool rises = arb_is_positive(slope);
    arb_one(one);
    sine_and_cosine(u, slope, at, parameter, prec);
    surface_J2(J2, at->t, u, one, prec);
    surface_J2(corner, at->t, one, u, prec);
    arb_union(J2, J2, corner, prec);
    arb_union(u, u, one, prec);
    _arb_vec_clear(w, 3);
    return rises;
}

/* The curvature of J2 over J2: 2 slope' cos(psi) by psi, and cos(psi) = u where the parameter is
 * t, dpsi/dt = cos/u. */
static double curvature(const surface *at, const arb_t parameter, const arb_t J2, slong prec)
{
    arb_ptr w = _arb_vec_init(3);
    slope_of_J2(NULL, w, parameter, at, prec);
    sine_and_cosine(w + 1, w + 2, at, parameter, prec);
    arb_mul(w, w, at->at_corner ? w + 1 : w + 2, prec);
    arb_div(w, w, J2, prec);
    const double result = 2 * fabs(arf_get_d(arb_midref(w), ARF_RND_NEAR));
    _arb_vec_clear(w, 3);
    return result;
}

bool ball_surface_maximum(arb_t x, arb_t J2, double *flatness, const traction *t, double guess,
                          slong prec)
{
    if (flatness)
        *flatness = 1;
    if (arb_is_zero(t->patch[0].c0)) {
        hertz_surface(x, J2, t, prec);
        return true;
    }
    arb_t parameter, u;
    arb_init(parameter), arb_init(u);
    surface at = {.t = t};
    bool proved = true;
    if (!arb_is_zero(t->f)) {
        parameter_of(parameter, &at, guess, prec);
        proved = ball_zero(u, parameter, 1, slope_of_J2, &at, prec);
        const bool found = proved || search(parameter, &at, prec);
        if (!proved && found)
            proved = ball_zero(u, parameter, 1, slope_of_J2, &at, prec);
        if (!found) {
            proved = beyond(u, J2, &at, parameter, prec);
        } else {
            arb_set(parameter, u);
            sine_and_cosine(u, x, &at, parameter, prec);
            surface_J2(J2, t, u, u, prec);
            if (flatness)
                *flatness = curvature(&at, parameter, J2, prec);
        }
    } else {
        surface_J2(J2, t, u, u, prec);
    }
    arb_mul(x, t->a, u, prec);
    arb_clear(parameter), arb_clear(u);
    return proved;
}

void ball_limit(arb_t limit, const arb_t alpha, const arb_t J2, slong prec)
{
    arb_t one;
    arb_init(one);
    arb_one(one);
    arb_rsqrt(limit, J2, prec);
    ball_force(one, alpha, one, prec);
    arb_mul(limit, limit, one, prec);
    arb_clear(one);
}

/* Newton, the last step with the derivative over a whole neighbourhood. */
bool ball_parameter(arb_t parameter, double guess, ball_balance balance, const void *context,
                    slong prec)
{
    arb_ptr w = _arb_vec_init(5);
    arb_ptr value = w, slope = w + 1, ignored = w + 2, ball = w + 3, width = w + 4;
    bool proved = true;
    arb_set_d(parameter, guess);
    for (int step = 0; step < 6 && proved; step++) {
        proved = balance(value, slope, parameter, context, prec);
        arb_div(value, value, slope, prec);
        arb_sub(parameter, parameter, value, prec);
        arb_get_mid_arb(parameter, parameter);
        if (arf_is_zero(arb_midref(value)) ||
            ARF_EXP(arb_midref(value)) < ARF_EXP(arb_midref(parameter)) - prec / 3)
            break;
    }
    proved = proved && balance(value, slope, parameter, context, prec);
    bool enclosed = false;
    for (slong bits = prec / 3; proved && !enclosed && bits > 8; bits -= prec / 16) {
        arb_mul_2exp_si(width, parameter, -bits);
        arb_set(ball, parameter);
        arb_add_error(ball, width);
        enclosed = balance(ignored, slope, ball, context, prec);
        arb_div(slope, value, slope, prec);
        arb_abs(ignored, slope);
        enclosed = enclosed && arb_lt(ignored, width);
    }
    arb_sub(parameter, parameter, slope, prec);
    _arb_vec_clear(w, 5);
    return enclosed;
}
