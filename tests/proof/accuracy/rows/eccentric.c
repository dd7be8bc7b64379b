/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contacts with a moment and a bulk tension: edges, tilt, stick zones. A patch is drawn first, and
 * its load and moment from it, so that its edges can be put next to the ends of the rounding. Then
 * the patch of the rounded load and moment is enclosed. */
#include <float.h>
#include <math.h>

#include "rows/eccentric.h"
#include "rows/rows.h"

/* ---- One patch in balls; lengths, loads in theta/A, tilts in theta ---- */

static void clipped(arb_t x, slong prec)
{
    arb_t bound;
    arb_init(bound);
    arb_max(x, x, bound, prec);
    arb_set_ui(bound, 2);
    arb_min(x, x, bound, prec);
    arb_clear(bound);
}

/* Angle, sine and cosine of an end of the rounding as the patch sees it. */
static void end_of(arb_ptr end, const arb_t at, const ball_edges *e, const arb_t half, slong prec)
{
    arb_t from_left, to_right;
    arb_init(from_left), arb_init(to_right);
    arb_sub(from_left, at, e->left, prec);
    arb_div(from_left, from_left, half, prec);
    arb_sub(to_right, e->right, at, prec);
    arb_div(to_right, to_right, half, prec);
    clipped(from_left, prec);
    clipped(to_right, prec);
    arb_sub(end + 1, from_left, to_right, prec);
    arb_mul_2exp_si(end + 1, end + 1, -1);
    arb_mul(end + 2, from_left, to_right, prec);
    arb_sqrtpos(end + 2, end + 2, prec);
    arb_atan2(end, end + 1, end + 2, prec);
    arb_clear(from_left), arb_clear(to_right);
}

/* max(0, x - y) */
static void excess(arb_t z, const arb_t x, const arb_t y, slong prec)
{
    arb_t zero;
    arb_init(zero);
    arb_sub(z, x, y, prec);
    arb_max(z, z, zero, prec);
    arb_clear(zero);
}

static void carried_by_sharp(arb_ptr c, const ball_edges *e, slong prec)
{
    arb_t root, u;
    arb_init(root), arb_init(u);
    arb_mul(root, e->left, e->right, prec);
    arb_neg(root, root);
    arb_sqrt(root, root, prec);
    arb_mul_2exp_si(c + P_OF, root, 1);
    arb_mul(c + M_OF, c + M_MIDDLE, root, prec);
    arb_atan2(c + TILT_OF, c + M_MIDDLE, root, prec);
    arb_const_pi(u, prec);
    arb_div(c + TILT_OF, c + TILT_OF, u, prec);
    arb_mul_2exp_si(c + TILT_OF, c + TILT_OF, 1);
    arb_div(c + U_OF, e->left, root, prec);
    arb_neg(c + U_OF, c + U_OF);
    arb_div(c + V_OF, e->right, root, prec);
    arb_clear(root), arb_clear(u);
}

