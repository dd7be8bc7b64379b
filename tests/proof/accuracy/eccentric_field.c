/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses and slip of a contact off the centre, from the sums over breakpoints of the profile.
 * With z = m + s sin(zeta), q = exp(i zeta), the ends of the rounding at sin(phi_j) with the
 * jumps k_j = +-1/a of the slope, psi_j = pi/2 - phi_j and
 *
 *     L_j = ln(1 - exp(-i phi_j) q) - ln(1 + exp(i phi_j) q) - i psi_j,
 *
 *     G  = sum k_j s { (i/pi)[ (sin zeta - sin phi_j) L_j - psi_j cos zeta ]
 *                      - (1/pi)[ cos phi_j - psi_j sin phi_j ] },
 *     G' = sum k_j (i/pi)[ L_j + (cos phi_j + psi_j sin zeta)/cos zeta ],
 *     int G dz = sum k_j s^2 { (i/pi)[ (sin zeta - sin phi_j)^2 L_j/2
 *                  + cos phi_j (cos zeta + zeta sin phi_j)/2 - psi_j (zeta + sin zeta cos zeta)/2 ]
 *                  - (1/pi)[ cos phi_j - psi_j sin phi_j ] sin zeta }.
 *
 * An end on the left of the patch counts as one at its left edge, with the line continued: phi_j =
 * -pi/2 makes all of its sum but a constant. The edges are those that the library found: its rows
 * judge them. */
#include <math.h>

#include "eccentric.h"
#include "rows.h"

typedef struct {
    arb_t middle, half, a, tilt;

    arb_struct phi[2], k[2]; /* of ends inside */
    int ends;
    arb_t rate; /* of the slope, left of the first end inside: k_left */
} patch;

static void patch_init(patch *p, double a, double left, double right, slong prec)
{
    arb_ptr c = _arb_vec_init(CARRIED + 2);
    const ball_edges e = {c + CARRIED, c + CARRIED + 1};
    arb_init(p->middle), arb_init(p->half), arb_init(p->a), arb_init(p->tilt), arb_init(p->rate);
    arb_set_d(e.left, left);
    arb_set_d(e.right, right);
    arb_set_d(p->a, a);
    carried_by(c, p->a, &e, prec);
    arb_set(p->middle, c + M_MIDDLE);
    arb_set(p->half, c + S_HALF);
    arb_set(p->tilt, c + TILT_OF);
    p->ends = 0;
    for (int j = 0; j < 2; j++) {
        const double at = j == 0 ? -a : a;
        arb_ptr k = &p->k[p->ends], phi = &p->phi[p->ends];
        arb_init(&p->k[j]), arb_init(&p->phi[j]);
        if (at <= left) {
            if (j == 0)
                arb_inv(p->rate, p->a, prec);
            continue;
        }
        if (at >= right)
            continue;
        arb_inv(k, p->a, prec);
        if (j == 1)
            arb_neg(k, k);
        arb_set_d(phi, at);
        arb_sub(phi, phi, p->middle, prec);
        arb_div(phi, phi, p->half, prec);
        arb_asin(phi, phi, prec);
        p->ends++;
    }
    _arb_vec_clear(c, CARRIED + 2);
}

static void patch_clear(patch *p)
{
    arb_clear(p->middle), arb_clear(p->half), arb_clear(p->a), arb_clear(p->tilt);
    arb_clear(p->rate);
    for (int j = 0; j < 2; j++)
        arb_clear(&p->k[j]), arb_clear(&p->phi[j]);
}

/* sin zeta, cos zeta, q, zeta of a point of the closed upper half-plane. */
typedef struct {
    acb_t sine, cosine, q, zeta;
} place;

