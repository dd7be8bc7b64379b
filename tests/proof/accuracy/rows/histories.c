/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contacts with a load history: half-widths, tractions, stresses, slip, energy, distance from
 * yield. */
#include <float.h>
#include <math.h>

#include "references/energy.h"
#include "references/field.h"
#include "references/memory.h"
#include "rows/rows.h"
#include "rwedge.h"

/* ---- Random histories ---- */

/* Loads of every kind: growing, falling, repeated, in full sliding; never closer to each other
 * than 1e-3 without being equal, because the library takes loads within rounding of each other
 * for equal. */
static void some_loads(probe *call, double f, double unit)
{
    const int count = 1 + (int)(uniform(call) * uniform(call) * LOADS_MAX);
    double P = unit * log_between(call, 0.01, 10), Q = 0;
    for (int i = 0; i < count; i++) {
        const double kind = uniform(call), old = P;
        if (i > 1 && kind < 0.2) { /* back to an earlier load */
            const int again = (int)(uniform(call) * i);
            P = call->P[again];
            Q = call->Q[again];
        } else {
            if (kind > 0.5)
                P = unit * log_between(call, 0.01, 10);
            if (fabs(P / old - 1) < 1e-3)
                P = old;
            const double how = uniform(call);
            Q = f * P *
                (how < 0.08   ? 1
                 : how < 0.16 ? -1
                 : how < 0.2  ? 0
                              : between(call, -0.999, 0.999));
        }
        call->P[i] = P;
        call->Q[i] = Q;
    }
    call->loads = count;
}

enum { THETA, ROUNDING, COMPLIANCE, FRICTION };

static void destroy(void *contact)
{
    rwedge_contact_destroy(contact);
}

/* The contact under its last load. Where a load is refused, NULL and the result NaN: a failure,
 * because all that is drawn is in the domain. */
static rwedge_contact *some_contact(probe *call)
{
    const double theta = argument(call, "theta", log_between(call, 1e-4, 1)),
                 A = argument(call, "A", log_between(call, 1e-6, 1));
    const double kind = uniform(call), b = log_between(call, 1e-3, 10);
    const double a = argument(call, "a",
                              kind < 0.1   ? 0
                              : kind < 0.2 ? b * 20
                                           : b * log_between(call, 1e-6, 2));
    const double f = argument(call, "f", log_between(call, 0.01, 3));
    some_loads(call, f, theta / A * b);
    call->result[0] = NAN;
    rwedge_contact *contact = NULL;
    if (rwedge_contact_create(theta, a, A, f, &contact) != RWEDGE_OK)
        return NULL;
    call->object = contact;
    call->release = destroy;
    for (int i = 0; i < call->loads; i++)
        if (rwedge_contact_load(contact, call->P[i], call->Q[i]) != RWEDGE_OK)
            return NULL;
    return contact;
}

/* Next to an edge of some load, of slip, of the rounding; or anywhere in the contact. */
static double some_contact_place(probe *call, const rwedge_contact *contact)
{
    const double *v =
        call->arguments ? (const double[]){call->value[0], call->value[2], call->value[1]} : 0;
    const double b = rwedge_contact_half_width(contact),
                 c = rwedge_contact_stick_half_width(contact);
    const double P = call->P[(int)(uniform(call) * call->loads)], kind = uniform(call);
    const double mark = kind < 0.2   ? b
                        : kind < 0.4 ? c
                        : kind < 0.5 ? v[1]
                        : kind < 0.6 ? rwedge_half_width(v[0], v[1], v[2], P)
                                     : b * uniform(call);
    return either_sign(call, fabs(mark + either_sign(call, mark * log_between(call, 1e-14, 1))));
}

/* ---- The exact state ---- */

typedef struct {
    const probe *call;
    arb_t theta, a, A, f, unit; /* unit: theta/A */
    path now;
} state;

static void state_init(state *s, const probe *call, slong prec)
{
    s->call = call;
    arb_init(s->theta), arb_init(s->a), arb_init(s->A), arb_init(s->f), arb_init(s->unit);
    arb_set_d(s->theta, call->value[0]);
    arb_set_d(s->A, call->value[1]);
    arb_set_d(s->a, call->value[2]);
    arb_set_d(s->f, call->value[3]);
    arb_div(s->unit, s->theta, s->A, prec);
    path_init(&s->now);
}