void carried_by(arb_ptr c, const arb_t a, const ball_edges *e, slong prec)
{
    arb_add(c + M_MIDDLE, e->left, e->right, prec);
    arb_mul_2exp_si(c + M_MIDDLE, c + M_MIDDLE, -1);
    arb_sub(c + S_HALF, e->right, e->left, prec);
    arb_mul_2exp_si(c + S_HALF, c + S_HALF, -1);
    if (arb_is_zero(a)) {
        carried_by_sharp(c, e, prec);
        return;
    }
    arb_ptr t = _arb_vec_init(10);
    arb_ptr first = t, last = t + 3, u = t + 6, w = t + 7, s = c + S_HALF, between = t + 8;
    arb_neg(u, a);
    end_of(first, u, e, s, prec);
    end_of(last, a, e, s, prec);
    arb_sub(between, last, first, prec); /* phi_2 - phi_1 */
    /* P = (s^2/2a) [ phi + sin(phi) cos(phi) ] */
    arb_mul(u, last + 1, last + 2, prec);
    arb_submul(u, first + 1, first + 2, prec);
    arb_add(u, u, between, prec);
    arb_mul(u, u, s, prec);
    arb_mul(u, u, s, prec);
    arb_div(u, u, a, prec);
    arb_mul_2exp_si(c + P_OF, u, -1);
    /* M = m P + (s^3/6a) [ -cos(phi)^3 ] */
    arb_pow_ui(u, first + 2, 3, prec);
    arb_pow_ui(w, last + 2, 3, prec);
    arb_sub(u, u, w, prec);
    arb_pow_ui(w, s, 3, prec);
    arb_mul(u, u, w, prec);
    arb_div(u, u, a, prec);
    arb_div_ui(u, u, 6, prec);
    arb_addmul(u, c + M_MIDDLE, c + P_OF, prec);
    arb_set(c + M_OF, u);
    /* delta = -(1/(pi a)) { s [ phi sin(phi) + cos(phi) ] + (pi/2) what is beyond the edges } */
    arb_mul(u, last, last + 1, prec);
    arb_submul(u, first, first + 1, prec);
    arb_add(u, u, last + 2, prec);
    arb_sub(u, u, first + 2, prec);
    arb_mul(u, u, s, prec);
    excess(w, a, e->right, prec);
    arb_const_pi(t + 9, prec);
    arb_mul_2exp_si(t + 9, t + 9, -1);
    arb_addmul(u, w, t + 9, prec);
    arb_neg(w, a);
    excess(w, e->left, w, prec);
    arb_submul(u, w, t + 9, prec);
    arb_div(u, u, a, prec);
    arb_div(u, u, t + 9, prec);
    arb_mul_2exp_si(u, u, -1);
    arb_neg(c + TILT_OF, u);
    /* u, v = (s/2a) [ phi -+ cos(phi) ] */
    arb_sub(w, first + 2, last + 2, prec);
    arb_add(c + U_OF, between, w, prec);
    arb_sub(c + V_OF, between, w, prec);
    for (int i = U_OF; i <= V_OF; i++) {
        arb_mul(c + i, c + i, s, prec);
        arb_div(c + i, c + i, a, prec);
        arb_mul_2exp_si(c + i, c + i, -1);
    }
    _arb_vec_clear(t, 10);
}

/* ---- Which patch carries what: Krawczyk's operator ---- */

typedef struct {
    arb_srcptr a, P, other;
    bool by_moment;
} wanted;

static void slopes(arb_mat_t J, const arb_ptr c, bool by_moment, slong prec)
{
    arb_t w;
    arb_init(w);
    arb_neg(arb_mat_entry(J, 0, 0), c + V_OF);
    arb_set(arb_mat_entry(J, 0, 1), c + U_OF);
    for (int i = 0; i < 2; i++) { /* m dP + (pi s^2/2) d delta, or d delta */
        arb_ptr entry = arb_mat_entry(J, 1, i);
        arb_srcptr rate = c + (i == 0 ? V_OF : U_OF);
        if (by_moment) {
            arb_mul(entry, c + S_HALF, rate, prec);
            arb_mul_2exp_si(entry, entry, -1);
            arb_addmul(entry, c + M_MIDDLE, arb_mat_entry(J, 0, i), prec);
        } else {
            arb_const_pi(w, prec);
            arb_mul(w, w, c + S_HALF, prec);
            arb_div(entry, rate, w, prec);
        }
    }
    arb_clear(w);
}

static void at(const arb_mat_t x, const wanted *to, arb_mat_t F, arb_mat_t J, slong prec)
{
    arb_ptr c = _arb_vec_init(CARRIED);
    const ball_edges e = {arb_mat_entry(x, 0, 0), arb_mat_entry(x, 1, 0)};
    carried_by(c, to->a, &e, prec);
    if (F) {
        arb_sub(arb_mat_entry(F, 0, 0), c + P_OF, to->P, prec);
        arb_sub(arb_mat_entry(F, 1, 0), c + (to->by_moment ? M_OF : TILT_OF), to->other, prec);
    }
    if (J)
        slopes(J, c, to->by_moment, prec);
    _arb_vec_clear(c, CARRIED);
}

/* x - J^-1 F, without proof. */
static bool step(arb_mat_t x, const wanted *to, arb_mat_t inverse, slong prec)
{
    arb_mat_t F, J;
    arb_mat_init(F, 2, 1), arb_mat_init(J, 2, 2);
    at(x, to, F, J, prec);
    arb_mat_get_mid(J, J);
    const bool done = arb_mat_inv(inverse, J, prec) != 0;
    arb_mat_get_mid(inverse, inverse);
    if (done) {
        arb_mat_mul(F, inverse, F, prec);
        arb_mat_sub(x, x, F, prec);
        arb_mat_get_mid(x, x);
    }
    arb_mat_clear(F), arb_mat_clear(J);
    return done;
}

