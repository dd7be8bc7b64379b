/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses, slip and energy of a contact off the centre, from the sums over breakpoints of the
 * profile. With z = m + s sin(zeta), q = exp(i zeta), the ends of the rounding at sin(phi_j) with
 * the jumps k_j = +-1/a of the slope, psi_j = pi/2 - phi_j and
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
 * -pi/2 makes all of its sum but a constant. For stresses and slip the edges are those that the
 * library found: its rows judge them. */
#include <math.h>

#include "rows/eccentric.h"
#include "rows/rows.h"

typedef struct {
    arb_t middle, half, a, tilt;

    arb_struct phi[2], k[2]; /* of ends inside */
    int ends;
    arb_t rate; /* of the slope, left of the first end inside: k_left */
} patch;

static void patch_init(patch *p, double a, const ball_edges *e, slong prec)
{
    arb_ptr c = _arb_vec_init(CARRIED + 1);
    arb_ptr at = c + CARRIED;
    arb_init(p->middle), arb_init(p->half), arb_init(p->a), arb_init(p->tilt), arb_init(p->rate);
    arb_set_d(p->a, a);
    carried_by(c, p->a, e, prec);
    arb_set(p->middle, c + M_MIDDLE);
    arb_set(p->half, c + S_HALF);
    arb_set(p->tilt, c + TILT_OF);
    p->ends = 0;
    for (int j = 0; j < 2; j++) {
        arb_ptr k = &p->k[p->ends], phi = &p->phi[p->ends];
        arb_init(&p->k[j]), arb_init(&p->phi[j]);
        arb_set_d(at, j == 0 ? -a : a);
        if (arb_le(at, e->left)) {
            if (j == 0)
                arb_inv(p->rate, p->a, prec);
            continue;
        }
        if (arb_ge(at, e->right))
            continue;
        arb_inv(k, p->a, prec);
        if (j == 1)
            arb_neg(k, k);
        arb_sub(phi, at, p->middle, prec);
        arb_div(phi, phi, p->half, prec);
        arb_asin(phi, phi, prec);
        p->ends++;
    }
    _arb_vec_clear(c, CARRIED + 1);
}