static void state_clear(state *s)
{
    arb_clear(s->theta), arb_clear(s->a), arb_clear(s->A), arb_clear(s->f), arb_clear(s->unit);
    path_clear(&s->now);
}

/* P and Q/f of a load; to 8 epsilon full sliding is full sliding. */
static void load_of(arb_t load, arb_t shear, const state *s, int i, slong prec)
{
    const double P = s->call->P[i], Q = s->call->Q[i], f = s->call->value[3];
    const double last = i > 0 ? s->call->P[i - 1] : 0;
    arb_set_d(load, P);
    arb_set_d(shear, Q);
    arb_div(shear, shear, s->f, prec);
    if (fabs(fabs(Q) - f * P) <= 8 * DBL_EPSILON * f * fmax(P, last))
        arb_mul_si(shear, load, Q > 0 ? 1 : -1, prec);
}

static void advance(state *s, int i, slong prec)
{
    arb_t load, shear;
    arb_init(load), arb_init(shear);
    load_of(load, shear, s, i, prec);
    path_advance(&s->now, load, shear, prec);
    arb_clear(load), arb_clear(shear);
}

static void run_history(state *s, slong prec)
{
    for (int i = 0; i < s->call->loads; i++)
        advance(s, i, prec);
}

/* The half-width under a load of the path. */
static void width_of(arb_t width, const state *s, const arb_t load, slong prec)
{
    const double *v = s->call->value;
    const double guess =
        rwedge_half_width(v[0], v[2], v[1], arf_get_d(arb_midref(load), ARF_RND_NEAR));
    arb_t force;
    arb_init(force);
    arb_div(force, load, s->unit, prec);
    ball_half_width(width, s->a, force, guess, prec);
    arb_clear(force);
}

/* D of the corner less that beyond it. */
static void weight_of(arb_t weight, const path *p, int i, slong prec)
{
    arb_set(weight, p->corners[i].ratio);
    if (i + 1 < p->count)
        arb_sub(weight, weight, p->corners[i + 1].ratio, prec);
}

/* D is a quotient of differences of loads. How much it magnifies their rounding where they are
 * close to each other; 1 where they differ by 1e-2 of the load or more. */
static double closeness(const probe *call)
{
    double factor = 1;
    for (int i = 1; i < call->loads; i++)
        if (call->P[i] != call->P[i - 1])
            factor = fmax(factor, 1e-2 * call->P[i] / fabs(call->P[i] - call->P[i - 1]));
    return factor;
}

/* A load of the diagram has the rounding of the largest one: by how much more than 1e-14 a
 * half-width may be off. */
static double looseness(const state *s, int i)
{
    double largest = 0;
    for (int j = 0; j < s->call->loads; j++)
        largest = fmax(largest, s->call->P[j]);
    return fmax(1, largest / arf_get_d(arb_midref(s->now.corners[i].load), ARF_RND_NEAR));
}

/* ---- Half-widths ---- */

static bool draw_half_width(probe *call)
{
    const rwedge_contact *contact = some_contact(call);
    call->result[0] = rwedge_contact_half_width(contact);
    return true;
}

static void judge_half_width(arb_t error, const probe *call, slong prec)
{
    state s;
    arb_t b;
    arb_init(b);
    state_init(&s, call, prec);
    run_history(&s, prec);
    width_of(b, &s, s.now.corners[s.now.count - 1].load, prec);
    relative_error(error, call->result[0], b, prec);
    state_clear(&s);
    arb_clear(b);
}

static bool draw_stick(probe *call)
{
    const rwedge_contact *contact = some_contact(call);
    call->result[0] = rwedge_contact_stick_half_width(contact);
    return true;
}

/* Whether the ring that ends at the corner slips, with that sign. */
static bool slips(const corner *ring, int sign, slong prec)
{
    arb_t below, one;
    arb_init(below), arb_init(one);
    arb_one(one);
    arb_mul_si(below, ring->ratio, sign, prec);
    arb_sub(below, one, below, prec);
    const bool result = sign_beside(below, one, prec - 40) == 0;
    arb_clear(below), arb_clear(one);
    return result;
}

