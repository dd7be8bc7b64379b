/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Materials, contact law, pressure, coefficients of the series, partial slip, maximum tension. */
#include <float.h>
#include <math.h>

#include "rows/rows.hpp"
#include "rwedge.h"

namespace
{

const double EPSILON = DBL_EPSILON;

/* ---- Materials ---- */

double some_modulus(probe *call)
{
    return chance(call, 0.05)  ? HUGE_VAL
           : chance(call, 0.1) ? log_between(call, 1e-29, 1e29)
                               : log_between(call, 1, 1e6);
}

double some_ratio(probe *call)
{
    const double kind = uniform(call);
    return kind < 0.6   ? between(call, -1, 0.5)
           : kind < 0.7 ? -1 + log_between(call, 1e-16, 1)
           : kind < 0.9 ? 0.5 - log_between(call, 1e-16, 0.5)
                        : 0.5 * (int)(between(call, 0, 2));
}

/* Of two bodies, often alike. */
void some_bodies(probe *call)
{
    const double same = uniform(call), *v = call->value;
    argument(call, "E1", some_modulus(call));
    argument(call, "nu1", some_ratio(call));
    argument(call, "E2", same < 0.2 && isfinite(v[0]) ? near(call, v[0]) : some_modulus(call));
    argument(call, "nu2", same < 0.1 ? v[1] : some_ratio(call));
}

bool has_compliance(const probe &call)
{
    const double *v = call.value;
    return v[1] > -1 && v[3] > -1 && !(isinf(v[0]) && isinf(v[2]));
}

/* 2(1-nu^2)/E. */
ball share(double E, double nu)
{
    return isinf(E) ? 0 : 2 * (1 - sqr(ball(nu))) / E;
}

/* Dundurs' own form with the moduli mu = E/(2(1+nu)) and kappa: mu (kappa -+ 1) of the other body,
 * times 1/(mu1 mu2). */
ball beta_with(ball (*kappa_of)(const ball &nu), const double *v)
{
    ball above, below;
    for (int body = 0; body < 2; body++) {
        const double E = v[2 * body], nu = v[2 * body + 1];
        if (isinf(E))
            continue;
        const ball per_mu = 2 * (1 + ball(nu)) / E, kappa = kappa_of(nu);
        above += (body == 0 ? -1 : 1) * per_mu * (kappa - 1);
        below += per_mu * (kappa + 1);
    }
    return above / below;
}

ball beta(const double *v)
{
    return beta_with([](const ball &nu) { return 3 - 4 * nu; }, v);
}

ball beta_of_plane_stress(const double *v)
{
    return beta_with([](const ball &nu) { return (3 - nu) / (1 + nu); }, v);
}

/* ---- Contact law ---- */

/* alpha^2 d/dalpha of the load is alpha c0 - phi0. */
ball load_slope(const double *v)
{
    const patch p(*v, 1);
    return *v > 0 ? (*v * p.c0 - p.phi0) / sqr(ball(*v)) : 0;
}

ball tension_slope(const double *v)
{
    return *v < 1 ? -2 * load_slope(v) / sqr(patch(*v, 1).load()) : 0;
}

double some_load(probe *call)
{
    const double hertz = 1.5707963267948966, kind = uniform(call);
    return kind < 0.3    ? near(call, hertz)
           : kind < 0.6  ? hertz * log_between(call, 1, 100)
           : kind < 0.8  ? log_between(call, 1, 1e17)
           : kind < 0.9  ? log_between(call, 1e-10, hertz)
           : kind < 0.95 ? near(call, 2e8)
                         : log_between(call, 1e-119, 1e60);
}

/* b/a, the half-width for a = 1, is what is enclosed. */
ball judge_a_over_b(const probe &call)
{
    return relative_error(call.result[0], 1 / half_width(1, call.value[0], 1 / call.result[0]));
}

/* ---- Pressure ---- */

/* x is the last argument. */
bool is_no_apex(const probe &call)
{
    return call.value[0] > 0 || call.value[call.arguments - 1] != 0;
}

/* Eq. (10): (2/pi) [phi0/alpha - ln tan(phi0/2)]. */
ball peak(const double *v)
{
    const ball phi0 = patch(*v, 1).phi0;
    return 2 / pi() * (phi0 / *v - (*v < 1 ? log(tan(phi0 / 2)) : ball(0)));
}

/* Eq. (9): (1/pi) [2 phi0 cot(phi0) - ln(tan(phi0) sin(2 phi0)/2)]. */
ball transition(const double *v)
{
    const ball phi0 = patch(*v, 1).phi0;
    return *v < 1 ? (2 * phi0 / tan(phi0) - log(tan(phi0) * sin(2 * phi0) / 2)) / pi() : ball(0);
}

/* ---- Coefficients ---- */

/* pi b_n m (m^2-1)/4 = (-1)^n [m sin(m phi0) cot(phi0) - cos(m phi0)], and its derivative by
 * phi0, but for the sign. */
struct bracket {
    ball value, slope;
};

bracket bracket_of(const ball &phi0, double m)
{
    const ball sine = sin(m * phi0), cosine = cos(m * phi0), cot = 1 / tan(phi0);
    return {m * sine * cot - cosine, m * (m * cosine * cot - sqr(cot) * sine)};
}

/* Within 1e-9 of a zero, the zero at alpha = 1 not counted, the error is taken of the values
 * around, sqrt(1 + (m cot)^2) of the bracket, 1e8 times smaller, as the promise there is: 1e-22
 * for 1e-14. */
ball scale_of(const bracket &b, const ball &phi0, double m)
{
    /* d ln(alpha) = cot(phi0) d phi0: the zero is at the relative distance bracket/(tan slope) */
    const ball tangent = tan(phi0);
    if (middle(abs(b.value / (tangent * b.slope))) < 1e-9 && middle(tangent) < 1e6)
        return max(abs(b.value), 1e-8 * sqrt(1 + sqr(m / tangent)));
    return abs(b.value);
}

double some_number(probe *call)
{
    return floor(uniform(call) < 0.4 ? between(call, 0, 20) : log_between(call, 1, 2147483647.0));
}

ball judge_coefficient(const probe &call)
{
    const double alpha = call.value[0], n = call.value[1], m = 2 * n + 1;
    const double sign = fmod(n, 2) == 1 ? -1 : 1;
    if (m == 1) /* (2/pi) load */
        return relative_error(call.result[0], 2 / pi() * patch(alpha, 1).load());
    if (alpha >= 1)
        return relative_error(call.result[0], 0);
    if (alpha == 0)
        return relative_error(call.result[0], sign * 4 / (pi() * m));
    const ball phi0 = asin(ball(alpha)), factor = 4 / (pi() * m * (m - 1) * (m + 1));
    const bracket b = bracket_of(phi0, m);
    return error_over(call.result[0], sign * factor * b.value, factor * scale_of(b, phi0, m));
}

/* ---- Partial slip ---- */

/* The half-width under the load F(1)(1-Q/(fP)), Eq. (25). */
ball judge_stick_width(const probe &call)
{
    const ball sticking = 1 - ball(call.value[1]), a = call.value[0];
    const ball c =
        is_zero(sticking) ? 0 : half_width(a, patch(a, 1).load() * sticking, call.result[0]);
    return relative_error(call.result[0], c);
}

/* 1 - F(c)/F(1). */
ball shear_ratio(const double *v)
{
    return v[1] == 1 ? 0 : v[1] == 0 ? 1 : 1 - patch(v[0], v[1]).load() / patch(v[0], 1).load();
}

/* p(x; 1) - p(x; c), Eq. (23), (26), (27). */
ball shear(const double *v)
{
    return pressure(v[0], 1, v[2]) - (v[1] > 0 ? pressure(v[0], v[1], v[2]) : 0);
}

#define ALPHA "0, 1e-60 to 1e60; dense at 1"

const drawn alpha = {"alpha", some_alpha}, tip = {"alpha", some_rounded_alpha}, c = {"c", some_c};

} // namespace