/* x - A F(x) + (1 - A J(X)) (X - x) inside X. */
static bool is_proved(arb_mat_t found, const arb_mat_t x, const arb_mat_t A, double width,
                      slong bits, const wanted *to, slong prec)
{
    arb_mat_t X, F, J, rest;
    arb_mat_init(X, 2, 1), arb_mat_init(F, 2, 1), arb_mat_init(J, 2, 2), arb_mat_init(rest, 2, 1);
    arb_mat_set(X, x);
    for (int i = 0; i < 2; i++) {
        mag_ptr radius = arb_radref(arb_mat_entry(X, i, 0));
        mag_set_d(radius, width);
        mag_mul_2exp_si(radius, radius, -bits);
    }
    at(x, to, F, NULL, prec);
    at(X, to, NULL, J, prec);
    arb_mat_mul(J, A, J, prec);
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++) {
            arb_neg(arb_mat_entry(J, i, k), arb_mat_entry(J, i, k));
            if (i == k)
                arb_add_ui(arb_mat_entry(J, i, k), arb_mat_entry(J, i, k), 1, prec);
        }
    arb_mat_sub(rest, X, x, prec);
    arb_mat_mul(rest, J, rest, prec);
    arb_mat_mul(F, A, F, prec);
    arb_mat_sub(found, x, F, prec);
    arb_mat_add(found, found, rest, prec);
    const bool proved = arb_mat_contains(X, found);
    arb_mat_clear(X), arb_mat_clear(F), arb_mat_clear(J), arb_mat_clear(rest);
    return proved;
}

/* The patch near a guess; indeterminate where none is proved. */
static void ball_patch_of(const ball_edges *e, const wanted *to, double left, double right,
                          slong prec)
{
    arb_mat_t x, found, inverse;
    arb_mat_init(x, 2, 1), arb_mat_init(found, 2, 1), arb_mat_init(inverse, 2, 2);
    arb_set_d(arb_mat_entry(x, 0, 0), left);
    arb_set_d(arb_mat_entry(x, 1, 0), right);
    bool proved = false, goes_on = true;
    for (int i = 0; i < 12 && goes_on; i++)
        goes_on = step(x, to, inverse, prec);
    for (slong bits = prec / 2; bits > 8 && goes_on && !proved; bits -= prec / 8)
        proved = is_proved(found, x, inverse, right - left, bits, to, prec);
    if (proved) {
        arb_set(e->left, arb_mat_entry(found, 0, 0));
        arb_set(e->right, arb_mat_entry(found, 1, 0));
    } else {
        arb_indeterminate(e->left);
        arb_indeterminate(e->right);
    }
    arb_mat_clear(x), arb_mat_clear(found), arb_mat_clear(inverse);
}

/* ---- What is drawn ---- */

/* A patch that holds a part of the rounding, in a; in 1 where that is 0. */
static void some_patch(probe *call, bool is_sharp, double *left, double *right)
{
    const double kind = uniform(call), tiny = log_between(call, 1e-15, 1);
    if (is_sharp) {
        *right = 1;
        *left = kind < 0.5 ? -uniform(call) : kind < 0.7 ? -tiny : tiny / 4 - 1;
    } else if (kind < 0.3) { /* no larger than the rounding, s tiny too */
        const double half = chance(call, 0.5) ? tiny / 2 : uniform(call) / 2;
        const double middle = (1 - half) * (2 * uniform(call) - 1);
        *left = middle - half;
        *right = middle + half;
    } else if (kind < 0.45) { /* right edge next to an end */
        *right = near(call, 1);
        *left = *right - log_between(call, 1e-3, 10);
    } else if (kind < 0.6) { /* left edge next to the other */
        *left = near(call, -1);
        *right = 1 + log_between(call, 1e-6, 10);
    } else if (kind < 0.75) { /* |delta| near 1 */
        *left = 1 - log_between(call, 1e-4, 1);
        *right = 1 + log_between(call, 1e-2, 1e3);
    } else if (kind < 0.9) { /* nearly centred */
        *right = log_between(call, 0.1, 1e3);
        *left = -*right * (1 - tiny);
    } else {
        *left = -log_between(call, 1e-2, 1e3);
        *right = log_between(call, 1e-2, 1e3);
    }
    if (chance(call, 0.5)) {
        const double mirrored = -*left;
        *left = -*right;
        *right = mirrored;
    }
}

