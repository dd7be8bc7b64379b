/* SPDX-License-Identifier: GPL-3.0-or-later */
/* With z = sin(zeta), C = cos(zeta) = -i sqrt(z^2-1), S = sin(zeta+phi0) = c0 z + alpha C, over
 * the half-width, and x >= 0 (the other half follows from G(-conj z) = -conj G(z)):
 *
 *     l  = ln(sin(zeta-phi0)/S) = ln(z-alpha) + ln(z+alpha) - 2 ln S,
 *     G  = 1 + (i/pi) [ 2 ln(S/(C+c0)) - (z-alpha) l/alpha - 2 phi0 C/alpha ],
 *     G' = (i/pi) [ 2 phi0 z/(alpha C) - l/alpha ].
 *
 * S and C + c0 have positive real parts there. Hertz: G = (z-iC)/alpha; sharp wedge: G = (2/(pi
 * i)) ln((iC+i)/z). */
#include "ball_potential.h"

#include <stdbool.h>

/* exp(i pi/4) sqrt(-i z). */
void ball_root(acb_t root, const acb_t z, slong prec)
{
    acb_t turn;
    acb_init(turn);
    acb_onei(turn);
    acb_sqrt(turn, turn, prec);
    acb_div_onei(root, z);
    acb_sqrt(root, root, prec);
    acb_mul(root, root, turn, prec);
    acb_clear(turn);
}

/* ln(-i z) + i pi/2. */
void ball_logarithm(acb_t logarithm, const acb_t z, slong prec)
{
    arb_t quarter;
    arb_init(quarter);
    arb_const_pi(quarter, prec);
    arb_mul_2exp_si(quarter, quarter, -1);
    acb_div_onei(logarithm, z);
    acb_log(logarithm, logarithm, prec);
    arb_add(acb_imagref(logarithm), acb_imagref(logarithm), quarter, prec);
    arb_clear(quarter);
}

/* The disc, as a square, of all numbers of at most the modulus bound. */
static void disc(acb_t z, const arb_t bound)
{
    arb_zero(acb_realref(z));
    arb_add_error(acb_realref(z), bound);
    acb_set_arb(z, acb_realref(z));
    arb_set(acb_imagref(z), acb_realref(z));
}

/* What multiplies a logarithm or 1/C, and whether its modulus stays below the distance from
 * where these are infinite: that of the depth does, and of z - alpha, but not that of 1. */
typedef struct {
    acb_t value;
    bool vanishes;
} factor;

/* by * ln z. Where z may be 0: r (|ln r| + 5) bounds |z ln z| for |z| <= r <= 1/e, as |arg z| <=
 * 3 pi/2. */
static void times_logarithm(acb_t product, const factor *by, const acb_t z, slong prec)
{
    if (!by->vanishes || !acb_contains_zero(z)) {
        acb_t logarithm;
        acb_init(logarithm);
        ball_logarithm(logarithm, z, prec);
        acb_mul(product, by->value, logarithm, prec);
        acb_clear(logarithm);
        return;
    }
    arb_t r, bound;
    arb_init(r), arb_init(bound);
    acb_get_abs_ubound_arf(arb_midref(r), z, prec);
    if (arb_is_zero(r)) {
        acb_zero(product);
    } else if (arf_cmp_d(arb_midref(r), 0.36) > 0) {
        acb_indeterminate(product);
    } else {
        arb_log(bound, r, prec);
        arb_sub_ui(bound, bound, 5, prec);
        arb_neg(bound, bound);
        arb_mul(bound, bound, r, prec);
        disc(product, bound);
    }
    arb_clear(r), arb_clear(bound);
}

void ball_patch_init(ball_patch *patch, const arb_t a, const arb_t c, slong prec)
{
    arb_init(patch->half_width), arb_init(patch->alpha), arb_init(patch->c0), arb_init(patch->phi0);
    arb_set(patch->half_width, c);
    arb_div(patch->alpha, a, c, prec);
    if (arb_ge(a, c)) { /* Hertz */
        arb_const_pi(patch->phi0, prec);
        arb_mul_2exp_si(patch->phi0, patch->phi0, -1);
        return;
    }
    arb_t difference, sum;
    arb_init(difference), arb_init(sum);
    arb_sub(difference, c, a, prec);
    arb_add(sum, c, a, prec);
    arb_mul(sum, sum, difference, prec);
    arb_sqrt(sum, sum, prec);
    arb_div(patch->c0, sum, c, prec);
    arb_atan2(patch->phi0, a, sum, prec);
    arb_clear(difference), arb_clear(sum);
}