/* The error is that of the stick zone's load, relative to the largest load. */
static void judge_stick(arb_t error, const probe *call, slong prec)
{
    state s;
    arb_t c;
    arb_init(c);
    state_init(&s, call, prec);
    run_history(&s, prec);
    int stick = s.now.count - 1;
    const int sign = arf_sgn(arb_midref(s.now.corners[stick].ratio));
    while (stick > 0 && sign != 0 && slips(&s.now.corners[stick], sign, prec))
        stick--;
    if (stick > 0)
        width_of(c, &s, s.now.corners[stick].load, prec);
    relative_error(error, call->result[0], c, prec);
    if (stick > 0) {
        arb_set_d(c, looseness(&s, stick));
        arb_div(error, error, c, prec);
    }
    state_clear(&s);
    arb_clear(c);
}

/* ---- Tractions ---- */

static bool draw_tractions(probe *call, int which)
{
    const rwedge_contact *contact = some_contact(call);
    if (!contact)
        return true;
    const double x = argument(call, "x", some_contact_place(call, contact));
    double p, q;
    if (rwedge_contact_tractions(contact, 1, &x, &p, &q) != RWEDGE_OK)
        p = q = NAN;
    call->result[0] = which ? q : p;
    return x != 0;
}

static bool draw_pressure(probe *call)
{
    return draw_tractions(call, 0);
}

static bool draw_shear(probe *call)
{
    return draw_tractions(call, 1);
}

/* By how much the pressure of a patch changes if its half-widths are off by 1e-14 and by the
 * rounding of their load. */
static void change_by_width(arb_t change, const state *s, int i, const arb_t width, const arb_t x,
                            slong prec)
{
    arb_t other, p;
    arb_init(other), arb_init(p);
    arb_zero(change);
    for (int sign = -1; sign <= 1; sign += 2) {
        arb_set_d(other, 1e-14 * looseness(s, i) * sign);
        arb_add_ui(other, other, 1, prec);
        arb_mul(other, other, width, prec);
        ball_pressure(p, s->a, other, x, prec);
        arb_addmul_si(change, p, sign, prec);
    }
    arb_abs(change, change);
    arb_clear(other), arb_clear(p);
}

/* result, over 1e-13 (theta/A + |p|) f and what half-widths off by 1e-14 change, times 1e-13;
 * for the pressure over 1e-12 |p| and that, times 1e-12. */
static void judge_tractions(arb_t error, const probe *call, bool shear, slong prec)
{
    state s;
    arb_ptr w = _arb_vec_init(8);
    arb_ptr x = w, width = w + 1, p = w + 2, q = w + 3, weight = w + 4, change = w + 5, sum = w + 6,
            u = w + 7;
    state_init(&s, call, prec);
    run_history(&s, prec);
    arb_set_d(x, call->value[4]);
    for (int i = 1; i < s.now.count; i++) {
        width_of(width, &s, s.now.corners[i].load, prec);
        ball_pressure(p, s.a, width, x, prec);
        weight_of(weight, &s.now, i, prec);
        arb_addmul(q, weight, p, prec);
        change_by_width(change, &s, i, width, x, prec);
        arb_abs(weight, weight);
        arb_addmul(sum, weight, change, prec);
    }
    const double promised = shear ? 1e-13 : 1e-12;
    arb_set_d(u, promised);
    if (shear) {
        arb_mul(q, q, s.f, prec);
        arb_abs(p, p);
        arb_add_ui(p, p, 1, prec);
        arb_div(sum, sum, u, prec);
        arb_add(sum, sum, p, prec);
        arb_mul(sum, sum, s.f, prec);
    } else {
        arb_set(q, p);
        arb_abs(p, p);
        arb_div(sum, change, u, prec);
        arb_add(sum, sum, p, prec);
    }
    arb_mul(q, q, s.unit, prec);
    arb_mul(sum, sum, s.unit, prec);
    arb_set_d(u, closeness(call));
    arb_mul(sum, sum, u, prec);
    error_over(error, call->result[0], q, sum, prec);
    _arb_vec_clear(w, 8);
    state_clear(&s);
}

static void judge_pressure(arb_t error, const probe *call, slong prec)
{
    judge_tractions(error, call, false, prec);
}

static void judge_shear(arb_t error, const probe *call, slong prec)
{
    judge_tractions(error, call, true, prec);
}

/* ---- Stresses ---- */