/* theta, a, A, P, M of a contact; false where they leave the domain. */
static bool some_pressing(probe *call)
{
    const double theta = argument(call, "theta", log_between(call, 1e-4, 1.5));
    const bool is_sharp = chance(call, 0.05);
    const double unit = log_between(call, 1e-3, 1e3);
    const double a = argument(call, "a", is_sharp ? 0 : unit);
    const double A = argument(call, "A", log_between(call, 1e-6, 1e2));
    double left, right;
    some_patch(call, is_sharp, &left, &right);
    if (!(left < right) || left >= (is_sharp ? 0 : 1) || right <= (is_sharp ? 0 : -1))
        return false;
    arb_ptr c = _arb_vec_init(CARRIED + 3);
    const ball_edges e = {c + CARRIED, c + CARRIED + 1};
    arb_set_d(e.left, left * unit);
    arb_set_d(e.right, right * unit);
    arb_set_d(c + CARRIED + 2, a);
    carried_by(c, c + CARRIED + 2, &e, 256);
    const double P = arf_get_d(arb_midref(c + P_OF), ARF_RND_NEAR) * (theta / A);
    const double M = arf_get_d(arb_midref(c + M_OF), ARF_RND_NEAR) * (theta / A);
    _arb_vec_clear(c, CARRIED + 3);
    argument(call, "P", P);
    argument(call, "M", fabs(M) < 1e-40 ? 0 : M);
    return P > 1e-40;
}

/* A contact under the drawn P and M; NULL where M tilts too far, to be drawn again. */
static rwedge_contact *pressed(const probe *call, double f)
{
    const double *v = call->value;
    rwedge_contact *contact = NULL;
    if (rwedge_contact_create(v[THETA], v[ROUNDING], v[COMPLIANCE], f, &contact) != RWEDGE_OK ||
        rwedge_contact_apply(contact, v[LOAD], v[MOMENT], 0, 0) != RWEDGE_OK) {
        rwedge_contact_destroy(contact);
        return NULL;
    }
    return contact;
}

/* The contact's patch in balls, and what it carries. The first CARRIED balls are that; then its
 * edges, a, and A/theta. */
enum { LEFT = CARRIED, RIGHT, A_ROUND, PER_STRESS, PRESSED };

static void ball_pressed(arb_ptr c, const double v[], double P, double M, double left, double right,
                         slong prec)
{
    arb_t load, moment;
    arb_init(load), arb_init(moment);
    arb_set_d(c + A_ROUND, v[ROUNDING]);
    arb_set_d(c + PER_STRESS, v[COMPLIANCE]);
    arb_set_d(load, v[THETA]);
    arb_div(c + PER_STRESS, c + PER_STRESS, load, prec);
    arb_set_d(load, P);
    arb_mul(load, load, c + PER_STRESS, prec);
    arb_set_d(moment, M);
    arb_mul(moment, moment, c + PER_STRESS, prec);
    const ball_edges e = {c + LEFT, c + RIGHT};
    const wanted to = {c + A_ROUND, load, moment, true};
    ball_patch_of(&e, &to, left, right, prec);
    carried_by(c, c + A_ROUND, &e, prec);
    arb_set(c + P_OF, load); /* exactly */
    arb_clear(load), arb_clear(moment);
}

/* 1 - |delta| */
static void flatness(arb_t less, const arb_t tilt, slong prec)
{
    arb_abs(less, tilt);
    arb_neg(less, less);
    arb_add_ui(less, less, 1, prec);
}

/* The width of a patch, or |x| at its edges where that is larger. */
static void reach_of(arb_t reach, const ball_edges *e, slong prec)
{
    arb_t x;
    arb_init(x);
    arb_sub(reach, e->right, e->left, prec);
    arb_abs(x, e->right);
    arb_max(reach, reach, x, prec);
    arb_abs(x, e->left);
    arb_max(reach, reach, x, prec);
    arb_clear(x);
}

