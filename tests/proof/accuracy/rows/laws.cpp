/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Materials, contact law, pressure, coefficients of the series. */
#include <float.h>
#include <math.h>

#include "rows/rows.hpp"
#include "rwedge.h"

namespace
{

static const double EPSILON = DBL_EPSILON;

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

void some_bodies(probe *call, double v[4])
{
    const double same = uniform(call);
    v[0] = argument(call, "E1", some_modulus(call));
    v[1] = argument(call, "nu1", some_ratio(call));
    v[2] =
        argument(call, "E2", same < 0.2 && isfinite(v[0]) ? near(call, v[0]) : some_modulus(call));
    v[3] = argument(call, "nu2", same < 0.1 ? v[1] : some_ratio(call));
}

/* The domain of both functions; all that is drawn has an A in its domain. */
bool is_compliant(const double v[4])
{
    return v[0] > 0 && v[2] > 0 && v[1] > -1 && v[3] > -1 && !(isinf(v[0]) && isinf(v[2]));
}

/* 2(1-nu^2)/E. */
ball share(double E, double nu)
{
    return isinf(E) ? 0 : 2 * (1 - sqr(nu)) / E;
}

bool draw_compliance(probe *call)
{
    double v[4];
    some_bodies(call, v);
    call->result[0] = rwedge_compliance(v[0], v[1], v[2], v[3]);
    return is_compliant(v);
}

ball judge_compliance(const probe &call)
{
    const double *v = call.value;
    return relative_error(call.result[0], share(v[0], v[1]) + share(v[2], v[3]));
}

bool draw_beta(probe *call)
{
    double v[4];
    some_bodies(call, v);
    call->result[0] = rwedge_dundurs_beta(v[0], v[1], v[2], v[3]);
    return is_compliant(v);
}

/* beta = (l2 s2 - l1 s1)/(s1 + s2), l = (1-2nu)/(2(1-nu)), as Dundurs' own form with the moduli
 * mu = E/(2(1+nu)) and kappa = 3 - 4 nu: mu (kappa -+ 1) of the other body, times 1/(mu1 mu2). */
ball judge_beta(const probe &call)
{
    ball above, below;
    for (int body = 0; body < 2; body++) {
        const double E = call.value[2 * body], nu = call.value[2 * body + 1];
        if (isinf(E))
            continue;
        const ball per_mu = 2 * (1 + ball(nu)) / E, kappa = 3 - 4 * ball(nu);
        above += (body == 0 ? -1 : 1) * per_mu * (kappa - 1);
        below += per_mu * (kappa + 1);
    }
    return error_over(call.result[0], above / below, 1);
}

bool draw_load(probe *call)
{
    return gives(call, rwedge_load(argument(call, "alpha", some_alpha(call))));
}

ball judge_load(const probe &call)
{
    return relative_error(call.result[0], force(call.value[0], 1));
}

bool draw_load_derivative(probe *call)
{
    return gives(call, rwedge_load_derivative(argument(call, "alpha", some_alpha(call))));
}

/* alpha^2 d/dalpha of the load is alpha c0 - phi0. */
ball load_slope(double alpha)
{
    const angle phi = angle_of(alpha, 1);
    return alpha > 0 ? (alpha * phi.c0 - phi.phi0) / sqr(ball(alpha)) : 0;
}

ball judge_load_derivative(const probe &call)
{
    return relative_error(call.result[0], load_slope(call.value[0]));
}

bool draw_tension_derivative(probe *call)
{
    return gives(call, rwedge_max_tension_derivative(argument(call, "alpha", some_alpha(call))));
}

ball judge_tension_derivative(const probe &call)
{
    const double alpha = call.value[0];
    return relative_error(call.result[0],
                          alpha < 1 ? -2 * load_slope(alpha) / sqr(force(alpha, 1)) : 0);
}

bool draw_a_over_b(probe *call)
{
    const double hertz = 1.5707963267948966, kind = uniform(call);
    const double load = kind < 0.3    ? near(call, hertz)
                        : kind < 0.6  ? hertz * log_between(call, 1, 100)
                        : kind < 0.8  ? log_between(call, 1, 1e17)
                        : kind < 0.9  ? log_between(call, 1e-10, hertz)
                        : kind < 0.95 ? near(call, 2e8)
                                      : log_between(call, 1e-119, 1e60);
    return gives(call, rwedge_a_over_b(argument(call, "AP_over_theta_a", load)));
}

/* b/a, the half-width for a = 1, is what is enclosed. */
ball judge_a_over_b(const probe &call)
{
    return relative_error(call.result[0], 1 / half_width(1, call.value[0], 1 / call.result[0]));
}

/* ---- Pressure ---- */

bool draw_pressure(probe *call)
{
    const double alpha = argument(call, "alpha", some_alpha(call)),
                 x = argument(call, "x", some_place(call, alpha, 1));
    call->result[0] = rwedge_pressure(alpha, x);
    return alpha > 0 || x != 0;
}

ball judge_pressure(const probe &call)
{
    return relative_error(call.result[0], pressure(call.value[0], 1, call.value[1]));
}

bool draw_peak(probe *call)
{
    return gives(call, rwedge_peak_pressure(argument(call, "alpha", some_rounded_alpha(call))));
}

/* Eq. (10): (2/pi) [phi0/alpha - ln tan(phi0/2)]. */
ball judge_peak(const probe &call)
{
    const double alpha = call.value[0];
    const ball phi0 = angle_of(alpha, 1).phi0;
    const ball corner = alpha < 1 ? log(tan(phi0 / 2)) : 0;
    return relative_error(call.result[0], 2 / pi() * (phi0 / alpha - corner));
}

bool draw_transition(probe *call)
{
    return gives(call,
                 rwedge_transition_pressure(argument(call, "alpha", some_rounded_alpha(call))));
}

/* Eq. (9): (1/pi) [2 phi0 cot(phi0) - ln(tan(phi0) sin(2 phi0)/2)]. */
ball judge_transition(const probe &call)
{
    if (call.value[0] >= 1)
        return relative_error(call.result[0], 0);
    const ball phi0 = angle_of(call.value[0], 1).phi0;
    return relative_error(call.result[0],
                          (2 * phi0 / tan(phi0) - log(tan(phi0) * sin(2 * phi0) / 2)) / pi());
}

/* ---- Coefficients ---- */

/* pi b_n m (m^2-1)/4 = (-1)^n [m sin(m phi0) cot(phi0) - cos(m phi0)], and its derivative by
 * phi0. */
struct bracket {
    ball value, slope;
};

/* pi b_n m (m^2-1)/4 = (-1)^n [m sin(m phi0) cot(phi0) - cos(m phi0)], and its derivative by
 * phi0, but for the sign. */
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

bool draw_coefficient(probe *call)
{
    const double alpha = argument(call, "alpha", some_alpha(call));
    const double kind = uniform(call);
    const double n = argument(
        call, "n", floor(kind < 0.4 ? between(call, 0, 20) : log_between(call, 1, 2147483647.0)));
    return gives(call, rwedge_coefficient(alpha, (int32_t)n));
}

ball judge_coefficient(const probe &call)
{
    const double alpha = call.value[0], n = call.value[1], m = 2 * n + 1;
    const double sign = fmod(n, 2) == 1 ? -1 : 1;
    if (m == 1) /* (2/pi) load */
        return relative_error(call.result[0], 2 / pi() * force(alpha, 1));
    if (alpha >= 1)
        return relative_error(call.result[0], 0);
    if (alpha == 0)
        return relative_error(call.result[0], sign * 4 / (pi() * m));
    const ball phi0 = asin(ball(alpha)), factor = 4 / (pi() * m * (m - 1) * (m + 1));
    const bracket b = bracket_of(phi0, m);
    return error_over(call.result[0], sign * factor * b.value, factor * scale_of(b, phi0, m));
}

#define ALPHA "0, 1e-60 to 1e60; dense at 1"

} // namespace

