/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "references/strength.hpp"

#include <float.h>

#include "references/contact.hpp"
#include "references/root.hpp"

ball limit_of(const ball &alpha, const ball &J2) { return patch(alpha, 1).load() / sqrt(J2); }

namespace
{

/* ---- Below the surface ---- */

extremum stationary_near(const sliding_contact &t, double x, double y)
{
    const auto gradient = [&](const column &z) -> residual {
        const J2_jet J = J2_at(t, {z.x, z.y});
        return {{J.x, J.y}, {J.xx, J.xy, J.xy, J.yy}};
    };
    const column place = find_zero(column{x, y}, y, gradient);
    const J2_jet J = J2_at(t, {place.x, place.y});
    const ball scale = sqr(place.y) / J.J2, size = hypot(hypot(J.xx, J.yy), J.xy);
    const ball flatness = abs(J.xx * J.yy - sqr(J.xy)) / size * scale;
    return {place.x, place.y, J.J2, middle(flatness)};
}

/* ---- On the surface, x = alpha u, 0 < u < 1: J2 = f^2 (u^2 + P^2) + kappa (P + f u)^2, P = |p|
 * ---- Next to u = 1, where P has a vertical tangent, w with u = tanh(w) goes on. */

/* J2 with the slope u and the pressure at x = alpha at: where u is x/alpha both are the same. */
ball surface_J2(const sliding_contact &t, const ball &u, const ball &at)
{
    const ball P = -pressure(t.a, 1, t.a * at);
    return sqr(t.f) * (sqr(u) + sqr(P)) + t.kappa * sqr(P + t.f * u);
}

/* (1/2) dJ2/du, and its derivative by w: du = dw/cosh(w)^2. */
struct surface {
    const sliding_contact &t;

    value_slope operator()(const ball &w) const
    {
        const J2_jet J = J2_at(t, t.a * tanh(w));
        return {J.x * t.a / 2, J.xx * sqr(t.a * sech(w)) / 2};
    }

    /* From anywhere: the slope of J2 falls through its zero; w is halved in its logarithm, up to
     * where x is alpha to half of the bits. False where the slope is still positive there. */
    bool search(ball *w) const
    {
        double low = -40, high = log((double)bits / 4);
        *w = exp(high);
        if (sign((*this)(*w).value) > 0)
            return false;
        for (int i = 1; i < 60; i++) {
            const double half_way = (low + high) / 2;
            (sign((*this)(exp(half_way)).value) <= 0 ? high : low) = half_way;
            *w = exp(half_way);
        }
        return true;
    }

    /* The maximum is beyond w, whose slope is positive: u rises and P falls from there to x =
     * alpha. */
    extremum beyond(const ball &w) const
    {
        const ball u = tanh(w);
        if (!((*this)(w).value > 0))
            return {unknown(), unknown(), unknown(), NAN};
        return {t.a * hull(u, 1), 0, hull(surface_J2(t, u, 1), surface_J2(t, 1, u)), 1};
    }
};

/* Hertz: f^2 + kappa (1 + f^2) at x = f/sqrt(1+f^2). */
extremum hertz_maximum(const sliding_contact &t)
{
    const ball more = 1 + sqr(t.f);
    return {t.f / sqrt(more), 0, sqr(t.f) + more * t.kappa, 1};
}

extremum surface_maximum_near(const sliding_contact &t, double guess)
{
    if (is_zero(t.shape.c0))
        return hertz_maximum(t);
    if (is_zero(t.f))
        return {0, 0, surface_J2(t, 0, 0), 1};
    const surface s = {t};
    ball w = atanh(fmin(middle(guess / t.a), 1 - DBL_EPSILON / 2)), zero = find_zero(w, 1, s);
    if (!is_finite(zero)) {
        if (!s.search(&w))
            return s.beyond(w);
        zero = find_zero(w, 1, s);
    }
    const ball u = tanh(zero), J2 = surface_J2(t, u, u);
    return {t.a * u, 0, J2, 2 * fabs(middle(s(zero).slope / J2))};
}

} // namespace

extremum extremum_near(const sliding_contact &t, double x, double y)
{
    return y > 0 ? stationary_near(t, x, y) : surface_maximum_near(t, x);
}