static void place_init(place *at, const patch *p, double x, double y, slong prec)
{
    acb_t other;
    acb_init(at->sine), acb_init(at->cosine), acb_init(at->q), acb_init(at->zeta), acb_init(other);
    arb_set_d(acb_realref(at->sine), x);
    arb_set_d(acb_imagref(at->sine), y);
    arb_sub(acb_realref(at->sine), acb_realref(at->sine), p->middle, prec);
    acb_div_arb(at->sine, at->sine, p->half, prec);
    acb_sub_ui(other, at->sine, 1, prec);
    ball_root(at->cosine, other, prec);
    acb_add_ui(other, at->sine, 1, prec);
    ball_root(other, other, prec);
    acb_mul(at->cosine, at->cosine, other, prec); /* X */
    acb_sub(at->q, at->sine, at->cosine, prec);   /* R */
    acb_mul_onei(at->q, at->q);
    acb_div_onei(at->cosine, at->cosine);
    acb_log(at->zeta, at->q, prec);
    acb_div_onei(at->zeta, at->zeta);
    acb_clear(other);
}

static void place_clear(place *at)
{
    acb_clear(at->sine), acb_clear(at->cosine), acb_clear(at->q), acb_clear(at->zeta);
}

/* L_j, and psi, cos(phi), sin(phi) in w[0 .. 2]. */
static void end_of(acb_t L, arb_ptr w, const patch *p, int j, const place *at, slong prec)
{
    acb_t turn;
    acb_init(turn);
    arb_const_pi(w, prec);
    arb_mul_2exp_si(w, w, -1);
    arb_sub(w, w, &p->phi[j], prec);
    arb_sin_cos(w + 2, w + 1, &p->phi[j], prec);
    arb_set(acb_realref(turn), w + 1);
    arb_neg(acb_imagref(turn), w + 2);
    acb_mul(turn, turn, at->q, prec);
    acb_neg(turn, turn);
    acb_add_ui(turn, turn, 1, prec);
    acb_log(L, turn, prec);
    arb_set(acb_realref(turn), w + 1);
    arb_set(acb_imagref(turn), w + 2);
    acb_mul(turn, turn, at->q, prec);
    acb_add_ui(turn, turn, 1, prec);
    acb_log(turn, turn, prec);
    acb_sub(L, L, turn, prec);
    arb_sub(acb_imagref(L), acb_imagref(L), w, prec);
    acb_clear(turn);
}

/* times i/pi */
static void over_pi(acb_t z, slong prec)
{
    arb_t pi;
    arb_init(pi);
    arb_const_pi(pi, prec);
    acb_mul_onei(z, z);
    acb_div_arb(z, z, pi, prec);
    arb_clear(pi);
}

/* (cos phi - psi sin phi)/pi */
static void constant_of(arb_t constant, arb_srcptr w, slong prec)
{
    arb_t pi;
    arb_init(pi);
    arb_const_pi(pi, prec);
    arb_mul(constant, w, w + 2, prec);
    arb_sub(constant, w + 1, constant, prec);
    arb_div(constant, constant, pi, prec);
    arb_clear(pi);
}

/* G and y G'. */
static void field_at(acb_t G, acb_t H, const patch *p, double x, double y, slong prec)
{
    place at;
    acb_t L, term;
    arb_t depth;
    arb_ptr w = _arb_vec_init(4);
    place_init(&at, p, x, y, prec);
    acb_init(L), acb_init(term), arb_init(depth);
    /* k_left: s (sin zeta - i cos zeta), and 1 + i tan zeta = (cos + i sin)/cos */
    acb_mul_onei(term, at.cosine);
    acb_sub(G, at.sine, term, prec);
    acb_mul_arb(G, G, p->half, prec);
    acb_mul_arb(G, G, p->rate, prec);
    acb_div(H, at.sine, at.cosine, prec);
    acb_mul_onei(H, H);
    acb_add_ui(H, H, 1, prec);
    acb_mul_arb(H, H, p->rate, prec);
    for (int j = 0; j < p->ends; j++) {
        end_of(L, w, p, j, &at, prec);
        acb_sub_arb(term, at.sine, w + 2, prec);
        acb_mul(term, term, L, prec);
        acb_submul_arb(term, at.cosine, w, prec);
        over_pi(term, prec);
        constant_of(w + 3, w, prec);
        acb_sub_arb(term, term, w + 3, prec);
        acb_mul_arb(term, term, p->half, prec);
        acb_addmul_arb(G, term, &p->k[j], prec);
        acb_mul_arb(term, at.sine, w, prec);
        acb_add_arb(term, term, w + 1, prec);
        acb_div(term, term, at.cosine, prec);
        acb_add(term, term, L, prec);
        over_pi(term, prec);
        acb_addmul_arb(H, term, &p->k[j], prec);
    }
    arb_set_d(depth, y);
    if (y == 0)
        acb_zero(H);
    else
        acb_mul_arb(H, H, depth, prec);
    acb_clear(L), acb_clear(term), arb_clear(depth);
    _arb_vec_clear(w, 4);
    place_clear(&at);
}

