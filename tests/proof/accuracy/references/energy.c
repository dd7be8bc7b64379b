/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The front of slip passes the layer s0 > s > s1 of the path, while the load moves linearly from p0
 * to p1. The slope of the layer differs by w from that of slip. Then
 *     energy = (A f^2/pi) w int B(u) d ln(eta(u)),
 *     B(u) = int max(P(s) - u, 0) ds over s1 < s < min(s0, u).
 * B is a polynomial of the second degree between its corners s0, s1, p0, p1; the integrals of
 * u^k d ln(eta) are elementary on either side of the load at the end of the rounding. */
#include "references/energy.h"

#include <math.h>

typedef struct {
    arb_struct s0, s1, p0, p1;
} layer;

typedef struct {
    arb_srcptr a, unit;
    arb_t corner; /* the load at eta = a */
} profile;

/* B(u); the moving load is P(s) = p1 + (s - s1) k. */
static void overlap(arb_t B, const layer *l, const arb_t u, slong prec)
{
    arb_ptr w = _arb_vec_init(6);
    arb_ptr to = w, k = w + 1, at_s1 = w + 2, at_to = w + 3, length = w + 4, r = w + 5;
    arb_min(to, &l->s0, u, prec);
    arb_sub(length, to, &l->s1, prec);
    arb_sub(k, &l->s0, &l->s1, prec);
    arb_sub(r, &l->p0, &l->p1, prec);
    arb_div(k, r, k, prec);
    arb_sub(at_s1, &l->p1, u, prec);
    arb_mul(at_to, k, length, prec);
    arb_add(at_to, at_to, at_s1, prec);
    const bool first = arf_sgn(arb_midref(at_s1)) >= 0, second = arf_sgn(arb_midref(at_to)) >= 0;
    if (arf_sgn(arb_midref(length)) <= 0 || (!first && !second)) {
        arb_zero(B);
    } else if (first && second) {
        arb_add(r, at_s1, at_to, prec);
        arb_mul(B, r, length, prec);
        arb_mul_2exp_si(B, B, -1);
    } else { /* a triangle */
        arb_sqr(B, first ? at_s1 : at_to, prec);
        arb_div(B, B, k, prec);
        arb_abs(B, B);
        arb_mul_2exp_si(B, B, -1);
    }
    _arb_vec_clear(w, 6);
}

/* The indefinite integrals of u^k d ln(eta), k = 0, 1, 2, at the load u, in units of
 * corner/(pi/2) =: U and lengths of a: on the rounding u = (pi/2) eta^2; beyond, with phi =
 * asin(1/eta), r = sqrt(eta^2-1), u = eta^2 phi + r,
 *     ln(eta),
 *     eta^2 phi/2 + 3 r/2 - acos(1/eta),
 *     eta^4 phi^2/4 + (5 r^3/6 + r/2) phi + 11 eta^2/12 - (4/3) ln(eta). */
static void primitives(arb_ptr V, const arb_t eta, bool beyond, slong prec)
{
    arb_ptr w = _arb_vec_init(6);
    arb_ptr phi = w, r = w + 1, e2 = w + 2, t = w + 3, half_pi = w + 4;
    arb_const_pi(half_pi, prec);
    arb_mul_2exp_si(half_pi, half_pi, -1);
    arb_log(V, eta, prec);
    arb_sqr(e2, eta, prec);
    if (!beyond) { /* (pi/2) eta^2/2, (pi/2)^2 eta^4/4 */
        arb_mul(V + 1, half_pi, e2, prec);
        arb_sqr(V + 2, V + 1, prec);
        arb_mul_2exp_si(V + 1, V + 1, -1);
        arb_mul_2exp_si(V + 2, V + 2, -2);
    } else {
        arb_sub_ui(r, eta, 1, prec);
        arb_add_ui(t, eta, 1, prec);
        arb_mul(r, r, t, prec);
        arb_sqrtpos(r, r, prec);
        arb_inv(phi, eta, prec);
        arb_one(t);
        arb_atan2(phi, t, r, prec);
        arb_mul(V + 1, e2, phi, prec);
        arb_addmul_ui(V + 1, r, 3, prec);
        arb_mul_2exp_si(V + 1, V + 1, -1);
        arb_sub(t, half_pi, phi, prec);
        arb_sub(V + 1, V + 1, t, prec);
        arb_mul(V + 2, e2, phi, prec);
        arb_sqr(V + 2, V + 2, prec);
        arb_mul_2exp_si(V + 2, V + 2, -2);
        arb_pow_ui(t, r, 3, prec);
        arb_mul_ui(t, t, 5, prec);
        arb_addmul_ui(t, r, 3, prec);
        arb_div_ui(t, t, 6, prec);
        arb_addmul(V + 2, t, phi, prec);
        arb_mul_ui(t, e2, 11, prec);
        arb_submul_ui(t, V, 16, prec);
        arb_div_ui(t, t, 12, prec);
        arb_add(V + 2, V + 2, t, prec);
    }
    _arb_vec_clear(w, 6);
}

