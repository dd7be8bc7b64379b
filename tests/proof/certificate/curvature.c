/* SPDX-License-Identifier: GPL-3.0-or-later */
/* With q = z^2-alpha^2, X^2 = z^2-1 and the two parts A = c0/(X q), B = phi0/(alpha X^3) of
 *
 *     G'' = (2/pi) (A + B),     A'/A = -z (1/X^2 + 2/q),     B'/B = -3 z/X^2,
 *
 * all derivatives are algebraic. */
#include "curvature.h"

void curvature_init(curvature *k)
{
    acb_init(k->second), acb_init(k->third), acb_init(k->fourth);
}

void curvature_clear(curvature *k)
{
    acb_clear(k->second), acb_clear(k->third), acb_clear(k->fourth);
}

/* Adds to k the part A of G'' and its derivatives, A' = -z r A and A'' = (z^2 r^2 - r + 2 z^2 t)
 * A, where r and t are the same combination of 1/X^2, 1/q and of their squares: r' = -2 z t. */
static void add_part(curvature *k, const acb_t A, const acb_t z, const acb_t r, const acb_t t,
                     slong prec)
{
    acb_t z2, term;
    acb_init(z2), acb_init(term);
    acb_add(k->second, k->second, A, prec);
    acb_mul(term, z, r, prec);
    acb_submul(k->third, term, A, prec);
    acb_mul(z2, z, z, prec);
    acb_mul_2exp_si(term, t, 1);
    acb_addmul(term, r, r, prec);
    acb_mul(term, term, z2, prec);
    acb_sub(term, term, r, prec);
    acb_addmul(k->fourth, term, A, prec);
    acb_clear(z2), acb_clear(term);
}

/* B, of the edges ±1. */
static void add_edges(curvature *k, const ball_patch *patch, const acb_t z, const acb_t per_X,
                      const acb_t per_X2, slong prec)
{
    acb_t B, r, t;
    acb_init(B), acb_init(r), acb_init(t);
    acb_mul(B, per_X, per_X2, prec);
    acb_mul_arb(B, B, patch->phi0, prec);
    acb_div_arb(B, B, patch->alpha, prec);
    acb_mul_ui(r, per_X2, 3, prec);
    acb_mul(t, r, per_X2, prec);
    add_part(k, B, z, r, t, prec);
    acb_clear(B), acb_clear(r), acb_clear(t);
}

/* A, of the corners ±alpha. */
static void add_corners(curvature *k, const ball_patch *patch, const acb_t z, const acb_t per_X,
                        const acb_t per_X2, slong prec)
{
    acb_t per_q, A, r, t;
    acb_init(per_q), acb_init(A), acb_init(r), acb_init(t);
    acb_sub_arb(A, z, patch->alpha, prec);
    acb_add_arb(per_q, z, patch->alpha, prec);
    acb_mul(per_q, per_q, A, prec);
    acb_inv(per_q, per_q, prec);
    acb_mul(A, per_X, per_q, prec);
    acb_mul_arb(A, A, patch->c0, prec);
    acb_mul_2exp_si(r, per_q, 1);
    acb_mul(t, r, per_q, prec);
    acb_add(r, r, per_X2, prec);
    acb_addmul(t, per_X2, per_X2, prec);
    add_part(k, A, z, r, t, prec);
    acb_clear(per_q), acb_clear(A), acb_clear(r), acb_clear(t);
}

/* 1/sqrt(z^2-1). */
static void set_per_X(acb_t per_X, const acb_t z, slong prec)
{
    acb_t root;
    acb_init(root);
    acb_sub_ui(root, z, 1, prec);
    ball_root(root, root, prec);
    acb_add_ui(per_X, z, 1, prec);
    ball_root(per_X, per_X, prec);
    acb_mul(per_X, per_X, root, prec);
    acb_inv(per_X, per_X, prec);
    acb_clear(root);
}

void curvature_enclose(curvature *k, const ball_patch *patch, const acb_t z, slong prec)
{
    acb_t per_X, per_X2;
    arb_t factor;
    acb_init(per_X), acb_init(per_X2), arb_init(factor);
    set_per_X(per_X, z, prec);
    acb_mul(per_X2, per_X, per_X, prec);
    acb_zero(k->second), acb_zero(k->third), acb_zero(k->fourth);
    add_edges(k, patch, z, per_X, per_X2, prec);
    if (!arb_is_zero(patch->c0)) /* Hertz has no corners */
        add_corners(k, patch, z, per_X, per_X2, prec);
    arb_const_pi(factor, prec);
    arb_ui_div(factor, 2, factor, prec);
    acb_mul_arb(k->second, k->second, factor, prec);
    acb_mul_arb(k->third, k->third, factor, prec);
    acb_mul_arb(k->fourth, k->fourth, factor, prec);
    acb_clear(per_X), acb_clear(per_X2), arb_clear(factor);
}
