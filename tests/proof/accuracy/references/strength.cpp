/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "references/strength.hpp"

#include "references/contact.hpp"
#include "references/root.hpp"

ball limit_of(const ball &alpha, const ball &J2) { return force(alpha, 1) / sqrt(J2); }

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

/* ---- On the surface, x = alpha sin(psi): J2 = f^2 (u^2 + P^2) + kappa (P + f u)^2, u =
 * sin(psi), P = |p| ---- Next to x = alpha, where P has a vertical tangent, psi gives way to t
 * with cos(psi) = exp(-t). */

/* J2 with the slope u and the pressure at x = alpha at: at u = sin(psi) both are the same. */
ball surface_J2(const sliding_contact &t, const ball &u, const ball &at)
{
    const ball P = -pressure(t.a, 1, t.a * at);
    return sqr(t.f) * (sqr(u) + sqr(P)) + t.kappa * sqr(P + t.f * u);
}

/* (1/2) dJ2/du, and its derivative by psi, or by t: dpsi = (v/u) dt, u and v its sine and
 * cosine. */
struct surface {
    const sliding_contact &t;
    bool at_corner = false;

    direction sine_and_cosine(const ball &parameter) const
    {
        if (!at_corner)
            return direction_of(parameter);
        const ball cosine = exp(-parameter);
        return {cosine, sqrt(1 - sqr(cosine))};
    }

    value_slope operator()(const ball &parameter) const
    {
        const direction psi = sine_and_cosine(parameter);
        const J2_jet J = J2_at(t, t.a * psi.sine);
        const ball by_u = J.xx * sqr(t.a) / 2;
        return {J.x * t.a / 2, by_u * (at_corner ? sqr(psi.cosine) / psi.sine : psi.cosine)};
    }

    /* The parameter of x, psi or t. Where x is alpha to rounding, a parameter that is far on the
     * way there. */
    ball parameter_of(double x)
    {
        const ball sine = x / t.a;
        const double u = middle(sine);
        at_corner = u > 0.9;
        return at_corner ? -0.5 * log(fmax((1 - u) * (1 + u), 1e-16)) : asin(sine);
    }

    /* From anywhere: the slope of J2 falls through its zero; t is halved in its logarithm, up to
     * where x is alpha to half of the bits. False where the slope is still positive there. */
    bool search(ball *parameter)
    {
        double low = -40, high = log((double)bits / 4);
        at_corner = true;
        *parameter = exp(high);
        if (sign((*this)(*parameter).value) > 0)
            return false;
        for (int i = 1; i < 60; i++) {
            const double half_way = (low + high) / 2;
            (sign((*this)(exp(half_way)).value) <= 0 ? high : low) = half_way;
            *parameter = exp(half_way);
        }
        if (high < log(0.5)) {
            at_corner = false;
            *parameter = high > -30 ? ::sqrt(2 * exp(high)) : 0;
        }
        return true;
    }

    /* The maximum is beyond the parameter, whose slope is positive: u rises and P falls from there
     * to x = alpha. */
    extremum beyond(const ball &parameter) const
    {
        const ball u = sine_and_cosine(parameter).sine;
        if (!((*this)(parameter).value > 0))
            return {unknown(), unknown(), unknown(), NAN};
        return {t.a * hull(u, 1), 0, hull(surface_J2(t, u, 1), surface_J2(t, 1, u)), 1};
    }

    /* The curvature of J2 over J2: 2 slope' cos(psi) by psi, and cos(psi) = u where the parameter
     * is t, dpsi/dt = cos/u. */
    double curvature(const ball &parameter, const ball &J2) const
    {
        const direction p = sine_and_cosine(parameter);
        return 2 * fabs(middle((*this)(parameter).slope * (at_corner ? p.sine : p.cosine) / J2));
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
    surface s = {t};
    ball parameter = s.parameter_of(guess), zero = find_zero(parameter, 1, s);
    if (!is_finite(zero)) {
        if (!s.search(&parameter))
            return s.beyond(parameter);
        zero = find_zero(parameter, 1, s);
    }
    const ball u = s.sine_and_cosine(zero).sine, J2 = surface_J2(t, u, u);
    return {t.a * u, 0, J2, s.curvature(zero, J2)};
}

} // namespace

extremum extremum_near(const sliding_contact &t, double x, double y)
{
    return y > 0 ? stationary_near(t, x, y) : surface_maximum_near(t, x);
}
