/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "references/strength.hpp"

#include "references/contact.hpp"
#include "references/root.hpp"

ball limit_of(const ball &alpha, const ball &J2) { return force(alpha, 1) / sqrt(J2); }

namespace
{

/* ---- On the surface, x = alpha sin(psi): J2 = f^2 (u^2 + P^2) + kappa (P + f u)^2, u =
 * sin(psi), P = |p| ---- Next to x = alpha, where P has a vertical tangent, psi gives way to t
 * with cos(psi) = exp(-t). */

/* J2 with the slope u and the pressure at x = alpha at: at u = sin(psi) both are the same. */
ball surface_J2(const sliding_contact &t, const ball &u, const ball &at)
{
    const ball P = -pressure(t.a, 1, t.a * at);
    return sqr(t.f) * (sqr(u) + sqr(P)) + t.kappa * sqr(P + t.f * u);
}

/* (1/2) dJ2/du = f^2 (u - P F) + kappa (P + f u)(f - F) with F = -dP/du = (2/pi) [phi0 x/s +
 * ln((s + c0 u)/v)], s = sqrt(1-x^2), and its derivative by psi, or by t: dpsi = (v/u) dt. */
struct surface {
    const sliding_contact &t;
    const ball phi0 = t.shape.phi0, c0 = t.shape.c0;
    bool at_corner = false;

    explicit surface(const sliding_contact &of_contact) : t(of_contact) {}

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
        const ball &u = psi.sine, &v = psi.cosine;
        const ball x = t.a * u, dx = t.a * v, s = angle_of(x, 1).c0, S = s + c0 * u;
        const ball P = -pressure(t.a, 1, x), F = 2 / pi() * (log(S / v) + phi0 * x / s);
        const ball dF = /* by psi */
            2 / pi() * (phi0 * dx / cube(s) + (c0 * v - dx * x / s) / S + u / v);
        const ball f2 = sqr(t.f), sum = P + t.f * u, rest = t.f - F;
        const ball by_psi = f2 * ((1 + sqr(F)) * v - P * dF) + t.kappa * (sqr(rest) * v - sum * dF);
        return {f2 * (u - P * F) + t.kappa * sum * rest, at_corner ? by_psi * v / u : by_psi};
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
    bool beyond(extremum *maximum, const ball &parameter) const
    {
        const ball u = sine_and_cosine(parameter).sine;
        *maximum = {t.a * hull(u, 1), 0, hull(surface_J2(t, u, 1), surface_J2(t, 1, u)), 1};
        return (*this)(parameter).value > 0;
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

} // namespace

bool find_surface_maximum(extremum *at, const sliding_contact &t, double guess)
{
    if (is_zero(t.shape.c0)) {
        *at = hertz_maximum(t);
        return true;
    }
    if (is_zero(t.f)) {
        *at = {0, 0, surface_J2(t, 0, 0), 1};
        return true;
    }
    surface s(t);
    ball parameter = s.parameter_of(guess), zero;
    const bool is_near = find_zero(&zero, parameter, 1, s);
    if (!is_near && !s.search(&parameter))
        return s.beyond(at, parameter);
    if (!is_near && !find_zero(&zero, parameter, 1, s))
        return false;
    const ball u = s.sine_and_cosine(zero).sine, J2 = surface_J2(t, u, u);
    *at = {t.a * u, 0, J2, s.curvature(zero, J2)};
    return true;
}