static bool draw_stresses(probe *call)
{
    const rwedge_contact *contact = some_contact(call);
    if (!contact)
        return true;
    const double b = rwedge_contact_half_width(contact), kind = uniform(call);
    double x = some_contact_place(call, contact),
           y = kind < 0.2 ? 0 : b * log_between(call, 1e-15, 3);
    if (kind > 0.9) {
        x *= log_between(call, 1, 1e4);
        y *= log_between(call, 1, 1e4);
    }
    argument(call, "x", x);
    argument(call, "y", y);
    double *r = call->result;
    if (rwedge_contact_stresses(contact, 1, &x, &y, &r[0], &r[1], &r[2]) != RWEDGE_OK)
        r[0] = NAN;
    return x != 0 || y != 0;
}

/* The traction of the state; with one corner, that of its patch alone. */
static void traction_of(traction *t, const state *s, int only, double stretch, double nu,
                        slong prec)
{
    arb_t width, weight, factor;
    arb_init(width), arb_init(weight), arb_init(factor);
    traction_init(t, s->a, s->f, nu, prec);
    for (int i = 1; i < s->now.count; i++) {
        if (only > 0 && i != only)
            continue;
        width_of(width, s, s->now.corners[i].load, prec);
        arb_set_d(factor, stretch);
        arb_addmul(width, width, factor, prec);
        weight_of(weight, &s->now, i, prec);
        traction_add(t, width, weight, prec);
        t->shear_alone = i + 1 < s->now.count;
    }
    arb_clear(width), arb_clear(weight), arb_clear(factor);
}

/* The norm of a tensor sxx, syy, txy. */
static void norm_of(arb_t norm, arb_srcptr s, slong prec)
{
    arb_t u;
    arb_init(u);
    arb_mul(norm, s, s, prec);
    arb_addmul(norm, s + 1, s + 1, prec);
    arb_mul(u, s + 2, s + 2, prec);
    arb_addmul_ui(norm, u, 2, prec);
    arb_sqrtpos(norm, norm, prec);
    arb_clear(u);
}

/* The norms of what half-widths off by 1e-14, and by what their load's rounding is, change in
 * the stresses of the patches. */
static void stress_change_by_widths(arb_t sum, const state *s, const acb_t z, slong prec)
{
    arb_ptr w = _arb_vec_init(7);
    arb_ptr change = w, one = w + 1, other = w + 4;
    arb_zero(sum);
    for (int i = 1; i < s->now.count; i++) {
        traction t;
        traction_of(&t, s, i, -1e-14 * looseness(s, i), 0, prec);
        ball_stresses(one, one + 1, one + 2, &t, z, prec);
        traction_clear(&t);
        traction_of(&t, s, i, 1e-14 * looseness(s, i), 0, prec);
        ball_stresses(other, other + 1, other + 2, &t, z, prec);
        traction_clear(&t);
        _arb_vec_sub(one, one, other, 3, prec);
        norm_of(change, one, prec);
        arb_add(sum, sum, change, prec);
    }
    _arb_vec_clear(w, 7);
}

/* Per remembered point: the larger of the norm and 1/(1+|z|/b), and what half-widths change,
 * over 1e-13. */
static void stress_scale(arb_t scale, const state *s, arb_srcptr stresses, const acb_t z,
                         slong prec)
{
    arb_t far, change;
    arb_init(far), arb_init(change);
    width_of(change, s, s->now.corners[s->now.count - 1].load, prec);
    acb_abs(far, z, prec);
    arb_div(far, far, change, prec);
    arb_add_ui(far, far, 1, prec);
    arb_inv(far, far, prec);
    norm_of(scale, stresses, prec);
    arb_max(scale, scale, far, prec);
    arb_mul_ui(scale, scale, (ulong)s->now.count - 1, prec);
    stress_change_by_widths(change, s, z, prec);
    arb_set_d(far, 1e-13);
    arb_div(change, change, far, prec);
    arb_add(scale, scale, change, prec);
    arb_clear(far), arb_clear(change);
}

static void judge_stresses(arb_t error, const probe *call, slong prec)
{
    state s;
    arb_ptr w = _arb_vec_init(5);
    arb_ptr scale = w + 3, one = w + 4;
    acb_t z;
    traction t;
    acb_init(z);
    acb_set_d_d(z, call->value[4], call->value[5]);
    state_init(&s, call, prec);
    run_history(&s, prec);
    traction_of(&t, &s, 0, 0, 0, prec);
    ball_stresses(w, w + 1, w + 2, &t, z, prec);
    stress_scale(scale, &s, w, z, prec);
    arb_set_d(one, closeness(call));
    arb_mul(scale, scale, one, prec);
    arb_mul(scale, scale, s.unit, prec);
    arb_zero(error);
    for (int i = 0; i < 3; i++) {
        arb_mul(w + i, w + i, s.unit, prec);
        error_over(one, call->result[i], w + i, scale, prec);
        arb_max(error, error, one, prec);
    }
    traction_clear(&t);
    state_clear(&s);
    acb_clear(z);
    _arb_vec_clear(w, 5);
}