/* Re int G dz, but for a constant of the patch. */
static void primitive(arb_t value, const patch *p, double x, slong prec)
{
    place at;
    acb_t L, sum, term, zeta_and;
    arb_ptr w = _arb_vec_init(4);
    place_init(&at, p, x, 0, prec);
    acb_init(L), acb_init(sum), acb_init(term), acb_init(zeta_and);
    acb_mul(zeta_and, at.sine, at.cosine, prec);
    acb_add(zeta_and, zeta_and, at.zeta, prec);
    acb_mul_onei(term, zeta_and);
    acb_mul(sum, at.sine, at.sine, prec);
    acb_sub(sum, sum, term, prec);
    acb_mul_2exp_si(sum, sum, -1);
    acb_mul_arb(sum, sum, p->rate, prec);
    for (int j = 0; j < p->ends; j++) {
        end_of(L, w, p, j, &at, prec);
        acb_sub_arb(term, at.sine, w + 2, prec);
        acb_mul(term, term, term, prec);
        acb_mul(term, term, L, prec);
        acb_mul_arb(L, at.zeta, w + 2, prec);
        acb_add(L, L, at.cosine, prec);
        acb_addmul_arb(term, L, w + 1, prec);
        acb_submul_arb(term, zeta_and, w, prec);
        acb_mul_2exp_si(term, term, -1);
        over_pi(term, prec);
        constant_of(w + 3, w, prec);
        acb_submul_arb(term, at.sine, w + 3, prec);
        acb_addmul_arb(sum, term, &p->k[j], prec);
    }
    acb_mul_arb(sum, sum, p->half, prec);
    arb_mul(value, acb_realref(sum), p->half, prec);
    acb_clear(L), acb_clear(sum), acb_clear(term), acb_clear(zeta_and);
    _arb_vec_clear(w, 4);
    place_clear(&at);
}

/* x^2/(2a) on the rounding, |x| - a/2 beyond. */
static void profile(arb_t h, double a, double x, slong prec)
{
    arb_t half;
    arb_init(half);
    arb_set_d(h, fabs(x));
    arb_set_d(half, a);
    if (fabs(x) < a) {
        arb_mul(h, h, h, prec);
        arb_div(h, h, half, prec);
        arb_mul_2exp_si(h, h, -1);
    } else {
        arb_mul_2exp_si(half, half, -1);
        arb_sub(h, h, half, prec);
    }
    arb_clear(half);
}

/* How far the tilted profile lies above the surface at x, outside of the patch: from its edge. */
static void gap_at(arb_t gap, const patch *p, double a, double edge, double x, slong prec)
{
    arb_t v;
    arb_init(v);
    profile(gap, a, x, prec);
    profile(v, a, edge, prec);
    arb_sub(gap, gap, v, prec);
    arb_set_d(v, x);
    arb_t e;
    arb_init(e);
    arb_set_d(e, edge);
    arb_sub(v, v, e, prec);
    arb_submul(gap, v, p->tilt, prec);
    primitive(v, p, x, prec);
    arb_sub(gap, gap, v, prec);
    primitive(v, p, edge, prec);
    arb_add(gap, gap, v, prec);
    arb_clear(v), arb_clear(e);
}

/* ---- Rows ---- */

enum { X_AT = TENSION + 1, Y_AT };
enum { STICK_LEFT, STICK_RIGHT, WHOLE_LEFT, WHOLE_RIGHT, FOUND };

