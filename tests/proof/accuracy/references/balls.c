/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "references/balls.h"

#include <math.h>

void ball_angle(arb_t phi0, arb_t c0, const arb_t a, const arb_t b, slong prec)
{
    arb_t alpha, one;
    arb_init(alpha), arb_init(one);
    arb_one(one);
    arb_div(alpha, a, b, prec);
    arb_min(alpha, alpha, one, prec);
    /* a ball of numbers below 1 may be rounded to one that contains more */
    arb_sub(c0, one, alpha, prec);
    arb_add(one, one, alpha, prec);
    arb_mul(c0, c0, one, prec);
    arb_sqrtpos(c0, c0, prec);
    arb_atan2(phi0, alpha, c0, prec);
    arb_clear(alpha), arb_clear(one);
}

void ball_force(arb_t force, const arb_t a, const arb_t b, slong prec)
{
    if (arb_is_zero(a)) {
        arb_mul_2exp_si(force, b, 1);
        return;
    }
    arb_t phi0, c0, alpha;
    arb_init(phi0), arb_init(c0), arb_init(alpha);
    ball_angle(phi0, c0, a, b, prec);
    arb_div(alpha, a, b, prec);
    arb_div(phi0, phi0, alpha, prec);
    arb_add(phi0, phi0, c0, prec); /* for alpha > 1 c0 is 0 */
    arb_mul(force, phi0, b, prec);
    arb_clear(phi0), arb_clear(c0), arb_clear(alpha);
}

void ball_force_slope(arb_t slope, const arb_t a, const arb_t b, slong prec)
{
    if (arb_is_zero(a)) {
        arb_set_ui(slope, 2);
        return;
    }
    arb_t c0;
    arb_init(c0);
    ball_angle(slope, c0, a, b, prec);
    arb_mul(slope, slope, b, prec);
    arb_div(slope, slope, a, prec);
    arb_mul_2exp_si(slope, slope, 1);
    arb_clear(c0);
}

typedef struct {
    arb_srcptr a, force;
} pressing;

static void force_too_much(arb_ptr value, arb_ptr slope, const arb_t b, const void *context,
                           slong prec)
{
    const pressing *c = context;
    if (value) {
        ball_force(value, c->a, b, prec);
        arb_sub(value, value, c->force, prec);
    }
    if (slope)
        ball_force_slope(slope, c->a, b, prec);
}

void ball_half_width(arb_t b, const arb_t a, const arb_t force, double guess, slong prec)
{
    const pressing c = {a, force};
    arb_t start;
    arb_init(start);
    arb_set_d(start, guess);
    if (!ball_zero(b, start, guess, force_too_much, &c, prec))
        arb_indeterminate(b);
    arb_clear(start);
}

/* Eq. (14): -(2/pi) arcosh(c/x). */
static void sharp_pressure(arb_t p, const arb_t c, const arb_t x, slong prec)
{
    arb_div(p, c, x, prec);
    arb_acosh(p, p, prec);
    arb_mul_si(p, p, -2, prec);
}

/* Eq. (8) over 1/pi in the algebraic form of its sines: with s = cos(phi), over c,
 * 2 ln((c0 x + a s)/(c0 + s)) + ((x - a)/a) ln((c0 x + a s)^2/|a^2 - x^2|) - 2 phi0 s/a. */
static void rounded_pressure(arb_t p, const arb_t a, const arb_t c, const arb_t x, slong prec)
{
    arb_ptr t = _arb_vec_init(7);
    arb_ptr phi0 = t, c0 = t + 1, s = t + 2, S = t + 3, u = t + 4, v = t + 5, L = t + 6;
    ball_angle(phi0, c0, a, c, prec);
    ball_angle(u, s, x, c, prec);
    arb_mul(S, c0, x, prec);
    arb_addmul(S, a, s, prec); /* times c */
    arb_add(u, c0, s, prec);
    arb_mul(u, u, c, prec);
    arb_div(u, S, u, prec);
    arb_log(p, u, prec);
    arb_mul_2exp_si(p, p, 1);
    arb_sub(u, x, a, prec);
    if (!arb_is_zero(u)) {
        arb_add(v, x, a, prec);
        arb_mul(v, v, u, prec);
        arb_abs(v, v);
        arb_mul(S, S, S, prec);
        arb_div(v, S, v, prec);
        arb_log(L, v, prec);
        arb_div(u, u, a, prec);
        arb_addmul(p, u, L, prec);
    }
    arb_mul(u, phi0, s, prec);
    arb_mul(u, u, c, prec);
    arb_div(u, u, a, prec);
    arb_mul_2exp_si(u, u, 1);
    arb_sub(p, p, u, prec);
    _arb_vec_clear(t, 7);
}

