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

/* P and Q/f of a load; to 8 epsilon full sliding is full sliding. */
void advance(path *now, const probe &call, int i)
{
    const double P = call.P[i], Q = call.Q[i], f = call.value[FRICTION];
    const double last = i > 0 ? call.P[i - 1] : 0;
    if (fabs(fabs(Q) - f * P) <= 8 * DBL_EPSILON * f * fmax(P, last))
        now->advance(P, Q > 0 ? P : -P);
    else
        now->advance(P, ball(Q) / f);
}

/* A remembered corner of the path: the half-width under its load, and D less that beyond it. A load
 * of the diagram has the rounding of the largest one: `off` is how far the half-width may be off,
 * 1e-14 or more, relatively. */
struct ring {
    ball width, weight;
    double off;
};

/* closeness: D is a quotient of differences of loads. How much it magnifies their rounding where
 * they are close to each other; 1 where they differ by 1e-2 of the load or more. */
struct state {
    ball theta, A, a, f, unit; /* unit: theta/A */
    path now;
    double closeness = 1, largest = 0;

    explicit state(const probe &call)
        : theta(call.value[THETA]), A(call.value[COMPLIANCE]), a(call.value[ROUNDING]),
          f(call.value[FRICTION]), unit(theta / A)
    {
        for (int i = 0; i < call.loads; i++) {
            const double P = call.P[i], step = i > 0 ? fabs(P - call.P[i - 1]) : 0;
            advance(&now, call, i);
            largest = fmax(largest, P);
            if (step > 0)
                closeness = fmax(closeness, 1e-2 * P / step);
        }
    }

    ring ring_at(int i) const
    {
        const ball &load = now[i].load, beyond = i + 1 < now.count() ? now[i + 1].ratio : ball();
        const double P = middle(load);
        const double guess = rwedge_half_width(middle(theta), middle(a), middle(A), P);
        return {half_width(a, load / unit, guess), now[i].ratio - beyond,
                1e-14 * fmax(1, largest / P)};
    }

    /* The innermost first. */
    std::vector<ring> rings() const
    {
        std::vector<ring> all;
        for (int i = 1; i < now.count(); i++)
            all.push_back(ring_at(i));
        return all;
    }
};

/* ---- Half-widths ---- */

ball judge_half_width(const probe &call)
{
    const state s(call);
    return relative_error(call.result[0], s.ring_at(s.now.count() - 1).width);
}

/* The error is that of the stick zone's load, relative to the largest load. */
ball judge_stick(const probe &call)
{
    const state s(call);
    const int slip = sign(s.now.end().ratio);
    int stick = s.now.count() - 1;
    while (stick > 0 && slip != 0 && is_small(1 - slip * s.now[stick].ratio, 1, (bits - 40) / 2))
        stick--; /* the ring that ends there slips */
    if (stick == 0)
        return relative_error(call.result[0], 0);
    const ring at = s.ring_at(stick);
    return relative_error(call.result[0], at.width) / (at.off / 1e-14);
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

/* result, over 1e-13 (theta/A + |p|) f and what half-widths that are off change, times 1e-13; for
 * the pressure over 1e-12 |p| and that, times 1e-12. */
template <bool shear> ball judge_tractions(const probe &call)
{
    const state s(call);
    const double x = call.value[4];
    ball p, q, change, sum;
    for (const ring &at : s.rings()) {
        const ball off = at.off;
        p = pressure(s.a, at.width, x);
        q += at.weight * p;
        change =
            abs(pressure(s.a, (1 + off) * at.width, x) - pressure(s.a, (1 - off) * at.width, x));
        sum += abs(at.weight) * change;
    }
    const ball unit = s.unit * s.closeness;
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
    gives(call, rwedge_contact_stresses(contact.get(), 1, &x, &y, &r[0], &r[1], &r[2]));
    return x != 0 || y != 0;
}

/* Per remembered point: over the larger of the norm and 1/(1+|z|/b), and the norms of what
 * half-widths that are off change in the stresses of the patches, over 1e-13. The patch of the last
 * corner is the pressure's too. */
ball judge_stresses(const probe &call)
{
    const state s(call);
    const std::vector<ring> rings = s.rings();
    const complex_ball z(call.value[4], call.value[5]);
    potentials p, T;
    ball change;
    for (const ring &at : rings) {
        const potentials off = patch(s.a, at.width * (1 + ball(at.off))).at(z) -
                               patch(s.a, at.width * (1 - ball(at.off))).at(z);
        const potentials pressing = &at == &rings.back() ? off : potentials();
        p = patch(s.a, at.width).at(z);
        T = T + s.f * at.weight * p;
        change += norm_of(tensor_of(superposed(pressing, s.f * at.weight * off)));
    }
    const tensor exact = tensor_of(superposed(p, T));
    const ball floor = 1 / (1 + abs(z) / rings.back().width);
    const ball scale = max(norm_of(exact), floor) * (double)rings.size() + change / 1e-13;
    return error_over(call.result, {exact.xx * s.unit, exact.yy * s.unit, exact.xy * s.unit},
                      scale * s.closeness * s.unit);
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