/* The same for the sharp wedge, d ln(eta) = du/u, at a load in units of U. */
static void sharp_primitives(arb_ptr V, const arb_t u, slong prec)
{
    arb_log(V, u, prec);
    arb_set(V + 1, u);
    arb_sqr(V + 2, u, prec);
    arb_mul_2exp_si(V + 2, V + 2, -1);
}

static void primitives_at(arb_ptr V, const profile *p, const arb_t u, const arb_t U, bool beyond,
                          slong prec)
{
    arb_t one, eta, scaled;
    arb_init(one), arb_init(eta), arb_init(scaled);
    arb_one(one);
    arb_div(scaled, u, U, prec);
    if (arb_is_zero(u)) {
        _arb_vec_zero(V, 3); /* but for the logarithm, whose factor B(0) is 0 */
    } else if (arb_is_zero(p->a)) {
        sharp_primitives(V, scaled, prec);
    } else {
        /* the half-width in a: guess from either end of the law */
        const double load = arf_get_d(arb_midref(scaled), ARF_RND_NEAR);
        const double hertz = 0.7978845608028654,
                     guess = load < 1.5707963267948966 ? hertz * sqrt(load) : load / 1.9;
        arb_sub(eta, u, p->corner, prec);
        if (sign_beside(eta, p->corner, prec) == 0)
            arb_one(eta);
        else
            ball_half_width(eta, one, scaled, guess < 1e-300 ? 1e-300 : guess, prec);
        primitives(V, eta, beyond, prec);
    }
    arb_clear(one), arb_clear(eta), arb_clear(scaled);
}

/* int_lo^hi B d ln(eta), where B is one polynomial and the loads are on one side of the corner;
 * in units of U. */
static void add_piece(arb_t sum, const layer *l, const profile *p, const arb_t lo, const arb_t hi,
                      slong prec)
{
    arb_ptr w = _arb_vec_init(16);
    arb_ptr B = w, V = w + 3, V_lo = w + 6, U = w + 9, middle = w + 10, x = w + 11, y = w + 12,
            c = w + 13;
    arb_add(middle, lo, hi, prec);
    arb_mul_2exp_si(middle, middle, -1);
    const bool beyond = arf_cmp(arb_midref(middle), arb_midref(p->corner)) > 0;
    if (arb_is_zero(p->a)) {
        arb_set(U, hi);
    } else {
        arb_const_pi(U, prec);
        arb_mul_2exp_si(U, U, -1);
        arb_div(U, p->corner, U, prec);
    }
    overlap(B, l, lo, prec);
    overlap(B + 1, l, middle, prec);
    overlap(B + 2, l, hi, prec);
    primitives_at(V, p, hi, U, beyond, prec);
    primitives_at(V_lo, p, lo, U, beyond, prec);
    _arb_vec_sub(V, V, V_lo, 3, prec);
    /* B = c0 + c1 u + c2 u^2 through the three values, u in U */
    arb_div(x, lo, U, prec);
    arb_div(y, hi, U, prec);
    /* the length; with t = (u - x)/y: B = B0 + (4 B1 - 3 B0 - B2) t + 2 (B0 - 2 B1 + B2) t^2 */
    arb_sub(y, y, x, prec);
    arb_mul_2exp_si(c + 1, B + 1, 2);
    arb_submul_ui(c + 1, B, 3, prec);
    arb_sub(c + 1, c + 1, B + 2, prec);
    arb_div(c + 1, c + 1, y, prec);
    arb_mul_2exp_si(c + 2, B + 1, 1);
    arb_sub(c + 2, B, c + 2, prec);
    arb_add(c + 2, c + 2, B + 2, prec);
    arb_mul_2exp_si(c + 2, c + 2, 1);
    arb_sqr(y, y, prec);
    arb_div(c + 2, c + 2, y, prec);
    arb_mul(y, c + 2, x, prec); /* in u: c0 = B0 - c1 x + c2 x^2, c1 = c1 - 2 c2 x */
    arb_sub(y, y, c + 1, prec);
    arb_mul(y, y, x, prec);
    arb_add(c, B, y, prec);
    arb_mul(y, c + 2, x, prec);
    arb_mul_2exp_si(y, y, 1);
    arb_sub(c + 1, c + 1, y, prec);
    for (int k = arb_is_zero(lo) ? 1 : 0; k < 3; k++)
        arb_addmul(sum, c + k, V + k, prec);
    _arb_vec_clear(w, 16);
}