/* Next to an edge of the contact or of the stick zone, to an end of the rounding, or anywhere. */
static double some_x(probe *call)
{
    const double *r = call->result, width = r[WHOLE_RIGHT] - r[WHOLE_LEFT];
    const double marks[] = {r[0], r[1], r[2], r[3], -call->value[ROUNDING], call->value[ROUNDING]};
    if (chance(call, 0.3))
        return r[WHOLE_LEFT] + width * (3 * uniform(call) - 1);
    return marks[(int)(6 * uniform(call))] + either_sign(call, width * log_between(call, 1e-14, 1));
}

static bool draw_slipping_rounded(probe *call, rwedge_contact **contact)
{
    *contact = NULL;
    if (!draw_slipping(call, contact))
        return false;
    const double *r = call->result;
    if (call->value[ROUNDING] > 0 && r[STICK_LEFT] < r[STICK_RIGHT])
        return true;
    rwedge_contact_destroy(*contact);
    return false;
}

static bool draw_stresses(probe *call)
{
    rwedge_contact *contact;
    if (!draw_slipping_rounded(call, &contact))
        return false;
    double *r = call->result;
    const double width = r[WHOLE_RIGHT] - r[WHOLE_LEFT], x = argument(call, "x", some_x(call));
    const double y =
        argument(call, "y", chance(call, 0.3) ? 0 : width * log_between(call, 1e-14, 10));
    if (rwedge_contact_stresses(contact, 1, &x, &y, r + FOUND, r + FOUND + 1, r + FOUND + 2) !=
        RWEDGE_OK)
        r[FOUND] = NAN;
    rwedge_contact_destroy(contact);
    return true;
}

/* 1 - |delta|, the smaller of two patches'. */
static void flatness(arb_t less, const patch *one, const patch *other, slong prec)
{
    arb_t t;
    arb_init(t);
    arb_abs(less, one->tilt);
    arb_abs(t, other->tilt);
    arb_max(less, less, t, prec);
    arb_neg(less, less);
    arb_add_ui(less, less, 1, prec);
    arb_clear(t);
}

/* Mean, difference and shear of the pressure and of the shear traction f (G - G of what sticks). */
static void stress_of(arb_ptr s, const patch *whole, const patch *stick, const double v[],
                      slong prec)
{
    acb_t G, H, T, K;
    arb_t f;
    acb_init(G), acb_init(H), acb_init(T), acb_init(K), arb_init(f);
    field_at(G, H, whole, v[X_AT], v[Y_AT], prec);
    field_at(T, K, stick, v[X_AT], v[Y_AT], prec);
    acb_sub(T, G, T, prec);
    acb_sub(K, H, K, prec);
    arb_set_d(f, v[SHEAR] < 0 ? -v[FRICTION] : v[FRICTION]);
    acb_mul_arb(T, T, f, prec);
    acb_mul_arb(K, K, f, prec);
    arb_sub(s, acb_imagref(G), acb_realref(T), prec);
    arb_sub(s + 1, acb_realref(T), acb_imagref(K), prec);
    arb_sub(s + 1, s + 1, acb_realref(H), prec);
    arb_add(s + 2, acb_imagref(T), acb_realref(K), prec);
    arb_sub(s + 2, s + 2, acb_imagref(H), prec);
    acb_clear(G), acb_clear(H), acb_clear(T), acb_clear(K), arb_clear(f);
}

/* Over the larger of the stress and max(1, f)/(1+|z|), z from the middle of the contact, times 1 -
 * |delta|; and |sigma|. */