/* ---- Slip ---- */

static bool draw_slip(probe *call)
{
    const rwedge_contact *contact = some_contact(call);
    if (!contact)
        return true;
    const double x = argument(call, "x", some_contact_place(call, contact));
    if (fabs(x) > rwedge_contact_half_width(contact))
        return false;
    if (rwedge_contact_slip(contact, 1, &x, &call->result[0]) != RWEDGE_OK)
        call->result[0] = NAN;
    return true;
}

/* (x X - L - max(x - alpha, 0)^2)/(2 alpha), L = arcosh x, X = sqrt(x^2-1): Hertz. */
static void hertz_gap(arb_t gap, const arb_t alpha, const arb_t x, const arb_t X, const arb_t L,
                      slong prec)
{
    arb_t beyond;
    arb_init(beyond);
    arb_mul(gap, x, X, prec);
    arb_sub(gap, gap, L, prec);
    arb_sub(beyond, x, alpha, prec);
    if (arb_is_positive(beyond))
        arb_submul(gap, beyond, beyond, prec);
    arb_div(gap, gap, alpha, prec);
    arb_mul_2exp_si(gap, gap, -1);
    arb_clear(beyond);
}

/* x - int G dx, int G = x G - (2/(pi alpha)) [(x^2-alpha^2) M/2 - alpha c0 L/2 - phi0 (x X +
 * L)/2], which is 1 at x = 1, with G = (2/pi) [atan(c0/X) + x M/alpha - phi0 X/alpha] and M =
 * atan(tan(phi0) X/x): in all x - (2/pi) [x atan(c0/X) + (x^2+alpha^2) M/(2 alpha) + c0 L/2 -
 * phi0 (x X - L)/(2 alpha)]. */
static void rounded_gap(arb_t gap, const arb_t alpha, const arb_t x, const arb_t X, const arb_t L,
                        slong prec)
{
    arb_ptr w = _arb_vec_init(6);
    arb_ptr one = w, phi0 = w + 1, c0 = w + 2, M = w + 3, u = w + 4, v = w + 5;
    arb_one(one);
    ball_angle(phi0, c0, alpha, one, prec);
    arb_mul(u, alpha, X, prec);
    arb_mul(v, c0, x, prec);
    arb_atan2(M, u, v, prec);
    arb_mul(u, x, x, prec);
    arb_addmul(u, alpha, alpha, prec);
    arb_mul(M, M, u, prec);
    arb_mul(u, x, X, prec);
    arb_sub(u, u, L, prec);
    arb_submul(M, u, phi0, prec);
    arb_div(M, M, alpha, prec);
    arb_addmul(M, c0, L, prec);
    arb_mul_2exp_si(M, M, -1);
    arb_atan2(u, c0, X, prec);
    arb_addmul(M, u, x, prec);
    arb_const_pi(v, prec);
    arb_div(M, M, v, prec);
    arb_mul_2exp_si(M, M, 1);
    arb_sub(gap, x, M, prec);
    _arb_vec_clear(w, 6);
}

/* alpha -> 0: x - (2/pi) [x atan(1/X) + L]. */
static void sharp_gap(arb_t gap, const arb_t x, const arb_t X, const arb_t L, slong prec)
{
    arb_t u;
    arb_init(u);
    arb_inv(u, X, prec);
    arb_atan(u, u, prec);
    arb_mul(u, u, x, prec);
    arb_add(u, u, L, prec);
    arb_const_pi(gap, prec);
    arb_div(u, u, gap, prec);
    arb_mul_2exp_si(u, u, 1);
    arb_sub(gap, x, u, prec);
    arb_clear(u);
}

/* How far the profile lies above the surface that a contact of that half-width deforms, over
 * theta. */
