/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measures of a stress; the critical plane. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "rows/rows.hpp"
#include "rwedge.h"

namespace
{

static const double EPSILON = DBL_EPSILON;

/* ---- One stress ---- */

/* From 1e-60 to 1e60, next to each other, equal, or 0. */
double some_stress(probe *call, double other)
{
    const double kind = uniform(call);
    return kind < 0.1   ? 0
           : kind < 0.3 ? either_sign(call, near(call, fmax(fabs(other), 1e-59)))
           : kind < 0.4 ? either_sign(call, other)
           : kind < 0.6 ? either_sign(call, fmax(fabs(other), 1e-59) * log_between(call, 1e-9, 1))
                        : either_sign(call, log_between(call, 1e-60, 0.5e60));
}

/* s, d, t and R of the stress. */
struct circle {
    ball s, d, t, R;
};

circle circle_of(const double s[3])
{
    const ball xx = s[0], yy = s[1], t = s[2], d = (yy - xx) / 2;
    return {(xx + yy) / 2, d, t, sqrt(sqr(d) + sqr(t))};
}

/* |(1-2nu) s| */
ball off_plane(const circle &c, double nu)
{
    return abs((1 - 2 * ball(nu)) * c.s);
}

ball von_mises(const double *v)
{
    const circle c = circle_of(v);
    return sqrt(sqr(off_plane(c, v[3])) + 3 * sqr(c.R));
}

/* The largest of |s1-s2|/2 and |s1-szz|/2, |s2-szz|/2, the larger of which is (R + |s-szz|)/2. */
ball largest_shear(const double *v)
{
    const circle c = circle_of(v);
    return max(c.R, (off_plane(c, v[3]) + c.R) / 2);
}

double some_sxx(probe *call)
{
    return some_stress(call, 1);
}
double some_syy(probe *call)
{
    return some_stress(call, call->value[0]);
}
double some_txy(probe *call)
{
    return some_stress(call, call->value[chance(call, 0.5)]);
}

const drawn sxx = {"sxx", some_sxx}, syy = {"syy", some_syy}, txy = {"txy", some_txy},
            ratio = {"nu", some_poisson};

bool draw_principal(probe *call)
{
    double *r = call->result;
    const double *s = call->value;
    for (const drawn &a : {sxx, syy, txy})
        argument(call, a.name, a.value(call));
    return gives_if(call, rwedge_principal_stresses(s[0], s[1], s[2], &r[0], &r[1], &r[2]));
}

/* Of the larger of |s1|, |s2|. */
ball judge_principal(const probe &call)
{
    const circle c = circle_of(call.value);
    const ball scale = abs(c.s) + c.R;
    return max(error_over(call.result[0], c.s + c.R, scale),
               error_over(call.result[1], c.s - c.R, scale));
}

/* Half of the angle of (d, t), which is determined where R is not 0. */
ball judge_angle(const probe &call)
{
    const circle c = circle_of(call.value);
    const ball t = is_zero(c.t) ? 0 : c.t; /* a d below 0 is at pi, not -pi */
    const ball angle = is_zero(c.R) ? 0 : atan2(t, c.d) / 2;
    const ball error = error_over(call.result[2], angle, 1);
    return min(error, abs(pi() - error)); /* angles that differ by pi are of one plane */
}

/* ---- The critical plane of three loads ---- */

enum { LOADS = 3, BITS = 192 };

/* mean + cosine cos(phi) + sine sin(phi) */
struct wave {
    ball mean, cosine, sine;