/* What |x| at the edges magnifies: the smaller of 1 and width/|x|, times 1 - |delta|. */
static void magnified(arb_t error, arb_ptr c, slong prec)
{
    arb_t factor;
    arb_init(factor);
    const ball_edges e = {c + LEFT, c + RIGHT};
    reach_of(factor, &e, prec);
    arb_div(factor, c + S_HALF, factor, prec);
    arb_mul_2exp_si(factor, factor, 1);
    arb_mul(error, error, factor, prec);
    flatness(factor, c + TILT_OF, prec);
    arb_mul(error, error, factor, prec);
    arb_clear(factor);
}

/* The larger error of two edges over a scale. */
static void edges_error(arb_t error, const double found[2], const ball_edges *e, const arb_t scale,
                        slong prec)
{
    arb_t other;
    arb_init(other);
    error_over(error, found[0], e->left, scale, prec);
    error_over(other, found[1], e->right, scale, prec);
    arb_max(error, error, other, prec);
    arb_clear(other);
}

/* ---- Edges, tilt ---- */

static bool draw_edges(probe *call)
{
    rwedge_contact *contact = some_pressing(call) ? pressed(call, 0.5) : NULL;
    if (!contact)
        return false;
    if (rwedge_contact_edges(contact, &call->result[0], &call->result[1]) != RWEDGE_OK)
        call->result[0] = NAN;
    call->result[2] = rwedge_contact_tilt(contact);
    double *r = call->result;
    if (rwedge_contact_edge_asymptotes(contact, &r[3], &r[4], &r[5], &r[6]) != RWEDGE_OK)
        r[3] = NAN;
    rwedge_contact_destroy(contact);
    return true;
}

static void judge_edges(arb_t error, const probe *call, slong prec)
{
    const double *v = call->value, *r = call->result;
    arb_ptr c = _arb_vec_init(PRESSED + 1);
    ball_pressed(c, v, v[LOAD], v[MOMENT], r[0], r[1], prec);
    const ball_edges e = {c + LEFT, c + RIGHT};
    arb_mul_2exp_si(c + PRESSED, c + S_HALF, 1);
    edges_error(error, r, &e, c + PRESSED, prec);
    magnified(error, c, prec);
    _arb_vec_clear(c, PRESSED + 1);
}

static void judge_tilt(arb_t error, const probe *call, slong prec)
{
    const double *v = call->value, *r = call->result;
    arb_ptr c = _arb_vec_init(PRESSED + 1);
    ball_pressed(c, v, v[LOAD], v[MOMENT], r[0], r[1], prec);
    arb_set_d(c + PRESSED, v[THETA]);
    arb_mul(c + V_OF, c + TILT_OF, c + PRESSED, prec);
    error_over(error, r[2], c + V_OF, c + PRESSED, prec);
    magnified(error, c, prec);
    _arb_vec_clear(c, PRESSED + 1);
}

/* K_N = (2/pi) (theta/A) sqrt(2/s) v at the left edge, with u at the right one; of the edges that
 * were found, because it changes like a root where an edge passes an end of the rounding. */
static void judge_asymptotes(arb_t error, const probe *call, slong prec)
{
    const double *v = call->value, *r = call->result;
    arb_ptr c = _arb_vec_init(PRESSED + 2);
    arb_ptr scale = c + PRESSED, other = c + PRESSED + 1;
    arb_set_d(c + LEFT, r[0]);
    arb_set_d(c + RIGHT, r[1]);
    arb_set_d(c + A_ROUND, v[ROUNDING]);
    const ball_edges e = {c + LEFT, c + RIGHT};
    carried_by(c, c + A_ROUND, &e, prec);
    arb_set_d(c + PER_STRESS, v[COMPLIANCE]);
    arb_set_d(scale, v[THETA]);
    arb_div(c + PER_STRESS, c + PER_STRESS, scale, prec);
    arb_const_pi(scale, prec);
    arb_mul(scale, scale, c + PER_STRESS, prec);
    arb_mul_2exp_si(scale, scale, -1);
    arb_ui_div(other, 2, c + S_HALF, prec);
    arb_sqrt(other, other, prec);
    arb_div(scale, other, scale, prec);
    arb_mul(c + V_OF, c + V_OF, scale, prec);
    arb_mul(c + U_OF, c + U_OF, scale, prec);
    arb_max(scale, c + V_OF, c + U_OF, prec);
    error_over(error, r[3], c + V_OF, scale, prec);
    error_over(other, r[4], c + U_OF, scale, prec);
    arb_max(error, error, other, prec);
    _arb_vec_clear(c, PRESSED + 2);
}

