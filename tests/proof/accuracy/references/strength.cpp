/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "references/strength.hpp"

#include "references/contact.hpp"
#include "references/root.hpp"

traction sliding_contact(const ball &alpha, const ball &f, double nu)
{
    traction t(alpha, f, nu);
    t.add(1, 1);
    return t;
}

ball limit_of(const ball &alpha, const ball &J2)
{
    return force(alpha, 1) / sqrt(J2);
}

namespace
{

/* ---- On the surface, x = alpha sin(psi): J2 = f^2 (u^2 + P^2) + kappa (P + f u)^2, u =
 * sin(psi), P = |p| ---- Next to x = alpha, where P has a vertical tangent, psi gives way to t
 * with cos(psi) = exp(-t). */

/* J2 with the slope u and the pressure at x = alpha at: at u = sin(psi) both are the same. */
ball surface_J2(const traction &t, const ball &u, const ball &at)
{
    const ball P = -pressure(t.a, 1, t.a * at);
    return sqr(t.f) * (sqr(u) + sqr(P)) + t.kappa * sqr(P + t.f * u);
}

/* (1/2) dJ2/du = f^2 (u - P F) + kappa (P + f u)(f - F) with F = -dP/du = (2/pi) [phi0 x/s +
 * ln((s + c0 u)/v)], s = sqrt(1-x^2), and its derivative by psi, or by t: dpsi = (v/u) dt. */
struct surface {
    const traction &t;
    const ball phi0 = t.whole().phi0(), c0 = t.whole().c0();
    bool at_corner = false;

    explicit surface(const traction &of_contact) : t(of_contact) {}

    struct place {
        ball u, v, x, s, P, F; /* u = sin(psi), v = cos(psi) */
    };

    place at(const ball &parameter) const
    {
        const ball v = at_corner ? exp(-parameter) : cos(parameter);
        const ball u = at_corner ? sqrt(1 - sqr(v)) : sin(parameter);
        const ball x = t.a * u, s = angle_of(x, 1).c0;
        return {
            u, v, x, s, -pressure(t.a, 1, x), 2 / pi() * (log((s + c0 * u) / v) + phi0 * x / s)};
    }

    ball value(const ball &parameter) const
    {
        const place p = at(parameter);
        return sqr(t.f) * (p.u - p.P * p.F) + t.kappa * (p.P + t.f * p.u) * (t.f - p.F);
    }

    ball slope(const ball &parameter) const
    {
        const place p = at(parameter);
        const ball dx = t.a * p.v; /* by psi */
        const ball dF =
            2 / pi() *
            (phi0 * dx / cube(p.s) + (c0 * p.v - dx * p.x / p.s) / (p.s + c0 * p.u) + p.u / p.v);
        const ball by_psi = sqr(t.f) * ((1 + sqr(p.F)) * p.v - p.P * dF) +
                            t.kappa * (sqr(t.f - p.F) * p.v - (p.P + t.f * p.u) * dF);
        return at_corner ? by_psi * p.v / p.u : by_psi;
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
        if (sign(value(*parameter)) > 0)
            return false;
        for (int i = 1; i < 60; i++) {
            const double half_way = (low + high) / 2;
            (sign(value(exp(half_way))) <= 0 ? high : low) = half_way;
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
    bool beyond(extremum *found, const ball &parameter) const
    {
        const ball u = at(parameter).u;
        *found = {t.a * hull(u, 1), 0, hull(surface_J2(t, u, 1), surface_J2(t, 1, u)), 1};
        return value(parameter) > 0;
    }

    /* The curvature of J2 over J2: 2 slope' cos(psi) by psi, and cos(psi) = u where the parameter
     * is t, dpsi/dt = cos/u. */
    double curvature(const ball &parameter, const ball &J2) const
    {
        const place p = at(parameter);
        return 2 * fabs(middle(slope(parameter) * (at_corner ? p.u : p.v) / J2));
    }
};

/* Hertz: f^2 + kappa (1 + f^2) at x = f/sqrt(1+f^2). */
extremum hertz_maximum(const traction &t)
{
    const ball more = 1 + sqr(t.f);
    return {t.f / sqrt(more), 0, sqr(t.f) + more * t.kappa, 1};
}

} // namespace

bool find_surface_maximum(extremum *at, const traction &t, double guess)
{
    if (is_zero(t.whole().c0())) {
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
    const ball u = s.at(zero).u, J2 = surface_J2(t, u, u);
    *at = {t.a * u, 0, J2, s.curvature(zero, J2)};
    return true;
}