    wave operator-(const wave &w) const
    {
        return {mean - w.mean, cosine - w.cosine, sine - w.sine};
    }
    wave operator*(const ball &x) const
    {
        return {mean * x, cosine * x, sine * x};
    }
};

ball value_at(const wave &w, const direction &phi)
{
    return w.mean + w.cosine * phi.cosine + w.sine * phi.sine;
}

ball slope_at(const wave &w, const direction &phi)
{
    return w.sine * phi.cosine - w.cosine * phi.sine;
}

/* |mean| + |cosine| + |sine|: above the wave and its derivatives. */
ball bound_of(const wave &w)
{
    return abs(w.mean) + abs(w.cosine) + abs(w.sine);
}

/* The stress of a load, and the peak and the range as the header defines them, in the unit of its
 * error: s^2 (1+nu)/E or (1 + s k/sy) s (1+nu)/E is 1. */
struct plane_problem {
    wave peak[LOADS], range[LOADS];
    ball best, nearly; /* the largest product so far, and what is as good */
};

bool is_fatemi_socie(const probe &call)
{
    return call.arguments == 12;
}

ball largest_principal(const probe &call)
{
    ball s;
    for (int i = 0; i < LOADS; i++) {
        const circle c = circle_of(call.value + 3 * i);
        s = max(s, abs(c.s) + c.R);
    }
    return s;
}

/* Stresses over s; the peak of Fatemi and Socie over 1 + s k/sy. */
plane_problem problem_of(const probe &call)
{
    const bool shear = is_fatemi_socie(call);
    const ball largest = largest_principal(call), s = is_zero(largest) ? 1 : largest;
    const ball k = shear ? s * call.value[11] : 1, nu = call.value[10];
    plane_problem p;
    for (int i = 0; i < LOADS; i++) {
        const circle c = circle_of(call.value + 3 * i);
        const wave normal = {c.s / s, c.d / s, c.t / s};
        if (shear) {
            p.peak[i] =
                wave{1 + k * normal.mean, k * normal.cosine, k * normal.sine} * (1 / (1 + k));
            p.range[i] = {0, normal.sine, -normal.cosine};
        } else { /* half of the range counts */
            p.peak[i] = normal;
            p.range[i] = wave{(1 - 2 * nu) * normal.mean, normal.cosine, normal.sine} * 0.5;
        }
    }
    return p;
}

/* The best from here on is this product, and what is hardly more is as good. */
void set_best(plane_problem *p, const ball &product)
{
    p->best = product;
    p->nearly = product + ldexp(1, -67);
}

/* The product of two waves, both positive, within `reach` of phi: raises the best, and halves the
 * interval until Taylor's bound of the second order says that nothing better is there. */
void climb(plane_problem *p, const wave &x, const wave &y, const ball &x_bound, const ball &y_bound,
           double phi, double reach)
{
    const direction here = direction_of(phi);
    const ball X = value_at(x, here), Y = value_at(y, here), product = X * Y;
    if (X > 0 && Y > 0 && product > p->best)
        set_best(p, product);
    /* |X|'', |Y|'' are below their bounds, (XY)'' below four times the product of these */
    const ball slope = abs(slope_at(x, here) * Y + X * slope_at(y, here));
    const ball top = product + slope * reach + 2 * x_bound * y_bound * sqr(reach);
    if (top <= p->nearly || X + x_bound * reach <= 0 || Y + y_bound * reach <= 0)
        return;
    if (reach < 1e-13) { /* nothing is known: an infinite error */
        p->best = unknown();
        return;
    }
    climb(p, x, y, x_bound, y_bound, phi - reach / 2, reach / 2);
    climb(p, x, y, x_bound, y_bound, phi + reach / 2, reach / 2);
}

/* For each load whose stress may be the peak, and each two whose difference may be the range. It
 * begins with the best known. The circle is within 4 of 0. */
void largest_product(plane_problem *p)
{
    for (const wave &peak : p->peak)
        for (const wave &from : p->range)
            for (const wave &to : p->range) {
                const wave difference = from - to;
                climb(p, peak, difference, bound_of(peak), bound_of(difference), 0, 4);
            }
    p->best = hull(p->best, p->nearly);
}

/* The parameter of the plane at the angle. */
ball product_at(const plane_problem &p, double angle)
{
    const direction phi = direction_of(2 * angle);
    ball most, top = value_at(p.range[0], phi), bottom = top;
    for (int i = 0; i < LOADS; i++) {
        const ball range = value_at(p.range[i], phi);
        most = max(most, value_at(p.peak[i], phi)); /* from 0 */
        top = max(top, range);
        bottom = min(bottom, range);
    }
    return (top - bottom) * most;
}

/* The value over its unit: s^2 (1+nu)/E or (1 + s k/sy) s (1+nu)/E. */
ball in_units(const probe &call)
{
    const ball s = largest_principal(call), E = call.value[9], nu = call.value[10];
    const ball per_compliance = call.result[0] * E / (1 + nu);
    if (is_zero(s))
        return per_compliance;
    return per_compliance / s / (is_fatemi_socie(call) ? 1 + s * call.value[11] : s);
}

/* How far the value is from the largest of all planes, and the named plane's from it. */
ball judge_plane(const probe &call)
{
    const precision here(BITS);
    plane_problem p = problem_of(call);
    const ball own = product_at(p, call.result[1]);
    set_best(&p, own); /* a plane like any other */
    largest_product(&p);
    return max(abs(in_units(call) - p.best), abs(own - p.best));
}

/* Cycles of one size, in which stresses are often 0, equal or opposite. */
void draw_cycle(probe *call, double s[3][LOADS])
{
    static const char *const NAMES[] = {"sxx1", "syy1", "txy1", "sxx2", "syy2",
                                        "txy2", "sxx3", "syy3", "txy3"};
    const double size = log_between(call, 1e-56, 1e56), kind = uniform(call);
    for (int i = 0; i < 3 * LOADS; i++) {
        double v = chance(call, 0.1) ? 0 : size * between(call, -1, 1);
        if (i >= 3 && kind < 0.3)
            v = kind < 0.1 ? s[i % 3][0] : kind < 0.2 ? -s[i % 3][0] : i * s[i % 3][0];
        if (i >= 3 && kind >= 0.3 && kind < 0.4)
            v = near(call, s[i % 3][i / 3 - 1]);
        s[i % 3][i / 3] = argument(call, NAMES[i], v);
    }
}

bool draw_smith_watson_topper(probe *call)
{
    double s[3][LOADS];
    draw_cycle(call, s);
    const double E = argument(call, "E", log_between(call, 1e-3, 1e6)),
                 nu = argument(call, "nu", some_poisson(call));
    return gives_if(call, rwedge_smith_watson_topper(LOADS, s[0], s[1], s[2], E, nu,
                                                     &call->result[0], &call->result[1]));
}

double some_k_over_sy(probe *call, double s[3][LOADS])
{
    const double k = log_between(call, 1e-3, 1e3) / fmax(fabs(s[0][0]), 1e-56);
    return argument(call, "k_over_sy", chance(call, 0.1) ? 0 : k);
}

bool draw_fatemi_socie(probe *call)
{
    double s[3][LOADS];
    draw_cycle(call, s);
    const double E = argument(call, "E", log_between(call, 1e-3, 1e6)),
                 nu = argument(call, "nu", some_poisson(call)), k = some_k_over_sy(call, s);
    return gives_if(call, rwedge_fatemi_socie(LOADS, s[0], s[1], s[2], E, nu, k, &call->result[0],
                                              &call->result[1]));
}

#define STRESS "1e-60 to 1e60, 0, dense where equal"

} // namespace

