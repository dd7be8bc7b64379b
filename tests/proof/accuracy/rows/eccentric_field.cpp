/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses of a contact off the centre, from the sums over breakpoints of the profile. With
 * z = m + s sin(zeta), q = exp(i zeta), the ends of the rounding at sin(phi_j) with the jumps k_j =
 * +-1/a of the slope, psi_j = pi/2 - phi_j and
 *
 *     L_j = ln(1 - exp(-i phi_j) q) - ln(1 + exp(i phi_j) q) - i psi_j,
 *
 *     G  = sum k_j s { (i/pi)[ (sin zeta - sin phi_j) L_j - psi_j cos zeta ]
 *                      - (1/pi)[ cos phi_j - psi_j sin phi_j ] },
 *     G' = sum k_j (i/pi)[ L_j + (cos phi_j + psi_j sin zeta)/cos zeta ].
 *
 * An end on the left of the patch counts as one at its left edge, with the line continued: phi_j =
 * -pi/2 makes all of its sum but a constant. The edges are those that the library found: the rows
 * of eccentric.cpp judge them. */
#include <initializer_list>
#include <math.h>
#include <vector>

#include "rows/eccentric.hpp"
#include "rows/rows.hpp"

namespace
{

/* A breakpoint inside: its jump, psi and phi. */
struct breakpoint {
    ball k, psi, cosine, sine, constant; /* (cos phi - psi sin phi)/pi */
};

struct profile_patch {
    ball middle, half, tilt;
    ball rate; /* of the slope, left of the first end inside: k_left */
    std::vector<breakpoint> ends;
};

/* Of a place over the half-width, from the middle. */
breakpoint breakpoint_at(const ball &place, const ball &k)
{
    const ball phi = asin(place), psi = pi() / 2 - phi, cosine = cos(phi);
    return {k, psi, cosine, place, (cosine - psi * place) / pi()};
}

profile_patch patch_of(const ball &a, const ball_edges &e)
{
    const carried c = carried_by(wedge(a), e);
    profile_patch p = {c.middle, c.half, c.tilt, -a <= e.left ? 1 / a : 0, {}};
    for (const ball &at : {-a, a})
        if (!(at <= e.left) && !(at >= e.right))
            p.ends.push_back(breakpoint_at((at - p.middle) / p.half, -1 / at));
    return p;
}

profile_patch patch_found(const double v[], const double edges[2])
{
    return patch_of(v[ROUNDING], {edges[0], edges[1]});
}

/* sin zeta, cos zeta, q, zeta of a point of the closed upper half-plane. */
struct place {
    complex_ball sine, cosine, q, zeta;
};

place place_of(const profile_patch &p, const complex_ball &z)
{
    const complex_ball sine = (z - p.middle) / p.half, X = root(sine - 1) * root(sine + 1);
    const complex_ball q = times_i(sine - X);
    return {sine, over_i(X), q, over_i(log(q))};
}

/* u ln u of that logarithm, for Re u >= 0 or nearly so. Where u may be 0: r (|ln r| + 4) bounds
 * it for |u| <= r <= 1/e, as |arg u| <= pi. */
complex_ball times_own_logarithm(const complex_ball &u, const complex_ball &logarithm)
{
    if (!contains_zero(u))
        return u * logarithm;
    const ball r = upper_bound(u);
    if (!(r < 0.36))
        return u * logarithm;
    const ball bound = r * (log(r) - 4);
    return {widened(0, bound), widened(0, bound)};
}

/* L_j, (sin zeta - sin phi_j) L_j. With L_j = ln(A) - ln(B) - i psi_j, sin zeta - sin phi_j = (i
 * B/2q) A. */
struct term {
    complex_ball L, product;
};

term term_of(const breakpoint &end, const place &at)
{
    const complex_ball A = 1 - complex_ball(end.cosine, -end.sine) * at.q,
                       B = 1 + complex_ball(end.cosine, end.sine) * at.q;
    const complex_ball ln_A = log(A), rest = log(B) + complex_ball(0, end.psi);
    return {ln_A - rest,
            times_own_logarithm(A, ln_A) * times_i(B / at.q) / 2 - (at.sine - end.sine) * rest};
}

potentials potentials_at(const profile_patch &p, const complex_ball &z)
{
    const place at = place_of(p, z);
    const bool is_surface = is_zero(im(z));
    complex_ball G = p.rate * (at.sine - times_i(at.cosine)); /* k_left */
    complex_ball slope = is_surface ? 0 : p.rate * (1 + times_i(at.sine / at.cosine));
    for (const breakpoint &end : p.ends) {
        const term of_end = term_of(end, at);
        G += end.k * (i_over_pi(of_end.product - end.psi * at.cosine) - end.constant);
        if (!is_surface)
            slope += end.k * i_over_pi(of_end.L + (end.psi * at.sine + end.cosine) / at.cosine);
    }
    return {p.half * G, im(z) * slope};
}

/* ---- Rows ---- */

/* What a call finds first: the edges of the stick zone and of the contact. */
enum { STICK_LEFT, STICK_RIGHT, WHOLE_LEFT, WHOLE_RIGHT, FOUND };
enum { X_AT = TENSION + 1, Y_AT };

/* Next to an edge or an end of the rounding, or anywhere. */
double some_x(probe *call)
{
    const double *r = call->result, width = r[WHOLE_RIGHT] - r[WHOLE_LEFT];
    const double a = call->value[ROUNDING], marks[] = {r[0], r[1], r[2], r[3], -a, a};
    if (chance(call, 0.3))
        return r[WHOLE_LEFT] + width * (3 * uniform(call) - 1);
    const int which = (int)(6 * uniform(call));
    return marks[which] + either_sign(call, width * log_between(call, 1e-14, 1));
}

bool draw_stresses(probe *call)
{
    const shared_contact contact = draw_slipping(call);
    double *r = call->result;
    if (!contact || call->value[ROUNDING] == 0 || !(r[STICK_LEFT] < r[STICK_RIGHT]))
        return false;
    const double width = r[WHOLE_RIGHT] - r[WHOLE_LEFT], x = argument(call, "x", some_x(call));
    const double y =
        argument(call, "y", chance(call, 0.3) ? 0 : width * log_between(call, 1e-14, 10));
    if (rwedge_contact_stresses(contact.get(), 1, &x, &y, r + FOUND, r + FOUND + 1,
                                r + FOUND + 2) != RWEDGE_OK)
        r[FOUND] = NAN;
    return true;
}

/* 1 - |delta|, the smaller of two patches'. */
ball flatness(const profile_patch &one, const profile_patch &other)
{
    return 1 - max(abs(one.tilt), abs(other.tilt));
}

/* The largest error of a component: of the pressure, of the shear traction f (G - G of what
 * sticks), with a tension. A stress counts as the larger of itself and max(1, f)/(1+|z|), z from
 * the middle of the contact in half-widths, over 1 - |delta|; and the tension counts. */
ball judge_stresses(const probe &call)
{
    const double *v = call.value, *r = call.result;
    const profile_patch whole = patch_found(v, r + WHOLE_LEFT),
                        stick = patch_found(v, r + STICK_LEFT);
    const ball f = v[SHEAR] < 0 ? -v[FRICTION] : v[FRICTION], unit = ball(v[THETA]) / v[COMPLIANCE];
    const complex_ball z(v[X_AT], v[Y_AT]);
    const potentials N = potentials_at(whole, z);
    const tensor s = tensor_of(superposed(N, f * (N - potentials_at(stick, z))));
    const double b = (r[WHOLE_RIGHT] - r[WHOLE_LEFT]) / 2;
    const double far = 1 + hypot(v[X_AT] - (r[WHOLE_RIGHT] + r[WHOLE_LEFT]) / 2, v[Y_AT]) / b;
    const ball most = max(max(abs(s.xx), abs(s.yy)), abs(s.xy));
    const ball scale = max(most, fmax(1, v[FRICTION]) / far) / flatness(whole, stick) * unit;
    return error_over(r + FOUND, {s.xx * unit + v[TENSION], s.yy * unit, s.xy * unit},
                      scale + fabs(v[TENSION]));
}

} // namespace

const row ECCENTRIC_FIELD_ROWS[] = {
    {"contact_stresses, off the centre", "after one step of Q and sigma; points dense at all edges",
     "of max(norm, max(1, f)/(1+\\|z\\|)), over 1 - \\|delta\\|; of the edges found", 1e-13,
     "1e-13", 1, draw_stresses, judge_stresses},
    {},
};