static void judge_stresses(arb_t error, const probe *call, slong prec)
{
    const double *v = call->value, *r = call->result;
    patch whole, stick;
    patch_init(&whole, v[ROUNDING], r[WHOLE_LEFT], r[WHOLE_RIGHT], prec);
    patch_init(&stick, v[ROUNDING], r[STICK_LEFT], r[STICK_RIGHT], prec);
    arb_ptr s = _arb_vec_init(9), scale = s + 6, unit = s + 7, t = s + 8;
    stress_of(s, &whole, &stick, v, prec);
    arb_sub(s + 3, s, s + 1, prec);
    arb_add(s + 4, s, s + 1, prec);
    arb_set(s + 5, s + 2);
    const double b = (r[WHOLE_RIGHT] - r[WHOLE_LEFT]) / 2;
    const double z = hypot(v[X_AT] - (r[WHOLE_RIGHT] + r[WHOLE_LEFT]) / 2, v[Y_AT]) / b;
    arb_set_d(scale, fmax(1, v[FRICTION]) / (1 + z));
    for (int i = 3; i < 6; i++) {
        arb_abs(t, s + i);
        arb_max(scale, scale, t, prec);
    }
    flatness(t, &whole, &stick, prec);
    arb_div(scale, scale, t, prec);
    arb_set_d(unit, v[THETA]);
    arb_set_d(t, v[COMPLIANCE]);
    arb_div(unit, unit, t, prec);
    arb_mul(scale, scale, unit, prec);
    arb_set_d(t, fabs(v[TENSION]));
    arb_add(scale, scale, t, prec);
    arb_set_d(t, v[TENSION]);
    arb_zero(error);
    for (int i = 0; i < 3; i++) {
        arb_mul(s + 3 + i, s + 3 + i, unit, prec);
        if (i == 0)
            arb_add(s + 3, s + 3, t, prec);
        error_over(s, r[FOUND + i], s + 3 + i, scale, prec);
        arb_max(error, error, s, prec);
    }
    _arb_vec_clear(s, 9);
    patch_clear(&whole), patch_clear(&stick);
}

static bool draw_slip(probe *call)
{
    rwedge_contact *contact;
    if (!draw_slipping_rounded(call, &contact))
        return false;
    double *r = call->result;
    const double x = argument(call, "x", fmax(r[WHOLE_LEFT], fmin(r[WHOLE_RIGHT], some_x(call))));
    if (rwedge_contact_slip(contact, 1, &x, r + FOUND) != RWEDGE_OK)
        r[FOUND] = NAN;
    rwedge_contact_destroy(contact);
    return true;
}

static void judge_slip(arb_t error, const probe *call, slong prec)
{
    const double *v = call->value, *r = call->result, x = v[X_AT];
    patch stick;
    patch_init(&stick, v[ROUNDING], r[STICK_LEFT], r[STICK_RIGHT], prec);
    arb_ptr w = _arb_vec_init(3);
    const double edge = x < r[STICK_LEFT] ? r[STICK_LEFT] : r[STICK_RIGHT];
    if (x < r[STICK_LEFT] || x > r[STICK_RIGHT])
        gap_at(w, &stick, v[ROUNDING], edge, x, prec);
    arb_set_d(w + 1, v[SHEAR] < 0 ? v[FRICTION] : -v[FRICTION]);
    arb_set_d(w + 2, v[THETA]);
    arb_mul(w + 1, w + 1, w + 2, prec);
    arb_mul(w, w, w + 1, prec);
    arb_set_d(w + 2, (r[WHOLE_RIGHT] - r[WHOLE_LEFT]) / 2);
    arb_mul(w + 1, w + 1, w + 2, prec);
    arb_abs(w + 1, w + 1);
    flatness(w + 2, &stick, &stick, prec);
    arb_div(w + 1, w + 1, w + 2, prec);
    error_over(error, r[FOUND], w, w + 1, prec);
    _arb_vec_clear(w, 3);
    patch_clear(&stick);
}

const row ECCENTRIC_FIELD_ROWS[] = {
    {"contact_stresses, off the centre", "after one step of Q and sigma; points dense at all edges",
     "of max(norm, max(1, f)/(1+\\|z\\|)), over 1 - \\|delta\\|; of the edges found", 1e-13,
     "1e-13", 1, draw_stresses, judge_stresses},
    {"contact_slip, off the centre", "the same",
     "of f theta b, over 1 - \\|delta\\|; of the edges found", 1e-12, "1e-12", 1, draw_slip,
     judge_slip},
    {0},
};