const row MEASURE_ROWS[] = {
    {"von_mises", STRESS "; nu", "relative", 4 * EPSILON, "4 eps", 1,
     calling(rwedge_von_mises, {{sxx, syy, txy, ratio}}), relative_to(von_mises)},
    {"out_of_plane_stress", "the same", "relative", 4 * EPSILON, "4 eps", 1,
     calling(rwedge_out_of_plane_stress, {{sxx, syy, ratio}}),
     relative_to([](const double *v) { return v[2] * (ball(v[0]) + v[1]); })},
    {"largest_shear", "the same", "relative", 4 * EPSILON, "4 eps", 1,
     calling(rwedge_largest_shear, {{sxx, syy, txy, ratio}}), relative_to(largest_shear)},
    {"principal_stresses", "the same", "of the larger of \\|s1\\|, \\|s2\\|", 4 * EPSILON, "4 eps",
     1, draw_principal, judge_principal},
    {"principal_stresses, angle", "the same", "absolute", 4 * EPSILON, "4 eps", 1, draw_principal,
     judge_angle},
    {"smith_watson_topper", "three loads, often equal or opposite", "of s^2 (1+nu)/E", 1e-14,
     "1e-14", 0.1, draw_smith_watson_topper, judge_plane},
    {"fatemi_socie", "the same; k/sy", "of (1 + s k/sy) s (1+nu)/E", 1e-14, "1e-14", 0.1,
     draw_fatemi_socie, judge_plane},
    {},
};