static void add_layer(arb_t sum, const arb_t weight, const layer *l, const profile *p, slong prec)
{
    enum { CUTS = 5 };
    arb_ptr cut = _arb_vec_init(CUTS + 1);
    arb_ptr total = cut + CUTS;
    arb_t length;
    arb_init(length);
    arb_set(cut, &l->s0), arb_set(cut + 1, &l->s1), arb_set(cut + 2, &l->p0),
        arb_set(cut + 3, &l->p1);
    arb_set(cut + 4, p->corner);
    for (int i = 1; i < CUTS; i++)
        for (int j = i; j > 0 && arf_cmp(arb_midref(cut + j), arb_midref(cut + j - 1)) < 0; j--)
            arb_swap(cut + j, cut + j - 1);
    for (int i = 1; i < CUTS; i++) {
        arb_sub(length, cut + i, cut + i - 1, prec);
        if (sign_beside(length, cut + i, prec) > 0 &&
            arf_cmp(arb_midref(cut + i), arb_midref(&l->s1)) > 0 &&
            arf_cmp(arb_midref(cut + i - 1), arb_midref(&l->s1)) >= 0)
            add_piece(total, l, p, cut + i - 1, cut + i, prec);
    }
    arb_addmul(sum, weight, total, prec);
    arb_clear(length);
    _arb_vec_clear(cut, CUTS + 1);
}

/* A step, t = 0 to 1. */
typedef struct {
    const path *p;
    arb_srcptr load, shear; /* at t = 0 */
    arb_t run, rise;
} step;

/* Slip of one sign from t = start to end: the front goes from the edge inwards. It is at s when
 * t climb = (P0 - s) - slip (T0 - T(s)), climb = slip rise - run. */
static void sweep(arb_t sum, const step *st, int slip, const arb_t start, const arb_t end,
                  const profile *p, slong prec)
{
    arb_ptr w = _arb_vec_init(6);
    arb_ptr climb = w, top = w + 1, t_top = w + 2, t = w + 3, weight = w + 4, u = w + 5;
    layer l;
    arb_init(&l.s0), arb_init(&l.s1), arb_init(&l.p0), arb_init(&l.p1);
    arb_mul_si(climb, st->rise, slip, prec);
    arb_sub(climb, climb, st->run, prec);
    arb_set(t_top, start);
    arb_set(top, st->load); /* where the front is: the edge, or the end of a path that grows */
    if (arf_sgn(arb_midref(st->run)) < 0)
        arb_addmul(top, st->run, start, prec);
    for (int i = st->p->count - 1; i > 0; i--) {
        const corner *before = &st->p->corners[i - 1], *after = before + 1;
        arb_sub(u, top, before->load, prec);
        if (sign_beside(u, st->load, prec) <= 0)
            continue;
        arb_mul_si(weight, after->ratio, -slip, prec);
        arb_add_ui(weight, weight, 1, prec);
        arb_sub(t, st->load, before->load, prec); /* when the front is at the lower corner */
        arb_sub(u, before->shear, st->shear, prec);
        arb_addmul_si(t, u, slip, prec);
        arb_div(t, t, climb, prec);
        arb_sub(u, t, end, prec);
        arb_one(&l.s0);
        const bool stops = sign_beside(u, &l.s0, prec) > 0;
        arb_set(&l.s0, top);
        arb_set(&l.s1, before->load);
        arb_one(u);
        if (stops) { /* inside this segment, weight per length */
            arb_sub(u, end, t_top, prec);
            arb_mul(u, u, climb, prec);
            if (sign_beside(u, st->load, prec) <= 0)
                break;
            arb_div(u, u, weight, prec);
            arb_sub(&l.s1, top, u, prec);
            arb_set(t, end);
        }
        arb_set(&l.p0, st->load);
        arb_addmul(&l.p0, st->run, t_top, prec);
        arb_set(&l.p1, st->load);
        arb_addmul(&l.p1, st->run, t, prec);
        arb_one(u);
        if (sign_beside(weight, u, prec) > 0)
            add_layer(sum, weight, &l, p, prec);
        if (stops)
            break;
        arb_set(top, before->load);
        arb_set(t_top, t);
    }
    arb_clear(&l.s0), arb_clear(&l.s1), arb_clear(&l.p0), arb_clear(&l.p1);
    _arb_vec_clear(w, 6);
}

