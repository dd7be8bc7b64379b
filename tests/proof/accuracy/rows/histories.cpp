/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contacts with a load history: half-widths, tractions, stresses. */
#include <float.h>
#include <math.h>

#include "references/memory.hpp"
#include "rows/rows.hpp"
#include "rwedge.h"

namespace
{

/* ---- Random histories ---- */

/* Loads of every kind: growing, falling, repeated, in full sliding; never closer to each other
 * than 1e-3 without being equal, because the library takes loads within rounding of each other
 * for equal. */
void some_loads(probe *call, double f, double unit)
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

enum { THETA, COMPLIANCE, ROUNDING, FRICTION };

/* The contact under its last load. Where a load is refused, none and the result NaN: a failure,
 * because all that is drawn is in the domain. */
shared_contact some_contact(probe *call)
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
    rwedge_contact *made = NULL;
    int32_t status = rwedge_contact_create(theta, a, A, f, &made);
    const shared_contact contact = shared(made);
    for (int i = 0; i < call->loads && status == RWEDGE_OK; i++)
        status = rwedge_contact_load(made, call->P[i], call->Q[i]);
    return status == RWEDGE_OK ? contact : NULL;
}

/* Next to an edge of some load, of slip, of the rounding; or anywhere in the contact. */
double some_contact_place(probe *call, const rwedge_contact *contact)
{
    const double *v = call->value, b = rwedge_contact_half_width(contact),
                 c = rwedge_contact_stick_half_width(contact);
    const double P = call->P[(int)(uniform(call) * call->loads)], kind = uniform(call);
    const double mark = kind < 0.2   ? b
                        : kind < 0.4 ? c
                        : kind < 0.5 ? v[ROUNDING]
                        : kind < 0.6 ? rwedge_half_width(v[THETA], v[ROUNDING], v[COMPLIANCE], P)
                                     : b * uniform(call);
    return either_sign(call, fabs(mark + either_sign(call, mark * log_between(call, 1e-14, 1))));
}

template <double (*measured)(const rwedge_contact *)> bool draw_measured(probe *call)
{
    return gives(call, measured(some_contact(call).get()));
}

/* ---- The exact state ---- */

struct load_point {
    ball load, shear;
};

/* P and Q/f of a load; to 8 epsilon full sliding is full sliding. */
load_point load_of(const probe &call, int i)
{
    const double P = call.P[i], Q = call.Q[i], f = call.value[FRICTION];
    const double last = i > 0 ? call.P[i - 1] : 0;
    if (fabs(fabs(Q) - f * P) <= 8 * DBL_EPSILON * f * fmax(P, last))
        return {P, Q > 0 ? P : -P};
    return {P, ball(Q) / f};
}

struct state {
    const probe &call;
    ball theta, A, a, f, unit; /* unit: theta/A */
    path now;

    explicit state(const probe &of_call)
        : call(of_call), theta(call.value[0]), A(call.value[1]), a(call.value[2]), f(call.value[3]),
          unit(theta / A)
    {
    }
};

void advance(state *s, int i)
{
    const load_point to = load_of(s->call, i);
    s->now.advance(to.load, to.shear);
}

state run_history(const probe &call)
{
    state s(call);
    for (int i = 0; i < call.loads; i++)
        advance(&s, i);
    return s;
}

/* The half-width under a load of the path. */
ball width_of(const state &s, const ball &load)
{
    const double *v = s.call.value;
    return half_width(s.a, load / s.unit, rwedge_half_width(v[0], v[2], v[1], middle(load)));
}

/* D of the corner less that beyond it. */
ball weight_of(const path &p, int i)
{
    return i + 1 < p.count() ? p[i].ratio - p[i + 1].ratio : p[i].ratio;
}

/* D is a quotient of differences of loads. How much it magnifies their rounding where they are
 * close to each other; 1 where they differ by 1e-2 of the load or more. */
double closeness(const probe &call)
{
    double factor = 1;
    for (int i = 1; i < call.loads; i++)
        if (call.P[i] != call.P[i - 1])
            factor = fmax(factor, 1e-2 * call.P[i] / fabs(call.P[i] - call.P[i - 1]));
    return factor;
}

/* A load of the diagram has the rounding of the largest one: by how much more than 1e-14 a
 * half-width may be off. */
double looseness(const state &s, int i)
{
    double largest = 0;
    for (int j = 0; j < s.call.loads; j++)
        largest = fmax(largest, s.call.P[j]);
    return fmax(1, largest / middle(s.now[i].load));
}

/* ---- Half-widths ---- */

ball judge_half_width(const probe &call)
{
    const state s = run_history(call);
    return relative_error(call.result[0], width_of(s, s.now.end().load));
}

/* The error is that of the stick zone's load, relative to the largest load. */
ball judge_stick(const probe &call)
{
    const state s = run_history(call);
    const int slip = sign(s.now.end().ratio);
    int stick = s.now.count() - 1;
    while (stick > 0 && slip != 0 && is_small(1 - slip * s.now[stick].ratio, 1, (bits - 40) / 2))
        stick--; /* the ring that ends there slips */
    if (stick == 0)
        return relative_error(call.result[0], 0);
    return relative_error(call.result[0], width_of(s, s.now[stick].load)) / looseness(s, stick);
}

/* ---- Tractions ---- */

