/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The front of slip passes the layer s0 > s > s1 of the path, while the load moves linearly from p0
 * to p1. The slope of the layer differs by w from that of slip. Then
 *     energy = (A f^2/pi) w int B(u) d ln(eta(u)),
 *     B(u) = int max(P(s) - u, 0) ds over s1 < s < min(s0, u).
 * B is a polynomial of the second degree between its corners s0, s1, p0, p1; the integrals of
 * u^k d ln(eta) are elementary on either side of the load at the end of the rounding. */
#include "references/energy.hpp"

#include <algorithm>

#include "references/contact.hpp"

namespace
{

struct layer {
    ball s0, s1, p0, p1;
};

struct profile {
    ball a, corner; /* the load at eta = a */
};

bool is_below(const ball &x, const ball &y)
{
    return arf_cmp(arb_midref(x.arb()), arb_midref(y.arb())) < 0;
}

/* B(u); the moving load is P(s) = p1 + (s - s1) k. */
ball overlap(const layer &l, const ball &u)
{
    const ball length = min(l.s0, u) - l.s1, k = (l.p0 - l.p1) / (l.s0 - l.s1);
    const ball at_s1 = l.p1 - u, at_end = k * length + at_s1;
    const bool first = sign(at_s1) >= 0, second = sign(at_end) >= 0;
    if (sign(length) <= 0 || (!first && !second))
        return 0;
    if (first && second)
        return (at_s1 + at_end) * length / 2;
    return abs(sqr(first ? at_s1 : at_end) / k) / 2; /* a triangle */
}

/* Of u^k d ln(eta), k = 0, 1, 2. */
struct integrals {
    ball v[3];
};

/* The indefinite integrals at the load u, in units of corner/(pi/2) =: U and lengths of a: on the
 * rounding u = (pi/2) eta^2; beyond, with phi = asin(1/eta), r = sqrt(eta^2-1), u = eta^2 phi + r,
 *     ln(eta),
 *     eta^2 phi/2 + 3 r/2 - acos(1/eta),
 *     eta^4 phi^2/4 + (5 r^3/6 + r/2) phi + 11 eta^2/12 - (4/3) ln(eta). */
integrals primitives(const ball &eta, bool beyond)
{
    const ball half_pi = pi() / 2, ln = log(eta), e2 = sqr(eta);
    if (!beyond) /* (pi/2) eta^2/2, (pi/2)^2 eta^4/4 */
        return {{ln, half_pi * e2 / 2, sqr(half_pi * e2) / 4}};
    const ball r = sqrt((eta - 1) * (eta + 1)), phi = atan2(1, r);
    return {{ln, (e2 * phi + 3 * r) / 2 - (half_pi - phi),
             sqr(e2 * phi) / 4 + (5 * cube(r) + 3 * r) / 6 * phi + (11 * e2 - 16 * ln) / 12}};
}

integrals primitives_at(const profile &p, const ball &u, const ball &U, bool beyond)
{
    if (is_zero(u))
        return {}; /* but for the logarithm, whose factor B(0) is 0 */
    const ball load = u / U;
    if (is_zero(p.a)) /* d ln(eta) = du/u */
        return {{log(load), load, sqr(load) / 2}};
    if (sign_beside(u - p.corner, p.corner) == 0)
        return primitives(1, beyond);
    /* the half-width in a: guess from either end of the law */
    const double about = middle(load), hertz = 0.7978845608028654,
                 guess = about < 1.5707963267948966 ? hertz * ::sqrt(about) : about / 1.9;
    return primitives(half_width(1, load, fmax(guess, 1e-300)), beyond);
}

/* int_lo^hi B d ln(eta), where B is one polynomial and the loads are on one side of the corner;
 * in units of U. */
ball piece(const layer &l, const profile &p, const ball &lo, const ball &hi)
{
    const ball centre = (lo + hi) / 2, U = is_zero(p.a) ? hi : p.corner / (pi() / 2);
    const bool beyond = is_below(p.corner, centre);
    const ball B0 = overlap(l, lo), B1 = overlap(l, centre), B2 = overlap(l, hi);
    const integrals to = primitives_at(p, hi, U, beyond), from = primitives_at(p, lo, U, beyond);
    /* through the three values, with t = (u - x)/y: B = B0 + (4 B1 - 3 B0 - B2) t + 2 (B0 - 2 B1 +
     * B2) t^2; then in u/U */
    const ball x = lo / U, y = hi / U - x;
    const ball by_t = (4 * B1 - 3 * B0 - B2) / y, by_t2 = 2 * (B0 - 2 * B1 + B2) / sqr(y);
    const ball c[] = {B0 + (by_t2 * x - by_t) * x, by_t - 2 * by_t2 * x, by_t2};
    ball sum;
    for (int k = is_zero(lo) ? 1 : 0; k < 3; k++)
        sum += c[k] * (to.v[k] - from.v[k]);
    return sum;
}

ball over_layer(const layer &l, const profile &p)
{
    enum { CUTS = 5 };
    ball cut[CUTS] = {l.s0, l.s1, l.p0, l.p1, p.corner}, sum;
    std::sort(cut, cut + CUTS, is_below);
    for (int i = 1; i < CUTS; i++)
        if (sign_beside(cut[i] - cut[i - 1], cut[i]) > 0 && !is_below(cut[i - 1], l.s1))
            sum += piece(l, p, cut[i - 1], cut[i]);
    return sum;
}

/* A step, t = 0 to 1. */
struct load_step {
    const path &p;
    ball load, shear; /* at t = 0 */
    ball run, rise;
};

/* Slip of one sign from t = start to end: the front goes from the edge inwards. It is at s when
 * t climb = (P0 - s) - slip (T0 - T(s)), climb = slip rise - run. */
ball sweep(const load_step &st, int slip, const ball &start, const ball &end, const profile &p)
{
    const ball climb = slip * st.rise - st.run;
    ball sum, t_top = start;
    ball top = st.load; /* where the front is: the edge, or the end of a path that grows */
    if (sign(st.run) < 0)
        top += st.run * start;
    for (int i = st.p.count() - 1; i > 0; i--) {
        const corner &before = st.p[i - 1];
        if (sign_beside(top - before.load, st.load) <= 0)
            continue;
        const ball weight = 1 - slip * st.p[i].ratio;
        /* when the front is at the lower corner */
        ball t = (st.load - before.load + slip * (before.shear - st.shear)) / climb;
        ball bottom = before.load;
        const bool stops = sign_beside(t - end, 1) > 0;
        if (stops) { /* inside this segment, weight per length */
            const ball passed = (end - t_top) * climb;
            if (sign_beside(passed, st.load) <= 0)
                break;
            bottom = top - passed / weight;
            t = end;
        }
        if (sign_beside(weight, 1) > 0)
            sum += weight *
                   over_layer({top, bottom, st.load + st.run * t_top, st.load + st.run * t}, p);
        if (stops)
            break;
        top = before.load;
        t_top = t;
    }
    return sum;
}

/* A falling load: its edge moves along the path, and where what the step is ahead of the path
 * changes sign the zone of slip has shrunk to nothing and begins anew. */
dissipation falling(const load_step &st, const profile &p)
{
    dissipation sum;
    ball t, start, missing;
    int slip = 0;
    for (int i = st.p.count() - 1; i > 0; i--) {
        const ball lower = -(st.load - st.p[i - 1].load) / st.run;
        const bool ends = arf_cmp_si(arb_midref(lower.arb()), 1) >= 0;
        const ball next = ends ? 1 : lower, rate = st.rise - st.p[i].ratio * st.run;
        const ball then = missing + (next - t) * rate;
        const int now = sign_beside(then, abs(st.load));
        if (slip * now < 0) {
            const ball crossing = t - missing / rate;
            sum.energy += sweep(st, slip, start, crossing, p);
            start = crossing;
            slip = -slip;
        } else if (slip == 0 && now != 0) {
            slip = now;
            start = t;
        }
        missing = then;
        sum.ahead = max(sum.ahead, abs(then));
        t = next;
        if (ends)
            break;
    }
    if (slip != 0)
        sum.energy += sweep(st, slip, start, 1, p);
    return sum;
}

} // namespace

dissipation dissipation_to(const path &p, const ball &load, const ball &shear, const ball &a,
                           const ball &unit)
{
    const corner &end = p.end();
    const load_step st = {p, end.load, end.shear, load - end.load, shear - end.shear};
    const profile q = {a, pi() / 2 * a * unit};
    if (sign_beside(st.run, end.load) < 0 && p.count() > 1)
        return falling(st, q);
    const ball steep = abs(st.rise) - st.run;
    if (sign_beside(steep, load) <= 0)
        return {0, steep};
    return {sweep(st, sign(st.rise), 0, 1, q), steep};
}