static void ball_gap(arb_t gap, const arb_t a, const arb_t width, const arb_t place, slong prec)
{
    arb_ptr w = _arb_vec_init(4);
    arb_ptr alpha = w, x = w + 1, X = w + 2, L = w + 3;
    arb_div(x, place, width, prec);
    arb_sub_ui(X, x, 1, prec);
    if (!arb_is_positive(X)) {
        arb_zero(gap);
    } else {
        arb_add_ui(L, x, 1, prec);
        arb_mul(X, X, L, prec);
        arb_sqrt(X, X, prec);
        arb_asinh(L, X, prec);
        arb_div(alpha, a, width, prec);
        if (arb_is_zero(a))
            sharp_gap(gap, x, X, L, prec);
        else if (arb_lt(a, width))
            rounded_gap(gap, alpha, x, X, L, prec);
        else
            hertz_gap(gap, alpha, x, X, L, prec);
        arb_mul(gap, gap, width, prec);
    }
    _arb_vec_clear(w, 4);
}

/* sum (D_i - D_(i+1)) gap_i(x) - D_1 h(x): the displacement of a path over f theta. */
static void add_displacement(arb_t sum, int sign, const state *s, const path *p, const arb_t x,
                             slong prec)
{
    if (p->count < 2)
        return;
    arb_ptr w = _arb_vec_init(4);
    arb_ptr width = w, gap = w + 1, weight = w + 2, total = w + 3;
    for (int i = 1; i < p->count; i++) {
        width_of(width, s, p->corners[i].load, prec);
        ball_gap(gap, s->a, width, x, prec);
        weight_of(weight, p, i, prec);
        arb_addmul(total, weight, gap, prec);
    }
    if (arb_lt(x, s->a)) { /* the profile */
        arb_mul(gap, x, x, prec);
        arb_div(gap, gap, s->a, prec);
        arb_mul_2exp_si(gap, gap, -1);
    } else {
        arb_mul_2exp_si(gap, s->a, -1);
        arb_sub(gap, x, gap, prec);
    }
    arb_submul(total, p->corners[1].ratio, gap, prec);
    arb_addmul_si(sum, total, sign, prec);
    _arb_vec_clear(w, 4);
}

/* The path when the load passed u on its way up. */
static void enter(path *entry, const state *before, int i, const arb_t u, slong prec)
{
    arb_ptr w = _arb_vec_init(3);
    const corner *from = &before->now.corners[before->now.count - 1];
    load_of(w, w + 1, before, i, prec);
    arb_sub(w, w, from->load, prec);
    arb_sub(w + 1, w + 1, from->shear, prec);
    arb_sub(w + 2, u, from->load, prec);
    arb_div(w + 2, w + 2, w, prec);
    arb_mul(w + 1, w + 1, w + 2, prec);
    arb_add(w + 1, w + 1, from->shear, prec);
    path_copy(entry, &before->now);
    path_advance(entry, u, w + 1, prec);
    _arb_vec_clear(w, 3);
}

/* w of the present path less w of the path at entry, over f theta b. */
static void judge_slip(arb_t error, const probe *call, slong prec)
{
    state s;
    path entry;
    arb_ptr w = _arb_vec_init(5);
    arb_ptr x = w, u = w + 1, slip = w + 2, b = w + 3, P = w + 4;
    path_init(&entry);
    state_init(&s, call, prec);
    arb_set_d(x, fabs(call->value[4]));
    ball_force(u, s.a, x, prec);
    arb_mul(u, u, s.unit, prec);
    arb_set_d(P, call->P[call->loads - 1]);
    arb_min(u, u, P, prec);
    for (int i = 0; i < call->loads; i++) {
        arb_set_d(P, call->P[i]);
        if (arb_lt(s.now.corners[s.now.count - 1].load, u) && arb_ge(P, u))
            enter(&entry, &s, i, u, prec);
        advance(&s, i, prec);
    }
    add_displacement(slip, 1, &s, &s.now, x, prec);
    add_displacement(slip, -1, &s, &entry, x, prec);
    arb_mul(slip, slip, s.f, prec);
    arb_mul(slip, slip, s.theta, prec);
    width_of(b, &s, s.now.corners[s.now.count - 1].load, prec);
    arb_mul(b, b, s.f, prec);
    arb_mul(b, b, s.theta, prec);
    arb_set_d(u, closeness(call));
    arb_mul(b, b, u, prec);
    error_over(error, call->result[0], slip, b, prec);
    path_clear(&entry);
    state_clear(&s);
    _arb_vec_clear(w, 5);
}