void ball_patch_clear(ball_patch *patch)
{
    arb_clear(patch->half_width), arb_clear(patch->alpha), arb_clear(patch->c0),
        arb_clear(patch->phi0);
}

static bool is_hertz(const ball_patch *patch)
{
    return arb_is_zero(patch->c0);
}

static bool is_sharp(const ball_patch *patch)
{
    return arb_is_zero(patch->alpha);
}

/* A point of the right half over the half-width, and what all formulas are made of. */
typedef struct {
    bool mirrored;
    acb_t z, before, beyond; /* z, z - alpha, z - 1 */
    acb_t per_root;          /* 1/sqrt(z+1) */
    acb_t C;
} place;

static void place_init(place *at, const ball_patch *patch, const acb_t z, slong prec)
{
    acb_t plus;
    acb_init(plus);
    acb_init(at->z), acb_init(at->before), acb_init(at->beyond), acb_init(at->per_root),
        acb_init(at->C);
    acb_div_arb(at->z, z, patch->half_width, prec);
    at->mirrored = arf_sgn(arb_midref(acb_realref(z))) < 0;
    if (at->mirrored)
        arb_neg(acb_realref(at->z), acb_realref(at->z));
    acb_sub_arb(at->before, at->z, patch->alpha, prec);
    acb_sub_ui(at->beyond, at->z, 1, prec);
    acb_add_ui(plus, at->z, 1, prec);
    ball_root(plus, plus, prec);
    ball_root(at->C, at->beyond, prec);
    acb_mul(at->C, at->C, plus, prec);
    acb_div_onei(at->C, at->C);
    acb_inv(at->per_root, plus, prec);
    acb_clear(plus);
}

static void place_clear(place *at)
{
    acb_clear(at->z), acb_clear(at->before), acb_clear(at->beyond), acb_clear(at->per_root),
        acb_clear(at->C);
}

/* ln S. */
static void logarithm_of_S(acb_t result, const ball_patch *patch, const place *at, slong prec)
{
    acb_mul_arb(result, at->z, patch->c0, prec);
    acb_addmul_arb(result, at->C, patch->alpha, prec);
    acb_log(result, result, prec);
}

/* by * l. */
static void times_l(acb_t product, const factor *by, const ball_patch *patch, const place *at,
                    const acb_t ln_S, slong prec)
{
    acb_t rest, plus;
    acb_init(rest), acb_init(plus);
    acb_add_arb(plus, at->z, patch->alpha, prec);
    ball_logarithm(rest, plus, prec);
    acb_submul_ui(rest, ln_S, 2, prec);
    acb_mul(rest, rest, by->value, prec);
    times_logarithm(plus, by, at->before, prec);
    acb_add(product, rest, plus, prec);
    acb_clear(rest), acb_clear(plus);
}

void ball_times_i_over_pi(acb_t z, slong prec)
{
    arb_t pi;
    arb_init(pi);
    arb_const_pi(pi, prec);
    acb_mul_onei(z, z);
    acb_div_arb(z, z, pi, prec);
    arb_clear(pi);
}

static void hertz_potential(acb_t G, const ball_patch *patch, const place *at, slong prec)
{
    acb_mul_onei(G, at->C);
    acb_sub(G, at->z, G, prec);
    acb_div_arb(G, G, patch->alpha, prec);
}

static void sharp_potential(acb_t G, const place *at, slong prec)
{
    acb_t ln_z;
    acb_init(ln_z);
    acb_add_ui(G, at->C, 1, prec); /* its real part is positive */
    acb_log(G, G, prec);
    ball_logarithm(ln_z, at->z, prec);
    acb_sub(G, G, ln_z, prec);
    ball_times_i_over_pi(G, prec);
    acb_mul_si(G, G, -2, prec);
    acb_add_ui(G, G, 1, prec); /* ln i */
    acb_clear(ln_z);
}