/* ---- Stick zones ---- */

bool draw_slipping(probe *call, rwedge_contact **made)
{
    if (!some_pressing(call))
        return false;
    const double f = argument(call, "f", log_between(call, 0.01, 2));
    rwedge_contact *contact = pressed(call, f);
    if (!contact)
        return false;
    const double part = chance(call, 0.3) ? log_between(call, 1e-12, 0.9) : 0.9 * uniform(call);
    const double Q = argument(call, "Q", either_sign(call, part * f * call->value[LOAD]));
    const double most = rwedge_contact_largest_tension_step(contact, Q);
    const double sigma = argument(
        call, "sigma", most * (chance(call, 0.2) ? either_sign(call, 1) : 2 * uniform(call) - 1));
    double *r = call->result;
    if (rwedge_contact_edges(contact, &r[2], &r[3]) != RWEDGE_OK ||
        rwedge_contact_apply(contact, call->value[LOAD], call->value[MOMENT], Q, sigma) !=
            RWEDGE_OK ||
        rwedge_contact_stick_zone(contact, &r[0], &r[1]) != RWEDGE_OK)
        r[0] = NAN;
    r[4] = most;
    if (made)
        *made = contact;
    else
        rwedge_contact_destroy(contact);
    return true;
}

static bool draw_stick_zone(probe *call)
{
    return draw_slipping(call, NULL);
}

/* |T| = (|Q|/f A/theta, -+A sigma/(4 theta f)), the sign that of Q. */
static void ball_tangential(arb_t load, arb_t tilt, const arb_t per_stress, double f, double Q,
                            double sigma, slong prec)
{
    arb_t friction;
    arb_init(friction);
    arb_set_d(friction, f);
    arb_set_d(load, fabs(Q));
    arb_set_d(tilt, Q < 0 ? sigma : -sigma);
    arb_mul(load, load, per_stress, prec);
    arb_div(load, load, friction, prec);
    arb_mul(tilt, tilt, per_stress, prec);
    arb_div(tilt, tilt, friction, prec);
    arb_mul_2exp_si(tilt, tilt, -2);
    arb_clear(friction);
}

/* Of the width of the contact, over 1 - |delta| of both, and the root of what sticks of P. */
static void judge_front(arb_t error, const double found[2], arb_ptr c, const arb_t load,
                        const arb_t tilt, slong prec)
{
    arb_ptr w = _arb_vec_init(4);
    const ball_edges e = {w, w + 1};
    const wanted to = {c + A_ROUND, load, tilt, false};
    ball_patch_of(&e, &to, found[0], found[1], prec);
    flatness(w + 2, tilt, prec);
    flatness(w + 3, c + TILT_OF, prec);
    arb_min(w + 2, w + 2, w + 3, prec);
    arb_div(w + 3, load, c + P_OF, prec);
    arb_sqrt(w + 3, w + 3, prec);
    arb_mul(w + 2, w + 2, w + 3, prec);
    const ball_edges whole = {c + LEFT, c + RIGHT};
    reach_of(w + 3, &whole, prec);
    arb_div(w + 2, w + 3, w + 2, prec);
    edges_error(error, found, &e, w + 2, prec);
    _arb_vec_clear(w, 4);
}

/* Load and tilt of what sticks; c as of ball_pressed(). */
static void ball_sticking(arb_ptr c, arb_t load, arb_t tilt, const probe *call, slong prec)
{
    const double *v = call->value, *r = call->result;
    ball_pressed(c, v, v[LOAD], v[MOMENT], r[2], r[3], prec);
    ball_tangential(load, tilt, c + PER_STRESS, v[FRICTION], v[SHEAR], v[TENSION], prec);
    arb_sub(load, c + P_OF, load, prec);
    arb_sub(tilt, c + TILT_OF, tilt, prec);
}

void ball_slipping(const ball_edges *stick, const ball_edges *whole, const probe *call, slong prec)
{
    arb_ptr c = _arb_vec_init(PRESSED + 2);
    arb_ptr load = c + PRESSED, tilt = c + PRESSED + 1;
    ball_sticking(c, load, tilt, call, prec);
    const wanted to = {c + A_ROUND, load, tilt, false};
    ball_patch_of(stick, &to, call->result[0], call->result[1], prec);
    arb_set(whole->left, c + LEFT);
    arb_set(whole->right, c + RIGHT);
    _arb_vec_clear(c, PRESSED + 2);
}