static void patch_found(patch *p, double a, double left, double right, slong prec)
{
    arb_ptr c = _arb_vec_init(2);
    const ball_edges e = {c, c + 1};
    arb_set_d(e.left, left);
    arb_set_d(e.right, right);
    patch_init(p, a, &e, prec);
    _arb_vec_clear(c, 2);
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

static void place_init(place *at, const patch *p, const acb_t z, slong prec)
{
    acb_t other;
    acb_init(at->sine), acb_init(at->cosine), acb_init(at->q), acb_init(at->zeta), acb_init(other);
    acb_sub_arb(at->sine, z, p->middle, prec);
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

/* u ln u, for Re u >= 0 or nearly so. Where u may be 0: r (|ln r| + 4) bounds it for |u| <= r <=
 * 1/e, as |arg u| <= pi. */
static void times_own_logarithm(acb_t product, acb_t logarithm, const acb_t u, slong prec)
{
    acb_log(logarithm, u, prec);
    acb_mul(product, logarithm, u, prec);
    if (!acb_contains_zero(u))
        return;
    arb_t r, bound;
    arb_init(r), arb_init(bound);
    acb_get_abs_ubound_arf(arb_midref(r), u, prec);
    if (arf_cmp_d(arb_midref(r), 0.36) < 0) {
        arb_log(bound, r, prec);
        arb_sub_ui(bound, bound, 4, prec);
        arb_mul(bound, bound, r, prec);
        acb_zero(product);
        arb_add_error(acb_realref(product), bound);
        arb_add_error(acb_imagref(product), bound);
    }
    arb_clear(r), arb_clear(bound);
}

/* L_j, (sin zeta - sin phi_j) L_j, and psi, cos(phi), sin(phi) in w[0 .. 2]. With L_j = ln(A) -
 * ln(B) - i psi_j, sin zeta - sin phi_j = (i B/2q) A. */
static void end_of(acb_t L, acb_t product, arb_ptr w, const patch *p, int j, const place *at,
                   slong prec)
{
    acb_t turn, other;
    acb_init(turn), acb_init(other);
    arb_const_pi(w, prec);
    arb_mul_2exp_si(w, w, -1);
    arb_sub(w, w, &p->phi[j], prec);
    arb_sin_cos(w + 2, w + 1, &p->phi[j], prec);
    arb_set(acb_realref(turn), w + 1);
    arb_neg(acb_imagref(turn), w + 2);
    acb_mul(turn, turn, at->q, prec);
    acb_neg(turn, turn);
    acb_add_ui(turn, turn, 1, prec);
    times_own_logarithm(product, L, turn, prec);
    arb_set(acb_realref(turn), w + 1);
    arb_set(acb_imagref(turn), w + 2);
    acb_mul(turn, turn, at->q, prec);
    acb_add_ui(turn, turn, 1, prec);
    acb_div(other, turn, at->q, prec);
    acb_mul_onei(other, other);
    acb_mul_2exp_si(other, other, -1);
    acb_mul(product, product, other, prec);
    acb_log(turn, turn, prec);
    arb_add(acb_imagref(turn), acb_imagref(turn), w, prec);
    acb_sub(L, L, turn, prec);
    acb_sub_arb(other, at->sine, w + 2, prec);
    acb_submul(product, other, turn, prec);
    acb_clear(turn), acb_clear(other);
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

/* G; and y G', if wanted. */
static void field_at(acb_t G, acb_ptr H, const patch *p, const acb_t z, slong prec)
{
    place at;
    acb_t L, term;
    arb_ptr w = _arb_vec_init(4);
    place_init(&at, p, z, prec);
    acb_init(L), acb_init(term);
    /* k_left: s (sin zeta - i cos zeta), and 1 + i tan zeta = (cos + i sin)/cos */
    acb_mul_onei(term, at.cosine);
    acb_sub(G, at.sine, term, prec);
    acb_mul_arb(G, G, p->half, prec);
    acb_mul_arb(G, G, p->rate, prec);
    if (H) {
        acb_div(H, at.sine, at.cosine, prec);
        acb_mul_onei(H, H);
        acb_add_ui(H, H, 1, prec);
        acb_mul_arb(H, H, p->rate, prec);
    }
    for (int j = 0; j < p->ends; j++) {
        end_of(L, term, w, p, j, &at, prec);
        acb_submul_arb(term, at.cosine, w, prec);
        ball_times_i_over_pi(term, prec);
        constant_of(w + 3, w, prec);
        acb_sub_arb(term, term, w + 3, prec);
        acb_mul_arb(term, term, p->half, prec);
        acb_addmul_arb(G, term, &p->k[j], prec);
        if (!H)
            continue;
        acb_mul_arb(term, at.sine, w, prec);
        acb_add_arb(term, term, w + 1, prec);
        acb_div(term, term, at.cosine, prec);
        acb_add(term, term, L, prec);
        ball_times_i_over_pi(term, prec);
        acb_addmul_arb(H, term, &p->k[j], prec);
    }
    if (H && arb_is_zero(acb_imagref(z)))
        acb_zero(H);
    else if (H)
        acb_mul_arb(H, H, acb_imagref(z), prec);
    acb_clear(L), acb_clear(term);
    _arb_vec_clear(w, 4);
    place_clear(&at);
}

/* int G dz, but for a constant of the patch. */
static void primitive(acb_t sum, const patch *p, const acb_t z, slong prec)
{
    place at;
    acb_t L, term, away, zeta_and;
    arb_ptr w = _arb_vec_init(4);
    place_init(&at, p, z, prec);
    acb_init(L), acb_init(term), acb_init(away), acb_init(zeta_and);
    acb_mul(zeta_and, at.sine, at.cosine, prec);
    acb_add(zeta_and, zeta_and, at.zeta, prec);
    acb_mul_onei(term, zeta_and);
    acb_mul(sum, at.sine, at.sine, prec);
    acb_sub(sum, sum, term, prec);
    acb_mul_2exp_si(sum, sum, -1);
    acb_mul_arb(sum, sum, p->rate, prec);
    for (int j = 0; j < p->ends; j++) {
        end_of(L, term, w, p, j, &at, prec);
        acb_sub_arb(away, at.sine, w + 2, prec);
        acb_mul(term, term, away, prec);
        acb_mul_arb(L, at.zeta, w + 2, prec);
        acb_add(L, L, at.cosine, prec);
        acb_addmul_arb(term, L, w + 1, prec);
        acb_submul_arb(term, zeta_and, w, prec);
        acb_mul_2exp_si(term, term, -1);
        ball_times_i_over_pi(term, prec);
        constant_of(w + 3, w, prec);
        acb_submul_arb(term, at.sine, w + 3, prec);
        acb_addmul_arb(sum, term, &p->k[j], prec);
    }
    acb_mul_arb(sum, sum, p->half, prec);
    acb_mul_arb(sum, sum, p->half, prec);
    acb_clear(L), acb_clear(term), acb_clear(away), acb_clear(zeta_and);
    _arb_vec_clear(w, 4);
    place_clear(&at);
}

/* The faces of the wedge: x^2/(2a) on the rounding, |x| - a/2 beyond. */
typedef enum { LEFT_FLANK = -1, TIP, RIGHT_FLANK } face;

static face face_at(double a, double x)
{
    return fabs(x) < a ? TIP : x < 0 ? LEFT_FLANK : RIGHT_FLANK;
}

static void profile(acb_t h, const arb_t a, face on, const acb_t z, slong prec)
{
    if (on == TIP) {
        acb_mul(h, z, z, prec);
        acb_div_arb(h, h, a, prec);
    } else {
        acb_mul_2exp_si(h, z, 1);
        if (on == LEFT_FLANK)
            acb_neg(h, h);
        acb_sub_arb(h, h, a, prec);
    }
    acb_mul_2exp_si(h, h, -1);
}

/* Outside of the patch, how far the tilted profile lies above the surface, but for a constant: that
 * of its edge is taken off. */
static void height_at(acb_t height, const patch *p, const acb_t z, face on, slong prec)
{
    acb_t v;
    acb_init(v);
    profile(height, p->a, on, z, prec);
    acb_submul_arb(height, z, p->tilt, prec);
    primitive(v, p, z, prec);
    acb_sub(height, height, v, prec);
    acb_clear(v);
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
    acb_t z, G, H, T, K;
    arb_t f;
    acb_init(z), acb_init(G), acb_init(H), acb_init(T), acb_init(K), arb_init(f);
    acb_set_d_d(z, v[X_AT], v[Y_AT]);
    field_at(G, H, whole, z, prec);
    field_at(T, K, stick, z, prec);
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
    acb_clear(z), acb_clear(G), acb_clear(H), acb_clear(T), acb_clear(K), arb_clear(f);
}

/* Over the larger of the stress and max(1, f)/(1+|z|), z from the middle of the contact, times 1 -
 * |delta|; and |sigma|. */
static void judge_stresses(arb_t error, const probe *call, slong prec)
{
    const double *v = call->value, *r = call->result;
    patch whole, stick;
    patch_found(&whole, v[ROUNDING], r[WHOLE_LEFT], r[WHOLE_RIGHT], prec);
    patch_found(&stick, v[ROUNDING], r[STICK_LEFT], r[STICK_RIGHT], prec);
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
    patch_found(&stick, v[ROUNDING], r[STICK_LEFT], r[STICK_RIGHT], prec);
    arb_ptr w = _arb_vec_init(3);
    const double edge = x < r[STICK_LEFT] ? r[STICK_LEFT] : r[STICK_RIGHT];
    if (x < r[STICK_LEFT] || x > r[STICK_RIGHT]) {
        acb_t z, at_x, at_edge;
        acb_init(z), acb_init(at_x), acb_init(at_edge);
        acb_set_d(z, x);
        height_at(at_x, &stick, z, face_at(v[ROUNDING], x), prec);
        acb_set_d(z, edge);
        height_at(at_edge, &stick, z, face_at(v[ROUNDING], edge), prec);
        arb_sub(w, acb_realref(at_x), acb_realref(at_edge), prec);
        acb_clear(z), acb_clear(at_x), acb_clear(at_edge);
    }
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

/* ---- Energy: slip at f p from zero does the work (f theta)^2/A int p gap dx ---- */

/* A part of the slip zone on the right, with the ends of the rounding only at its own ends. */
typedef struct {
    const patch *whole, *stick;
    acb_t at_edge; /* the height where it begins to stick */
    face on;
} slip_zone;

/* p times the gap: p = i (G - h' + delta), as the surface follows the tilted profile. Both are
 * real there, and go on into the upper half-plane. */
static int work_density(acb_ptr work, const acb_t z, void *zone, slong order, slong prec)
{
    const slip_zone *on = zone;
    if (order > 0 && !arb_is_positive(acb_imagref(z))) {
        acb_indeterminate(work);
        return 0;
    }
    acb_t gap, slope;
    acb_init(gap), acb_init(slope);
    if (on->on == TIP)
        acb_div_arb(slope, z, on->whole->a, prec);
    else
        acb_set_si(slope, on->on);
    field_at(work, NULL, on->whole, z, prec);
    acb_sub(work, work, slope, prec);
    acb_add_arb(work, work, on->whole->tilt, prec);
    acb_mul_onei(work, work);
    height_at(gap, on->stick, z, on->on, prec);
    acb_sub(gap, gap, on->at_edge, prec);
    acb_mul(work, work, gap, prec);
    acb_clear(gap), acb_clear(slope);
    return 0;
}

/* From one end up, across, and down to the other: the formulas have their cuts below. */
static void work_between(arb_t work, slip_zone *zone, const arb_t from, const arb_t to,
                         const mag_t tolerance, slong prec)
{
    acb_ptr z = _acb_vec_init(5);
    acb_set_arb(z, from);
    acb_set_arb(z + 3, to);
    arb_sub(acb_imagref(z + 1), to, from, prec);
    arb_mul_2exp_si(acb_imagref(z + 1), acb_imagref(z + 1), -1);
    arb_set(acb_imagref(z + 2), acb_imagref(z + 1));
    arb_set(acb_realref(z + 1), from);
    arb_set(acb_realref(z + 2), to);
    for (int i = 0; i < 3; i++) {
        acb_calc_integrate(z + 4, work_density, zone, z + i, z + i + 1, prec, tolerance, NULL,
                           prec);
        arb_add(work, work, acb_realref(z + 4), prec);
    }
    _acb_vec_clear(z, 5);
}

/* What slips on the right of the patch. */
static void work_on_the_right(arb_t work, double a, const ball_edges *stick,
                              const ball_edges *whole, const mag_t tolerance, slong prec)
{
    if (arb_le(whole->right, stick->right))
        return; /* it sticks up to the edge, to rounding of the loads */
    patch sticking, pressed;
    patch_init(&sticking, a, stick, prec);
    patch_init(&pressed, a, whole, prec);
    slip_zone zone = {.whole = &pressed, .stick = &sticking};
    arb_ptr mark = _arb_vec_init(2);
    acb_t edge;
    acb_init(edge), acb_init(zone.at_edge);
    acb_set_arb(edge, stick->right);
    arb_set(mark, stick->right);
    for (zone.on = LEFT_FLANK; zone.on <= RIGHT_FLANK; zone.on++) {
        arb_set_d(mark + 1, zone.on == LEFT_FLANK ? -a : a);
        if (zone.on == RIGHT_FLANK || arb_gt(mark + 1, whole->right))
            arb_set(mark + 1, whole->right);
        if (arb_le(mark + 1, mark))
            continue;
        if (arb_equal(mark, stick->right))
            height_at(zone.at_edge, &sticking, edge, zone.on, prec);
        work_between(work, &zone, mark, mark + 1, tolerance, prec);
        arb_set(mark, mark + 1);
    }
    acb_clear(edge), acb_clear(zone.at_edge);
    _arb_vec_clear(mark, 2);
    patch_clear(&sticking), patch_clear(&pressed);
}

static void mirror(const ball_edges *e)
{
    arb_swap(e->left, e->right);
    arb_neg(e->left, e->left);
    arb_neg(e->right, e->right);
}

/* Takes off what rounding of the loads is magnified by: |x| at the edges over the width, 1/(1 -
 * |delta|), and 1e-14 in units of 1e-12 of P over Q/f. */
static void less_magnified(arb_t error, const double v[], const ball_edges *stick,
                           const ball_edges *whole, slong prec)
{
    patch sticking, pressed;
    patch_init(&sticking, v[ROUNDING], stick, prec);
    patch_init(&pressed, v[ROUNDING], whole, prec);
    arb_ptr w = _arb_vec_init(2);
    flatness(w, &sticking, &pressed, prec);
    arb_mul(error, error, w, prec);
    arb_mul_2exp_si(w + 1, pressed.half, 1);
    arb_mul(error, error, w + 1, prec);
    arb_abs(w, pressed.middle);
    arb_add(w, w, pressed.half, prec);
    arb_max(w, w, w + 1, prec);
    arb_div(error, error, w, prec);
    arb_set_d(w, 1 + 0.01 * v[LOAD] / fabs(v[SHEAR] / v[FRICTION]));
    arb_div(error, error, w, prec);
    _arb_vec_clear(w, 2);
    patch_clear(&sticking), patch_clear(&pressed);
}

static bool draw_energy(probe *call)
{
    rwedge_contact *contact;
    if (!draw_slipping_rounded(call, &contact))
        return false;
    call->result[FOUND] = rwedge_contact_dissipated_energy(contact);
    rwedge_contact_destroy(contact);
    return true;
}

static void judge_energy(arb_t error, const probe *call, slong prec)
{
    const double *v = call->value, *r = call->result;
    const slong bits = 2 * prec; /* the gap next to its edge is a small difference */
    arb_ptr w = _arb_vec_init(6);
    arb_ptr work = w + 4, unit = w + 5;
    const ball_edges stick = {w, w + 1}, whole = {w + 2, w + 3};
    mag_t tolerance;
    mag_init(tolerance);
    arb_set_d(work, v[FRICTION]);
    arb_set_d(unit, v[THETA]);
    arb_mul(unit, unit, work, bits);
    arb_sqr(unit, unit, bits);
    arb_set_d(work, v[COMPLIANCE]);
    arb_div(unit, unit, work, bits);
    arb_set_d(work, r[FOUND]);
    arb_div(work, work, unit, bits);
    arb_get_mag(tolerance, work);
    mag_mul_2exp_si(tolerance, tolerance, -72);
    arb_zero(work);
    ball_slipping(&stick, &whole, call, bits);
    for (int side = 0; side < 2; side++) {
        work_on_the_right(work, v[ROUNDING], &stick, &whole, tolerance, bits);
        mirror(&stick);
        mirror(&whole);
    }
    arb_mul(work, work, unit, bits);
    relative_error(error, r[FOUND], work, bits);
    less_magnified(error, v, &stick, &whole, bits);
    _arb_vec_clear(w, 6);
    mag_clear(tolerance);
}

const row ECCENTRIC_FIELD_ROWS[] = {
    {"contact_stresses, off the centre", "after one step of Q and sigma; points dense at all edges",
     "of max(norm, max(1, f)/(1+\\|z\\|)), over 1 - \\|delta\\|; of the edges found", 1e-13,
     "1e-13", 1, draw_stresses, judge_stresses},
    {"contact_slip, off the centre", "the same",
     "of f theta b, over 1 - \\|delta\\|; of the edges found", 1e-12, "1e-12", 1, draw_slip,
     judge_slip},
    {"contact_dissipated_energy, off the centre", "the same",
     "relative, times max(1, \\|x\\|/width), over 1 - \\|delta\\|; loads (4)", 1e-12, "1e-12 (4)",
     0.004, draw_energy, judge_energy},
    {0},
};