template <bool shear> bool draw_tractions(probe *call)
{
    const shared_contact contact = some_contact(call);
    if (!contact)
        return true;
    const double x = argument(call, "x", some_contact_place(call, contact.get()));
    double p, q;
    if (rwedge_contact_tractions(contact.get(), 1, &x, &p, &q) != RWEDGE_OK)
        p = q = NAN;
    call->result[0] = shear ? q : p;
    return x != 0;
}

/* By how much the pressure of a patch changes if its half-widths are off by 1e-14 and by the
 * rounding of their load. */
ball change_by_width(const state &s, int i, const ball &width, const ball &x)
{
    const ball off = 1e-14 * looseness(s, i);
    return abs(pressure(s.a, (1 + off) * width, x) - pressure(s.a, (1 - off) * width, x));
}

/* result, over 1e-13 (theta/A + |p|) f and what half-widths off by 1e-14 change, times 1e-13;
 * for the pressure over 1e-12 |p| and that, times 1e-12. */
template <bool shear> ball judge_tractions(const probe &call)
{
    const state s = run_history(call);
    const double x = call.value[4];
    ball p, q, change, sum;
    for (int i = 1; i < s.now.count(); i++) {
        const ball width = width_of(s, s.now[i].load), weight = weight_of(s.now, i);
        p = pressure(s.a, width, x);
        q += weight * p;
        change = change_by_width(s, i, width, x);
        sum += abs(weight) * change;
    }
    const ball unit = s.unit * closeness(call);
    if (shear)
        return error_over(call.result[0], q * s.f * s.unit,
                          (sum / 1e-13 + abs(p) + 1) * s.f * unit);
    return error_over(call.result[0], p * s.unit, (change / 1e-12 + abs(p)) * unit);
}

/* ---- Stresses ---- */

bool draw_stresses(probe *call)
{
    const shared_contact contact = some_contact(call);
    if (!contact)
        return true;
    const double b = rwedge_contact_half_width(contact.get()), kind = uniform(call);
    double x = some_contact_place(call, contact.get()),
           y = kind < 0.2 ? 0 : b * log_between(call, 1e-15, 3);
    if (kind > 0.9) {
        x *= log_between(call, 1, 1e4);
        y *= log_between(call, 1, 1e4);
    }
    argument(call, "x", x);
    argument(call, "y", y);
    double *r = call->result;
    if (rwedge_contact_stresses(contact.get(), 1, &x, &y, &r[0], &r[1], &r[2]) != RWEDGE_OK)
        r[0] = NAN;
    return x != 0 || y != 0;
}

/* The potentials of the patch of one corner, stretched. */
potentials potentials_of(const state &s, int i, double stretch, const complex_ball &z)
{
    return patch(s.a, width_of(s, s.now[i].load) * (1 + ball(stretch))).at(z);
}

/* That of the last corner is the pressure's too. */
tensor stresses_at(const state &s, const complex_ball &z)
{
    potentials p, T;
    for (int i = 1; i < s.now.count(); i++) {
        p = potentials_of(s, i, 0, z);
        T = T + s.f * weight_of(s.now, i) * p;
    }
    return tensor_of(superposed(p, T));
}

/* The norms of what half-widths off by 1e-14, and by what their load's rounding is, change in
 * the stresses of the patches. */
ball stress_change_by_widths(const state &s, const complex_ball &z)
{
    ball sum;
    for (int i = 1; i < s.now.count(); i++) {
        const double off = 1e-14 * looseness(s, i);
        const potentials change = potentials_of(s, i, off, z) - potentials_of(s, i, -off, z);
        const potentials pressing = i + 1 == s.now.count() ? change : potentials();
        sum += norm_of(tensor_of(superposed(pressing, s.f * weight_of(s.now, i) * change)));
    }
    return sum;
}

/* Per remembered point: the larger of the norm and 1/(1+|z|/b), and what half-widths change,
 * over 1e-13. */
ball stress_scale(const state &s, const tensor &stresses, const complex_ball &z)
{
    const ball b = width_of(s, s.now.end().load);
    return max(norm_of(stresses), 1 / (1 + abs(z) / b)) * (s.now.count() - 1) +
           stress_change_by_widths(s, z) / 1e-13;
}

ball judge_stresses(const probe &call)
{
    const state s = run_history(call);
    const complex_ball z(call.value[4], call.value[5]);
    const tensor at = stresses_at(s, z);
    return error_over(call.result, {at.xx * s.unit, at.yy * s.unit, at.xy * s.unit},
                      stress_scale(s, at, z) * closeness(call) * s.unit);
}

} // namespace

const row HISTORY_ROWS[] = {
    {"contact_half_width", "1 to 12 loads", "relative", 1e-14, "1e-14", 1,
     draw_measured<rwedge_contact_half_width>, judge_half_width},
    {"contact_stick_half_width", "the same", "relative, times its load over the largest (1)", 1e-13,
     "1e-13", 1, draw_measured<rwedge_contact_stick_half_width>, judge_stick},
    {"contact_tractions, p", "x dense at the edges", "relative; widths (1)", 1e-12, "1e-12", 1,
     draw_tractions<false>, judge_tractions<false>},
    {"contact_tractions, q", "the same", "of f (theta/A + \\|p\\|); widths (1), loads (2)", 1e-13,
     "1e-13", 1, draw_tractions<true>, judge_tractions<true>},
    {"contact_stresses", "points dense at the edges",
     "of max(norm, 1/(1+\\|z\\|/b)) per remembered load; widths (1), loads (2)", 1e-13, "1e-13", 1,
     draw_stresses, judge_stresses},
    {},
};