static void judge_stick_zone(arb_t error, const probe *call, slong prec)
{
    arb_ptr c = _arb_vec_init(PRESSED + 2);
    arb_ptr load = c + PRESSED, tilt = c + PRESSED + 1;
    ball_sticking(c, load, tilt, call, prec);
    judge_front(error, call->result, c, load, tilt, prec);
    _arb_vec_clear(c, PRESSED + 2);
}

static void judge_tension_step(arb_t error, const probe *call, slong prec)
{
    const double *v = call->value, *r = call->result;
    arb_ptr c = _arb_vec_init(PRESSED + 1);
    ball_pressed(c, v, v[LOAD], v[MOMENT], r[2], r[3], prec);
    arb_set_d(c + PRESSED, 4 * fabs(v[SHEAR]));
    arb_div(c + PRESSED, c + PRESSED, c + S_HALF, prec);
    arb_const_pi(c + V_OF, prec);
    arb_div(c + PRESSED, c + PRESSED, c + V_OF, prec);
    relative_error(error, r[4], c + PRESSED, prec);
    magnified(error, c, prec);
    _arb_vec_clear(c, PRESSED + 1);
}

/* ---- What never slips ---- */

enum { SECOND_LOAD = FRICTION + 1, SECOND_MOMENT, Q1, Q2, S1, S2 };

static bool draw_permanent(probe *call)
{
    if (!some_pressing(call))
        return false;
    const double *v = call->value, f = argument(call, "f", log_between(call, 0.01, 2));
    const double grown = chance(call, 0.5) ? 1 : between(call, 0.8, 1.25);
    const double P = argument(call, "P2", v[LOAD] * grown);
    const double M = argument(call, "M2", v[MOMENT] * grown);
    const double least = f * fmin(P, v[LOAD]);
    double *r = call->result;
    rwedge_contact *contact = pressed(call, f), *other = NULL;
    const double one = argument(call, "Q1", least * (1.8 * uniform(call) - 0.9));
    const double two = argument(call, "Q2", least * (1.8 * uniform(call) - 0.9));
    const double most = contact ? rwedge_contact_largest_tension_step(contact, two - one) : 0;
    const double from = argument(call, "sigma1", 0.3 * most * uniform(call));
    const double to = argument(call, "sigma2", from + most * (1.8 * uniform(call) - 0.9));
    bool is_drawn =
        contact &&
        rwedge_contact_create(v[THETA], v[ROUNDING], v[COMPLIANCE], f, &other) == RWEDGE_OK &&
        rwedge_contact_apply(other, P, M, 0, 0) == RWEDGE_OK &&
        rwedge_permanent_stick(v[THETA], v[ROUNDING], v[COMPLIANCE], f, v[LOAD], v[MOMENT], one,
                               from, P, M, two, to, &r[0], &r[1]) == RWEDGE_OK;
    if (is_drawn) {
        rwedge_contact_edges(contact, &r[2], &r[3]);
        rwedge_contact_edges(other, &r[4], &r[5]);
    }
    rwedge_contact_destroy(contact);
    rwedge_contact_destroy(other);
    return is_drawn;
}

/* (N1 + N2 - |T2 - T1|)/2 */
static void judge_permanent(arb_t error, const probe *call, slong prec)
{
    const double *v = call->value, *r = call->result;
    arb_ptr c = _arb_vec_init(2 * PRESSED + 4);
    arb_ptr other = c + PRESSED, load = other + PRESSED, tilt = load + 1, u = load + 2,
            w = load + 3;
    ball_pressed(c, v, v[LOAD], v[MOMENT], r[2], r[3], prec);
    ball_pressed(other, v, v[SECOND_LOAD], v[SECOND_MOMENT], r[4], r[5], prec);
    const double sign = v[Q2] < v[Q1] ? -1 : 1;
    ball_tangential(load, tilt, c + PER_STRESS, v[FRICTION], sign, sign, prec); /* 1, and -1/4 */
    arb_set_d(u, v[Q2]);
    arb_set_d(w, v[Q1]);
    arb_sub(u, u, w, prec);
    arb_abs(u, u);
    arb_mul(load, load, u, prec);
    arb_set_d(u, v[S2]);
    arb_set_d(w, v[S1]);
    arb_sub(u, u, w, prec);
    if (sign < 0)
        arb_neg(u, u);
    arb_abs(tilt, tilt);
    arb_mul(tilt, tilt, u, prec);
    arb_neg(tilt, tilt);
    arb_sub(load, other + P_OF, load, prec);
    arb_add(load, load, c + P_OF, prec);
    arb_mul_2exp_si(load, load, -1);
    arb_sub(tilt, other + TILT_OF, tilt, prec);
    arb_add(tilt, tilt, c + TILT_OF, prec);
    arb_mul_2exp_si(tilt, tilt, -1);
    judge_front(error, r, arb_gt(other + P_OF, c + P_OF) ? other : c, load, tilt, prec);
    _arb_vec_clear(c, 2 * PRESSED + 4);
}