const row LAW_ROWS[] = {
    {"compliance", "E 1e-29 to 1e29, rigid; nu -1 to 0.5", "relative", 4 * EPSILON, "4 eps", 1,
     draw_compliance, judge_compliance},
    {"dundurs_beta", "the same", "absolute", 4 * EPSILON, "4 eps", 1, draw_beta, judge_beta},
    {"load", ALPHA, "relative", 4 * EPSILON, "4 eps", 1, draw_load, judge_load},
    {"load_derivative", ALPHA, "relative", 1e-14, "1e-14", 1, draw_load_derivative,
     judge_load_derivative},
    {"max_tension_derivative", ALPHA, "relative", 1e-14, "1e-14", 1, draw_tension_derivative,
     judge_tension_derivative},
    {"a_over_b", "1e-119 to 1e60; dense at pi/2, 2e8", "relative", 1e-14, "1e-14", 1, draw_a_over_b,
     judge_a_over_b},
    {"pressure", "alpha; x dense at 0, ±alpha, ±1", "relative", 1e-12, "1e-12", 1, draw_pressure,
     judge_pressure},
    {"peak_pressure", ALPHA, "relative", 1e-14, "1e-14", 1, draw_peak, judge_peak},
    {"transition_pressure", ALPHA, "relative", 1e-14, "1e-14", 1, draw_transition,
     judge_transition},
    {"coefficient", "alpha; n 0 to 2^31-1", "relative; at zeros 1e-8 of values around", 1e-14,
     "1e-14", 1, draw_coefficient, judge_coefficient},
    {},
};