const row LAW_ROWS[] = {
    {"compliance", "E 1e-29 to 1e29, rigid; nu -1 to 0.5", "relative", 4 * EPSILON, "4 eps", 1,
     calling(rwedge_compliance, {some_bodies}, has_compliance),
     relative_to([](const double *v) { return share(v[0], v[1]) + share(v[2], v[3]); })},
    {"dundurs_beta", "the same", "absolute", 4 * EPSILON, "4 eps", 1,
     calling(rwedge_dundurs_beta, {some_bodies}, has_compliance),
     over([](const double *) { return ball(1); }, beta)},
    {"dundurs_beta_plane_stress", "the same", "absolute", 4 * EPSILON, "4 eps", 1,
     calling(rwedge_dundurs_beta_plane_stress, {some_bodies}, has_compliance),
     over([](const double *) { return ball(1); }, beta_of_plane_stress)},
    {"load", ALPHA, "relative", 4 * EPSILON, "4 eps", 1, calling(rwedge_load, {alpha}),
     relative_to([](const double *v) { return patch(*v, 1).load(); })},
    {"load_derivative", ALPHA, "relative", 1e-14, "1e-14", 1,
     calling(rwedge_load_derivative, {alpha}), relative_to(load_slope)},
    {"max_tension_derivative", ALPHA, "relative", 1e-14, "1e-14", 1,
     calling(rwedge_max_tension_derivative, {alpha}), relative_to(tension_slope)},
    {"a_over_b", "1e-119 to 1e60; dense at pi/2, 2e8", "relative", 1e-14, "1e-14", 1,
     calling(rwedge_a_over_b, {{"AP_over_theta_a", some_load}}), judge_a_over_b},
    {"pressure", "alpha; x dense at 0, ±alpha, ±1", "relative", 1e-12, "1e-12", 1,
     calling(rwedge_pressure,
             {alpha, {"x", [](probe *call) { return some_place(call, call->value[0], 1); }}},
             is_no_apex),
     relative_to([](const double *v) { return pressure(v[0], 1, v[1]); })},
    {"peak_pressure", ALPHA, "relative", 1e-14, "1e-14", 1, calling(rwedge_peak_pressure, {tip}),
     relative_to(peak)},
    {"transition_pressure", ALPHA, "relative", 1e-14, "1e-14", 1,
     calling(rwedge_transition_pressure, {tip}), relative_to(transition)},
    {"coefficient", "alpha; n 0 to 2^31-1", "relative; at zeros 1e-8 of values around", 1e-14,
     "1e-14", 1, calling(rwedge_coefficient, {alpha, {"n", some_number}}), judge_coefficient},
    {"stick_width", "alpha; Q/(fP) dense at 0, 1", "relative", 1e-14, "1e-14", 1,
     calling(rwedge_stick_width,
             {alpha, {"Q_over_fP", [](probe *call) { return some_fraction(call, 0.5); }}}),
     judge_stick_width},
    {"shear_ratio", "alpha; c dense at 0, alpha, 1", "relative", 1e-14, "1e-14", 1,
     calling(rwedge_shear_ratio, {alpha, c}), relative_to(shear_ratio)},
    {"shear", "alpha, c; x dense at 0, ±alpha, ±c, ±1", "of 1 + \\|A p/theta\\|", 1e-14, "1e-14", 1,
     calling(rwedge_shear,
             {alpha,
              c,
              {"x", [](probe *call) { return some_place(call, call->value[0], call->value[1]); }}},
             is_no_apex),
     over([](const double *v) { return 1 - pressure(v[0], 1, v[2]); }, shear)},
    /* 2 f at the trailing edge over f load; for alpha >= 1 as for 1 */
    {"max_tension", "alpha", "relative", 1e-14, "1e-14", 1, calling(rwedge_max_tension, {alpha}),
     relative_to([](const double *v) { return 2 / patch(fmin(*v, 1), 1).load(); })},
    {},
};