/* ---- A history of stresses: the bits of single calls ---- */

static bool draw_stress_history(probe *call)
{
    enum { LOADS = 3 };
    if (!some_pressing(call))
        return false;
    const double *v = call->value, f = argument(call, "f", log_between(call, 0.01, 2));
    rwedge_contact *one = pressed(call, f), *other = NULL;
    if (!one || rwedge_contact_copy(one, &other) != RWEDGE_OK) {
        rwedge_contact_destroy(one);
        return false;
    }
    const double b = rwedge_contact_half_width(one);
    const double x = argument(call, "x", b * (4 * uniform(call) - 2)),
                 y = argument(call, "y", b * uniform(call));
    double P[LOADS], M[LOADS], Q[LOADS], sigma[LOADS], s[3][LOADS], single[3];
    for (int i = 0; i < LOADS; i++) {
        P[i] = v[LOAD];
        M[i] = v[MOMENT];
        Q[i] = f * v[LOAD] * (i == 1 ? -0.8 : 0.8) * uniform(call);
        sigma[i] = 0;
    }
    int32_t status =
        rwedge_contact_stress_history(one, LOADS, P, M, Q, sigma, 1, &x, &y, s[0], s[1], s[2]);
    for (int i = 0; i < LOADS && status == RWEDGE_OK; i++) {
        status = rwedge_contact_apply(other, P[i], M[i], Q[i], sigma[i]);
        if (status == RWEDGE_OK)
            status = rwedge_contact_stresses(other, 1, &x, &y, &single[0], &single[1], &single[2]);
        for (int k = 0; k < 3; k++)
            call->result[0] = fmax(call->result[0], fabs(s[k][i] - single[k]));
    }
    rwedge_contact_destroy(one);
    rwedge_contact_destroy(other);
    return status == RWEDGE_OK;
}

static void judge_the_same(arb_t error, const probe *call, slong prec)
{
    (void)prec;
    arb_set_d(error, call->result[0]);
}

#define PATCHES "M; edges dense at -a, a; s from 1e-15 a; \\|delta\\| to 1 - 1e-9"

const row ECCENTRIC_ROWS[] = {
    {"contact_edges", PATCHES, "of the width or \\|x\\|, over 1 - \\|delta\\|", 1e-14, "1e-14", 1,
     draw_edges, judge_edges},
    {"contact_tilt", PATCHES, "of theta max(1, \\|x\\|/width), over 1 - \\|delta\\|", 1e-14,
     "1e-14", 1, draw_edges, judge_tilt},
    {"contact_edge_asymptotes", PATCHES, "of the larger K_N of the edges found", 1e-14, "1e-14", 1,
     draw_edges, judge_asymptotes},
    {"contact_stick_zone", "also Q to 0.9 f P, sigma to its limit",
     "of the contact's width or \\|x\\|, over 1 - \\|delta\\| and the root of what sticks of P",
     1e-14, "1e-14", 1, draw_stick_zone, judge_stick_zone},
    {"contact_largest_tension_step", "the same",
     "relative, times max(1, \\|x\\|/width), over 1 - \\|delta\\|", 1e-14, "1e-14", 1,
     draw_stick_zone, judge_tension_step},
    {"permanent_stick", "P, M constant or in proportion",
     "of the contact's width or \\|x\\|, over 1 - \\|delta\\| and the root of what sticks of P",
     1e-14, "1e-14", 1, draw_permanent, judge_permanent},
    {"contact_stress_history", "three loads", "from `contact_stresses`", 0, "the same", 0.3,
     draw_stress_history, judge_the_same},
    {0},
};
