/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Elastic limits, and the points that yield. */
#include <math.h>

#include "references/root.hpp"
#include "rows/rows.hpp"
#include "rwedge.h"
#include "references/strength.hpp"

namespace
{

double some_tip(probe *call)
{
    const double alpha = some_rounded_alpha(call);
    return alpha < 1e-14 ? log_between(call, 1e-14, 1) : alpha;
}

/* Not the sharp wedge, whose limits are exact. */
void some_strength(probe *call)
{
    argument(call, "alpha", some_tip(call));
    argument(call, "f", some_friction(call));
    argument(call, "nu", some_poisson(call));
}

/* The maximum at (x, y) of the contact of the first three arguments. */
extremum enclosed(const probe &call)
{
    const double *v = call.value;
    return extremum_near({fmin(v[0], 1), v[1], v[2]}, call.result[1], call.result[2]);
}

/* result[0] is a limit, result[1], result[2] where it is. */
ball judge_limit(const probe &call)
{
    return relative_error(call.result[0], limit_of(fmin(call.value[0], 1), enclosed(call).J2));
}

/* There is yield at the surface: neither is all of it as high, nor is it 0. */
bool yields_at_surface(const probe &call)
{
    return call.value[2] < 0.5 || call.value[1] > 0;
}

bool yields_at_point(const probe &call)
{
    return yields_at_surface(call) || call.value[0] < 1;
}

/* The limit is the smaller one of the two branches, and neither of them is below it. */
bool draw_elastic_limit(probe *call)
{
    double *r = call->result, limit, x, y;
    const double *v = call->value;
    some_strength(call);
    if (rwedge_yield_point(v[0], v[1], v[2], &r[0], &r[1], &r[2]) != RWEDGE_OK)
        r[0] = NAN;
    if (rwedge_surface_yield(v[0], v[1], v[2], &limit, &x) == RWEDGE_OK && !(r[0] <= limit))
        r[0] = NAN;
    if (rwedge_subsurface_yield(v[0], v[1], v[2], &limit, &x, &y) == RWEDGE_OK && !(r[0] <= limit))
        r[0] = NAN;
    if (rwedge_elastic_limit(v[0], v[1], v[2]) != r[0])
        r[0] = NAN;
    return yields_at_point(*call);
}

/* ---- Its gradient ---- */

bool draw_limit_gradient(probe *call)
{
    double *r = call->result, limit;
    const double *v = call->value;
    some_strength(call);
    if (rwedge_yield_point(v[0], v[1], v[2], &limit, &r[1], &r[2]) != RWEDGE_OK ||
        rwedge_elastic_limit_gradient(v[0], v[1], v[2], &r[3], &r[4], &r[5], &r[6]) != RWEDGE_OK ||
        r[6] != (r[2] == 0))
        r[3] = NAN;
    return yields_at_point(*call);
}

/* d/df of J2 where the traction is f times the pressure, at a fixed point. */
ball J2_by_friction(const sliding_contact &t, const complex_ball &z)
{
    const potentials N = t.shape.at(z);
    return J2_change(sliding(t, N), superposed({}, N), t.kappa);
}

/* -alpha d/dalpha of J2 at a place that keeps its x/a, y/a. */
ball J2_by_half_width(const sliding_contact &t, const complex_ball &z)
{
    return J2_change(sliding(t, t.shape.at(z)), sliding(t, by_half_width(t.shape, z)), t.kappa);
}

/* Over the derivative or the limit, the limit over alpha for that by alpha, and times the flatness
 * where the maximum is flat. Beyond f = 100 a maximum may be next to the edge, within so many
 * roundings of x. */
ball judge_limit_gradient(const probe &call)
{
    const double *v = call.value, *r = call.result, alpha = fmin(v[0], 1);
    const extremum at = enclosed(call);
    const sliding_contact t(alpha, v[1], v[2]);
    const complex_ball z(at.x, at.y);
    const ball limit = limit_of(alpha, at.J2), half = limit / (2 * at.J2);
    const ball of_load =
        limit / t.shape.load() * (alpha * t.shape.c0 - t.shape.phi0) / sqr(ball(alpha));
    const ball by_alpha = v[0] < 1 ? of_load + half * J2_by_half_width(t, z) / alpha : ball(0);
    const ball by_f = v[1] > 0 ? -half * J2_by_friction(t, z) : ball(0);
    const ball by_nu = half * sqr(sliding(t, t.shape.at(z)).s) * 4 * (1 - 2 * ball(v[2])) / 3;
    return max(error_over(r[3], by_alpha, max(abs(by_alpha), limit / alpha)),
               max(error_over(r[4], by_f, max(abs(by_f), limit)),
                   error_over(r[5], by_nu, max(abs(by_nu), limit)))) *
           fmin(1, at.flatness) * fmin(1, 1e4 / (v[1] * v[1] + 1));
}

bool draw_subsurface(probe *call)
{
    double *r = call->result;
    const double *v = call->value;
    some_strength(call);
    const int32_t status = rwedge_subsurface_yield(v[0], v[1], v[2], &r[0], &r[1], &r[2]);
    return gives(call, status) && status != RWEDGE_EABSENT;
}

/* Over |z|, or over alpha at the surface, and times the flatness where the maximum is flat: next
 * to it J2 falls by 1 - flatness (distance/depth)^2/2. */
ball judge_place(const probe &call)
{
    const extremum at = enclosed(call);
    const double *r = call.result, tip = fmin(call.value[0], 1);
    const ball scale = r[2] == 0 ? tip : hypot(at.x, at.y);
    return hypot(error_over(r[1], at.x, scale), error_over(r[2], at.y, scale)) *
           fmin(1, at.flatness);
}

/* ---- Critical friction ---- */

/* By how much the maximum below exceeds that of the surface, for all f of the ball, and its
 * derivative by f (that of J2 at the maxima). */
value_slope excess_below(const probe &call, const ball &f)
{
    const double *r = call.result;
    const sliding_contact t(fmin(call.value[0], 1), f, call.value[1]);
    const extremum below = extremum_near(t, r[1], r[2]), surface = extremum_near(t, r[3], 0);
    return {below.J2 - surface.J2,
            J2_by_friction(t, {below.x, below.y}) - J2_by_friction(t, surface.x)};
}

/* The places of both maxima for that friction, in the probe's results. */
bool find_places(probe *call, double f)
{
    double *r = call->result, limit;
    const double alpha = call->value[0], nu = call->value[1];
    return rwedge_subsurface_yield(alpha, f, nu, &limit, &r[1], &r[2]) == RWEDGE_OK &&
           rwedge_surface_yield(alpha, f, nu, &limit, &r[3]) == RWEDGE_OK;
}

/* The promise lets 0 stand for what is below 1e-7: it is wrong where the maximum below is still
 * the higher one there. */
bool is_wrongly_zero(probe *call)
{
    static const double LEAST = 1e-7;
    const precision here(512);
    return find_places(call, LEAST) && excess_below(*call, LEAST).value > 0;
}

bool draw_critical_friction(probe *call)
{
    const double alpha = argument(call, "alpha", some_tip(call)),
                 nu = argument(call, "nu", some_poisson(call));
    double *r = call->result;
    r[0] = rwedge_critical_friction(alpha, nu);
    if (r[0] == 0 && !is_wrongly_zero(call))
        return false;
    if (r[0] == 0 || !find_places(call, r[0]))
        r[0] = NAN;
    return true;
}

/* The error to first order. The promise is 1e-11 f, or 1e-14/f. */
ball judge_critical_friction(const probe &call)
{
    const double f = call.result[0];
    const value_slope excess = excess_below(call, f);
    return abs(excess.value / excess.slope) / fmax(f, 1e-3 / f);
}

const auto draw_surface = calling(rwedge_surface_yield, {some_strength}, yields_at_surface);

} // namespace

const row STRENGTH_ROWS[] = {
    {"elastic_limit, yield_point", "alpha 1e-14 to 1e60; f 0 to 1e6; nu 0 to 0.5", "relative",
     1e-12, "1e-12", 1, draw_elastic_limit, judge_limit},
    {"elastic_limit_gradient", "the same",
     "of max(derivative, limit; limit/alpha), times flatness, over max(1, (f/100)^2)", 1e-11,
     "1e-11", 0.1, draw_limit_gradient, judge_limit_gradient},
    {"subsurface_yield", "where it exists", "relative", 1e-12, "1e-12", 1, draw_subsurface,
     judge_limit},
    {"surface_yield", "the same", "relative", 1e-12, "1e-12", 1, draw_surface, judge_limit},
    {"subsurface_yield, place", "where it exists", "of \\|z\\|, times flatness", 1e-12,
     "about 1e-12", 0.1, draw_subsurface, judge_place},
    {"surface_yield, place", "the same", "of alpha, times flatness", 1e-12, "about 1e-12", 0.1,
     draw_surface, judge_place},
    {"critical_friction", "alpha, nu, where not 0", "of max(f, 0.001/f)", 1e-11, "1e-11", 0.1,
     draw_critical_friction, judge_critical_friction},
    {},
};