/* ---- Energy ---- */

static bool draw_energy(probe *call)
{
    const rwedge_contact *contact = some_contact(call);
    call->result[0] = rwedge_contact_dissipated_energy(contact);
    return true;
}

/* The shares of all loads; each is allowed 1e-14 and four epsilon of the largest load over how
 * far Q/f gets ahead of what sticks, or over the new load. Shares of that rounding alone, A (f P
 * epsilon)^2, count as none. */
static void judge_energy(arb_t error, const probe *call, slong prec)
{
    state s;
    arb_ptr w = _arb_vec_init(8);
    arb_ptr load = w, shear = w + 1, share = w + 2, sum = w + 3, scale = w + 4, ahead = w + 5,
            u = w + 6, P = w + 7;
    state_init(&s, call, prec);
    for (int i = 0; i < call->loads; i++) {
        load_of(load, shear, &s, i, prec);
        ball_dissipation(share, ahead, &s.now, load, shear, s.a, s.unit, prec);
        arb_add(sum, sum, share, prec);
        arb_add(scale, scale, share, prec);
        arb_max(P, P, load, prec);
        if (sign_beside(ahead, P, prec) > 0) {
            arb_min(ahead, ahead, load, prec);
            arb_div(u, P, ahead, prec);
            arb_set_d(ahead, 4 * DBL_EPSILON / 1e-14);
            arb_mul(u, u, ahead, prec);
            arb_addmul(scale, share, u, prec);
        }
        arb_sqr(u, load, prec);
        arb_set_d(ahead, DBL_EPSILON * DBL_EPSILON / 1e-14);
        arb_addmul(scale, u, ahead, prec);
        advance(&s, i, prec);
    }
    arb_mul(u, s.f, s.f, prec);
    arb_mul(u, u, s.A, prec);
    arb_const_pi(ahead, prec);
    arb_div(u, u, ahead, prec);
    arb_mul(sum, sum, u, prec);
    arb_mul(scale, scale, u, prec);
    error_over(error, call->result[0], sum, scale, prec);
    state_clear(&s);
    _arb_vec_clear(w, 8);
}

/* ---- Distance from yield ---- */

static bool draw_yield_factor(probe *call)
{
    const rwedge_contact *contact = some_contact(call);
    if (!contact)
        return true;
    if (call->value[2] == 0)
        return false;
    const double nu = argument(call, "nu", 0.5 - log_between(call, 1e-4, 0.5)),
                 k = argument(call, "k", 1);
    double *r = call->result;
    if (rwedge_contact_yield_factor(contact, nu, k, &r[0], &r[1], &r[2]) != RWEDGE_OK)
        r[0] = NAN;
    return true;
}

/* dJ2/dx along the surface, and its derivative. */
static void slope_along_surface(arb_ptr value, arb_ptr slope, const arb_t x, const void *context,
                                slong prec)
{
    arb_ptr J2 = _arb_vec_init(J2_COUNT);
    acb_t z;
    acb_init(z);
    arb_set(acb_realref(z), x);
    ball_J2(J2, 2, context, z, prec);
    if (value)
        arb_set(value, J2 + J2_X);
    if (slope)
        arb_set(slope, J2 + J2_XX);
    acb_clear(z);
    _arb_vec_clear(J2, J2_COUNT);
}

/* J2 at the mark next to x, if there is one within 1e-7 of it: the rounding's edge, the edge of
 * a patch. */
static bool J2_at_mark(arb_t J2, const state *s, const traction *t, double x, slong prec)
{
    bool found = false;
    arb_t mark;
    acb_t z;
    arb_init(mark), acb_init(z);
    for (int i = 0; i < s->now.count && !found; i++) {
        if (i == 0)
            arb_set(mark, s->a);
        else
            width_of(mark, s, s->now.corners[i].load, prec);
        const double at = arf_get_d(arb_midref(mark), ARF_RND_NEAR);
        found = fabs(fabs(x) - at) < 1e-7 * at;
    }
    if (found) {
        acb_ptr v = _acb_vec_init(3);
        if (x < 0)
            arb_neg(mark, mark);
        acb_set_arb(z, mark);
        for (int i = 0; i < t->patches; i++) { /* D = G_T and s = Im G_N - Re G_T */
            ball_potential(v, &t->patch[i], z, prec);
            acb_addmul_arb(v + 1, v, &t->weight[i], prec);
        }
        acb_mul_arb(v + 1, v + 1, t->f, prec);
        arb_sub(mark, acb_imagref(v), acb_realref(v + 1), prec);
        arb_sqr(mark, mark, prec);
        arb_mul(J2, mark, t->kappa, prec);
        arb_addmul(J2, acb_realref(v + 1), acb_realref(v + 1), prec);
        arb_addmul(J2, acb_imagref(v + 1), acb_imagref(v + 1), prec);
        _acb_vec_clear(v, 3);
    }
    arb_clear(mark), acb_clear(z);
    return found;
}