static void rounded_potential(acb_t G, const ball_patch *patch, const place *at, slong prec)
{
    acb_t ln_S, term;
    factor before = {.vanishes = true};
    acb_init(ln_S), acb_init(term), acb_init(before.value);
    logarithm_of_S(ln_S, patch, at, prec);
    acb_set(before.value, at->before);
    times_l(G, &before, patch, at, ln_S, prec);
    acb_addmul_arb(G, at->C, patch->phi0, prec);
    acb_addmul_arb(G, at->C, patch->phi0, prec);
    acb_div_arb(G, G, patch->alpha, prec);
    acb_add_arb(term, at->C, patch->c0, prec);
    acb_log(term, term, prec);
    acb_sub(term, ln_S, term, prec);
    acb_mul_2exp_si(term, term, 1);
    acb_sub(G, term, G, prec);
    ball_times_i_over_pi(G, prec);
    acb_add_ui(G, G, 1, prec);
    acb_clear(ln_S), acb_clear(term), acb_clear(before.value);
}

/* by/C. Where z may be 1: |y/sqrt(z-1)| <= sqrt|z-1|. */
static void over_C(acb_t quotient, const factor *by, const place *at, slong prec)
{
    if (!by->vanishes || !acb_contains_zero(at->beyond)) {
        acb_div(quotient, by->value, at->C, prec);
        return;
    }
    arb_t bound;
    arb_init(bound);
    acb_get_abs_ubound_arf(arb_midref(bound), at->beyond, prec);
    arb_sqrt(bound, bound, prec);
    disc(quotient, bound);
    acb_mul(quotient, quotient, at->per_root, prec);
    arb_clear(bound);
}

/* by * G' of the half-width 1. */
static void times_slope(acb_t product, const factor *by, const ball_patch *patch, const place *at,
                        slong prec)
{
    acb_t edge, ln_S;
    acb_init(edge), acb_init(ln_S);
    over_C(edge, by, at, prec);
    if (is_hertz(patch)) { /* G' = (1 + i z/C)/alpha */
        acb_mul(product, edge, at->z, prec);
        acb_mul_onei(product, product);
        acb_add(product, product, by->value, prec);
        acb_div_arb(product, product, patch->alpha, prec);
    } else if (is_sharp(patch)) { /* G' = (2 i/pi)/(z C) */
        acb_div(product, edge, at->z, prec);
        acb_mul_2exp_si(product, product, 1);
        ball_times_i_over_pi(product, prec);
    } else {
        acb_mul(edge, edge, at->z, prec);
        acb_mul_arb(edge, edge, patch->phi0, prec);
        acb_mul_2exp_si(edge, edge, 1);
        logarithm_of_S(ln_S, patch, at, prec);
        times_l(product, by, patch, at, ln_S, prec);
        acb_sub(product, edge, product, prec);
        acb_div_arb(product, product, patch->alpha, prec);
        ball_times_i_over_pi(product, prec);
    }
    acb_clear(edge), acb_clear(ln_S);
}

/* conj; with the sign -1 for G, which is odd, +1 for its derivative. */
static void mirror(acb_t value, int sign)
{
    acb_conj(value, value);
    if (sign < 0)
        acb_neg(value, value);
}

void ball_potential(acb_t G, const ball_patch *patch, const acb_t z, slong prec)
{
    place at;
    place_init(&at, patch, z, prec);
    if (is_hertz(patch))
        hertz_potential(G, patch, &at, prec);
    else if (is_sharp(patch))
        sharp_potential(G, &at, prec);
    else
        rounded_potential(G, patch, &at, prec);
    if (at.mirrored)
        mirror(G, -1);
    place_clear(&at);
}

void ball_potential_slope(acb_t dG, const ball_patch *patch, const acb_t z, slong prec)
{
    place at;
    factor one = {.vanishes = false};
    place_init(&at, patch, z, prec);
    acb_init(one.value);
    acb_one(one.value);
    times_slope(dG, &one, patch, &at, prec);
    acb_div_arb(dG, dG, patch->half_width, prec);
    if (at.mirrored)
        mirror(dG, 1);
    acb_clear(one.value);
    place_clear(&at);
}

void ball_potential_slope_by_depth(acb_t H, const ball_patch *patch, const acb_t z, slong prec)
{
    place at;
    factor depth = {.vanishes = true};
    place_init(&at, patch, z, prec);
    acb_init(depth.value);
    acb_set_arb(depth.value, acb_imagref(at.z));
    times_slope(H, &depth, patch, &at, prec);
    if (at.mirrored)
        mirror(H, 1);
    acb_clear(depth.value);
    place_clear(&at);
}