/* Eq. (12): -sqrt(c^2-x^2)/a. */
static void hertz_pressure(arb_t p, const arb_t a, const arb_t c, const arb_t x, slong prec)
{
    arb_t below, above;
    arb_init(below), arb_init(above);
    arb_sub(below, c, x, prec);
    arb_add(above, c, x, prec);
    arb_mul(p, below, above, prec);
    arb_sqrt(p, p, prec);
    arb_div(p, p, a, prec);
    arb_neg(p, p);
    arb_clear(below), arb_clear(above);
}

void ball_pressure(arb_t p, const arb_t a, const arb_t c, const arb_t x, slong prec)
{
    arb_t right;
    arb_init(right);
    arb_abs(right, x);
    if (arb_ge(right, c)) {
        arb_zero(p);
    } else if (!arb_lt(right, c)) {
        arb_indeterminate(p);
    } else if (arb_ge(a, c)) {
        hertz_pressure(p, a, c, right, prec);
    } else {
        if (arb_is_zero(a))
            sharp_pressure(p, c, right, prec);
        else
            rounded_pressure(p, a, c, right, prec);
        arb_const_pi(right, prec);
        arb_div(p, p, right, prec);
    }
    arb_clear(right);
}

/* guess - f(guess)/f'(neighbourhood), where it lies inside the neighbourhood. */
static bool newton(arb_t zero, const arb_t neighbourhood, ball_function function,
                   const void *context, slong prec)
{
    arb_t middle, value, slope;
    arb_init(middle), arb_init(value), arb_init(slope);
    arb_get_mid_arb(middle, neighbourhood);
    function(value, NULL, middle, context, prec);
    function(NULL, slope, neighbourhood, context, prec);
    arb_div(value, value, slope, prec);
    arb_sub(zero, middle, value, prec);
    const bool proved = arb_contains(neighbourhood, zero);
    arb_clear(middle), arb_clear(value), arb_clear(slope);
    return proved;
}

/* Newton's method without proof: a guess to about the square root of the precision. */
static void improve(arb_t guess, ball_function function, const void *context, slong prec)
{
    arb_t value, slope;
    arb_init(value), arb_init(slope);
    arb_get_mid_arb(guess, guess);
    for (int step = 0; step < 12; step++) {
        function(value, slope, guess, context, prec);
        arb_div(value, value, slope, prec);
        if (!arb_is_finite(value))
            break;
        arb_get_mid_arb(value, value);
        arb_sub(guess, guess, value, prec);
        arb_get_mid_arb(guess, guess);
        if (arf_is_zero(arb_midref(value)) ||
            (arf_cmpabs(arb_midref(value), arb_midref(guess)) < 0 &&
             ARF_EXP(arb_midref(value)) < ARF_EXP(arb_midref(guess)) - prec / 2))
            break;
    }
    arb_clear(value), arb_clear(slope);
}

bool ball_zero(arb_t zero, const arb_t guess, double width, ball_function function,
               const void *context, slong prec)
{
    arb_t neighbourhood, centre;
    arb_init(neighbourhood), arb_init(centre);
    arb_set(centre, guess);
    improve(centre, function, context, prec);
    bool proved = false;
    for (slong bits = prec / 2; bits > 0 && !proved; bits -= prec / 8) {
        arb_set(neighbourhood, centre);
        mag_set_d(arb_radref(neighbourhood), width);
        mag_mul_2exp_si(arb_radref(neighbourhood), arb_radref(neighbourhood), -bits);
        proved = newton(zero, neighbourhood, function, context, prec);
    }
    arb_clear(neighbourhood), arb_clear(centre);
    return proved;
}