/* The stationary value next to where the library says the maximum is: below the surface, or at a
 * mark or along the surface, whichever is higher. */
static bool maximum_next_to(arb_t J2, const state *s, const traction *t, double x, double y,
                            slong prec)
{
    const double b = rwedge_contact_half_width(s->call->object);
    arb_t at, ignored;
    acb_t z;
    arb_init(at), arb_init(ignored), acb_init(z);
    acb_set_d_d(z, x, y);
    bool proved = y > 1e-7 * b && ball_stationary(at, ignored, J2, NULL, t, z, prec);
    if (!proved && y < 1e-7 * b) {
        proved = J2_at_mark(J2, s, t, x, prec);
        arb_set_d(at, x);
        if (ball_zero(at, at, b, slope_along_surface, t, prec)) {
            acb_set_arb(z, at);
            ball_J2(at, 0, t, z, prec);
            if (proved)
                arb_max(J2, J2, at, prec);
            else
                arb_set(J2, at);
            proved = true;
        }
    }
    arb_clear(at), arb_clear(ignored), acb_clear(z);
    return proved;
}

static void judge_yield_factor(arb_t error, const probe *call, slong prec)
{
    state s;
    traction t;
    arb_t factor, scale, promised;
    acb_t z;
    arb_init(factor), arb_init(scale), arb_init(promised), acb_init(z);
    acb_set_d_d(z, call->result[1], call->result[2]);
    state_init(&s, call, prec);
    run_history(&s, prec);
    traction_of(&t, &s, 0, 0, call->value[4], prec);
    if (maximum_next_to(factor, &s, &t, call->result[1], call->result[2], prec)) {
        arb_rsqrt(factor, factor, prec);
        stress_change_by_widths(scale, &s, z, prec);
        arb_set_d(promised, 1e-12);
        arb_div(scale, scale, promised, prec);
        arb_mul(scale, scale, factor, prec); /* over sqrt(J2) */
        arb_add_ui(scale, scale, 1, prec);
        arb_div(factor, factor, s.unit, prec);
        arb_mul(scale, scale, factor, prec);
        error_over(error, call->result[0], factor, scale, prec);
    } else {
        arb_indeterminate(error);
    }
    traction_clear(&t);
    state_clear(&s);
    arb_clear(factor), arb_clear(scale), arb_clear(promised), acb_clear(z);
}

const row HISTORY_ROWS[] = {
    {"contact_half_width", "1 to 12 loads", "relative", 1e-14, "1e-14", 1, draw_half_width,
     judge_half_width},
    {"contact_stick_half_width", "the same", "relative, times its load over the largest (1)", 1e-13,
     "1e-13", 1, draw_stick, judge_stick},
    {"contact_tractions, p", "x dense at the edges", "relative; widths (1)", 1e-12, "1e-12", 1,
     draw_pressure, judge_pressure},
    {"contact_tractions, q", "the same", "of f (theta/A + \\|p\\|); widths (1), loads (2)", 1e-13,
     "1e-13", 1, draw_shear, judge_shear},
    {"contact_stresses", "points dense at the edges",
     "of max(norm, 1/(1+\\|z\\|/b)) per remembered load; widths (1), loads (2)", 1e-13, "1e-13", 1,
     draw_stresses, judge_stresses},
    {"contact_slip", "x dense at the edges", "of f theta b; loads (2)", 1e-12, "1e-12", 1,
     draw_slip, judge_slip},
    {"contact_dissipated_energy", "the same", "of the shares; loads (3)", 1e-12, "1e-12 (3)", 1,
     draw_energy, judge_energy},
    {"contact_yield_factor", "the same; nu to 0.4999", "relative; widths (1)", 1e-12, "1e-12", 0.1,
     draw_yield_factor, judge_yield_factor},
    {0},
};