/* A falling load: its edge moves along the path, and where what the step is ahead of the path
 * changes sign the zone of slip has shrunk to nothing and begins anew. */
static void falling(arb_t sum, arb_t most, const step *st, const profile *p, slong prec)
{
    arb_ptr w = _arb_vec_init(8);
    arb_ptr t = w, start = w + 1, missing = w + 2, next = w + 3, rate = w + 4, then = w + 5,
            crossing = w + 6, scale = w + 7;
    int slip = 0;
    arb_abs(scale, st->load);
    for (int i = st->p->count - 1; i > 0; i--) {
        arb_sub(next, st->load, st->p->corners[i - 1].load, prec);
        arb_div(next, next, st->run, prec);
        arb_neg(next, next);
        const bool ends = arf_cmp_si(arb_midref(next), 1) >= 0;
        if (ends)
            arb_one(next);
        arb_mul(rate, st->p->corners[i].ratio, st->run, prec);
        arb_sub(rate, st->rise, rate, prec);
        arb_sub(then, next, t, prec);
        arb_mul(then, then, rate, prec);
        arb_add(then, then, missing, prec);
        const int now = sign_beside(then, scale, prec);
        if (slip != 0 && slip * now < 0) {
            arb_div(crossing, missing, rate, prec);
            arb_sub(crossing, t, crossing, prec);
            sweep(sum, st, slip, start, crossing, p, prec);
            arb_set(start, crossing);
            slip = -slip;
        } else if (slip == 0 && now != 0) {
            slip = now;
            arb_set(start, t);
        }
        arb_set(missing, then);
        arb_abs(crossing, then);
        arb_max(most, most, crossing, prec);
        arb_set(t, next);
        if (ends)
            break;
    }
    if (slip != 0) {
        arb_one(t);
        sweep(sum, st, slip, start, t, p, prec);
    }
    _arb_vec_clear(w, 8);
}

void ball_dissipation(arb_t energy, arb_t ahead, const path *p, const arb_t load, const arb_t shear,
                      const arb_t a, const arb_t unit, slong prec)
{
    const corner *end = &p->corners[p->count - 1];
    step st = {.p = p, .load = end->load, .shear = end->shear};
    profile q = {.a = a, .unit = unit};
    arb_t zero, one, steep;
    arb_init(st.run), arb_init(st.rise), arb_init(q.corner), arb_init(zero), arb_init(one),
        arb_init(steep);
    arb_one(one);
    arb_sub(st.run, load, end->load, prec);
    arb_sub(st.rise, shear, end->shear, prec);
    arb_const_pi(q.corner, prec);
    arb_mul_2exp_si(q.corner, q.corner, -1);
    arb_mul(q.corner, q.corner, a, prec);
    arb_mul(q.corner, q.corner, unit, prec);
    arb_zero(energy), arb_zero(ahead);
    if (sign_beside(st.run, end->load, prec) < 0 && p->count > 1) {
        falling(energy, ahead, &st, &q, prec);
    } else {
        arb_abs(steep, st.rise);
        arb_sub(steep, steep, st.run, prec);
        arb_set(ahead, steep);
        if (sign_beside(steep, load, prec) > 0)
            sweep(energy, &st, arf_sgn(arb_midref(st.rise)), zero, one, &q, prec);
    }
    arb_clear(st.run), arb_clear(st.rise), arb_clear(q.corner), arb_clear(zero), arb_clear(one),
        arb_clear(steep);
}
