/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dimensional quantities of one contact. */
#include <float.h>
#include <math.h>

#include "rows/rows.hpp"
#include "rwedge.h"
#include "references/root.hpp"
#include "references/strength.hpp"

namespace
{

double some_unit(probe *call)
{
    return chance(call, 0.05) ? log_between(call, 1e-15, 1e15) : log_between(call, 1e-9, 1e6);
}

double some_angle(probe *call)
{
    return log_between(call, 1e-9, 1.5707);
}

/* theta, a, A, and A P/(theta a), or A P/theta for the sharp wedge. */
double some_geometry(probe *call, double v[3])
{
    v[0] = argument(call, "theta", some_angle(call));
    v[1] = argument(call, "a", chance(call, 0.05) ? 0 : some_unit(call));
    v[2] = argument(call, "A", some_unit(call));
    return chance(call, 0.3) ? near(call, 1.5707963267948966) : log_between(call, 1e-10, 1e20);
}

bool draw_half_width(probe *call)
{
    double v[3];
    const double ratio = some_geometry(call, v);
    const double P = argument(call, "P", ratio * v[0] / v[2] * (v[1] > 0 ? v[1] : some_unit(call)));
    call->result[0] = rwedge_half_width(v[0], v[1], v[2], P);
    return isnormal(P);
}

ball judge_half_width(const probe &call)
{
    const double *v = call.value;
    const ball wanted = ball(v[2]) * v[3] / v[0];
    return relative_error(call.result[0], half_width(v[1], wanted, call.result[0]));
}

bool draw_normal_load(probe *call)
{
    double v[3];
    const double ratio = some_geometry(call, v);
    const double b = argument(call, "b", v[1] > 0 ? v[1] * sqrt(ratio) : ratio);
    return gives(call, rwedge_normal_load(v[0], v[1], v[2], b));
}

/* (theta/A) times the force of the half-width b. */
ball normal_load(const double v[3], const ball &b)
{
    return force(v[1], b) * v[0] / v[2];
}

ball judge_normal_load(const probe &call)
{
    return relative_error(call.result[0], normal_load(call.value, call.value[3]));
}

/* ---- The load at first yield ---- */

/* alpha d/dalpha of J2 at a point below the surface. With q = 2 phi0/(pi alpha), alpha dG/dalpha
 * = -z G' - q/X and alpha d(y G')/dalpha = -y G' - y z G'' + q y z/X^3: what a flat punch adds. */
ball J2_by_alpha_below(const traction &t, const complex_ball &z)
{
    const patch &p = t.whole();
    const complex_ball G = p.potential(z), dG = p.slope(z), X = root(z - 1) * root(z + 1);
    const ball y = im(z), q = 2 * p.phi0 / t.a / pi();
    const complex_ball punch = q * inv(X * X * X),
                       K = 2 * p.c0 / pi() * inv((z - t.a) * (z + t.a) * X) + punch; /* G'' */
    const complex_ball Ga = -(q * inv(X) + z * dG), Ha = y * ((punch - K) * z - dG);
    /* D = f G + mu y G', mu = -1 + i f; s = Im G - f Re G */
    const complex_ball mu(-1, t.f), D = mu * (y * dG) + t.f * G, Da = mu * Ha + t.f * Ga;
    const ball s = im(G) - t.f * re(G), sa = im(Ga) - t.f * re(Ga);
    return 2 * (t.kappa * s * sa + dot(D, Da));
}

/* The same at the surface and for fixed x/alpha, where alpha dp/dalpha is 2 phi0/(pi alpha
 * sqrt(1-x^2)). */
ball J2_by_alpha_at_surface(const traction &t, const ball &x)
{
    const ball p = pressure(t.a, 1, x);
    const ball q = 4 * t.whole().phi0 / (pi() * angle_of(x, 1).c0 * t.a); /* twice for the square */
    return q * (sqr(t.f) * p + t.kappa * (p - x / t.a * t.f));
}

/* max sqrt(J2) - A k/theta, and its derivative by alpha < 1. */
bool excess_of_peak(const probe &call, const ball &alpha, ball *excess, ball *slope)
{
    const double *v = call.value, *r = call.result;
    const traction t = sliding_contact(alpha, v[3], v[4]);
    extremum at;
    const bool is_below = r[3] > 0;
    if (!(is_below ? find_stationary(&at, t, r[2], r[3]) : find_surface_maximum(&at, t, r[2])))
        return false;
    const ball by_alpha =
        is_below ? J2_by_alpha_below(t, {at.x, at.y}) : J2_by_alpha_at_surface(t, at.x);
    const ball peak = sqrt(at.J2);
    *slope = by_alpha / alpha / peak / 2;
    *excess = peak - ball(v[5]) / v[0] * v[2];
    return true;
}

/* Whether it yields while the contact is less than 1e14 a wide, by more than rounding. */
bool yields_at_all(const probe &call)
{
    static const double WIDEST = 1e-14;
    const precision here(512);
    probe at = call;
    const double *v = call.value;
    double limit;
    at.value[5] *= 1 + 1e-13;
    if (rwedge_yield_point(WIDEST, v[3], v[4], &limit, &at.result[2], &at.result[3]) != RWEDGE_OK)
        return true;
    ball excess, slope;
    return excess_of_peak(at, WIDEST, &excess, &slope) && excess > 0;
}

/* The peak of sqrt(J2), in theta/A, from what a tip alpha has, so that all tips come up.
 * result[1] is alpha of the library's load, result[2], result[3] where it yields. */
bool draw_yield_load(probe *call)
{
    double v[3], *r = call->result;
    some_geometry(call, v);
    const double f = argument(call, "f", chance(call, 0.1) ? some_friction(call) : uniform(call));
    const double nu = argument(call, "nu", some_poisson(call));
    const double tip = log_between(call, 1e-13, 100),
                 peak = rwedge_load(tip) / rwedge_elastic_limit(tip, f, nu);
    const double k = argument(call, "k", v[0] / v[2] * peak);
    if (v[1] == 0)
        return false;
    r[0] = rwedge_yield_load(v[0], v[1], v[2], f, nu, k);
    if (isinf(r[0]) && !yields_at_all(*call))
        return false;
    r[1] = v[1] / rwedge_half_width(v[0], v[1], v[2], r[0]);
    double limit;
    return gives_if(call,
                    isinf(r[0]) || rwedge_yield_point(fmin(1, r[1]), f, nu, &limit, &r[2], &r[3]));
}

/* For Hertz the peak is that of alpha = 1 over alpha. */
bool hertz_alpha(const probe &call, ball *alpha)
{
    const double *v = call.value;
    ball excess, slope;
    if (!excess_of_peak(call, 1, &excess, &slope))
        return false;
    *alpha = 1 + excess / (ball(v[5]) / v[0] * v[2]);
    return true;
}

/* |d ln(alpha)/d ln(k)|, about. */
double condition_of(const ball &alpha, const probe &call)
{
    const double *v = call.value;
    ball excess, slope;
    if (call.result[1] >= 1 || !excess_of_peak(call, alpha, &excess, &slope))
        return 1;
    return fabs(v[5] / v[0] * v[2] / middle(slope * alpha));
}

ball judge_yield_load(const probe &call)
{
    ball alpha;
    const auto balance = [&call](const ball &at, ball *excess, ball *slope) {
        return excess_of_peak(call, at, excess, slope);
    };
    if (!(call.result[1] >= 1 ? hertz_alpha(call, &alpha)
                              : find_parameter(&alpha, call.result[1], balance)))
        return unknown();
    const ball P = normal_load(call.value, call.value[1] / alpha);
    return relative_error(call.result[0], P) / fmax(1, 1e-4 * condition_of(alpha, call));
}

#define UNITS "lengths, A 1e-15 to 1e15, all AP/(theta a)"

} // namespace

const row DESIGN_ROWS[] = {
    {"radius", "theta 1e-9 to pi/2; a 1e-15 to 1e15", "relative", DBL_EPSILON, "(1 eps)", 1,
     calling(rwedge_radius, {{{"theta", some_angle}, {"a", some_unit}}}),
     relative_to([](const double *v) { return ball(v[1]) / v[0]; })},
    {"rounding", "the same", "relative", DBL_EPSILON, "(1 eps)", 1,
     calling(rwedge_rounding, {{{"theta", some_angle}, {"R", some_unit}}}),
     relative_to([](const double *v) { return ball(v[1]) * v[0]; })},
    {"half_width", UNITS, "relative", 1e-14, "1e-14", 1, draw_half_width, judge_half_width},
    {"normal_load", UNITS, "relative", 1e-14, "1e-14", 1, draw_normal_load, judge_normal_load},
    {"yield_load", "of tips 1e-13 to 100; f, nu as above", "relative, over max(1, 1e-4 dlnP/dlnk)",
     1e-11, "1e-11", 0.2, draw_yield_load, judge_yield_load},
    {},
};
