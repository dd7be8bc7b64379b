/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Criteria of cycles between two opposite loads, where they have closed forms in the principal
 * stresses s1, s2 and szz. Cycles of more loads are scanned in tests/lib/measures/. */
#include <math.h>

#include <algorithm>

#include "rows/rows.hpp"
#include "rwedge.h"

namespace
{

enum { NU = 3 };

/* ---- Opposite loads ---- */

/* Stresses of one load, and nu; the other load is the opposite one. */
void some_cycle(probe *call)
{
    const double size = log_between(call, 1e-57, 1e57);
    for (const char *name : {"sxx", "syy", "txy"})
        argument(call, name, size * between(call, -1, 1));
    argument(call, "nu", some_poisson(call));
}

/* Whether the principal stresses are apart: where they are nearly equal a curve of planes is nearly
 * as bad, and the header promises less. */
bool are_apart(const double *v)
{
    const double mean = (v[0] + v[1]) / 2, R = hypot((v[0] - v[1]) / 2, v[2]), z = 2 * v[NU] * mean;
    const double least = 1e-3 * (fabs(mean) + R);
    return R > least && fabs(mean + R - z) > least && fabs(mean - R - z) > least;
}

/* Its principal stresses are apart, or are any. */
enum { APART, ANY };

/* A criterion of a cycle, and its plane. Its constants are those that are drawn, and 1 behind them:
 * the yield stress beside k_over_sy. */
std::function<bool(probe *)> of_cycle(int32_t criterion, const std::vector<drawn> &constants,
                                      int loads)
{
    return [=](probe *call) {
        some_cycle(call);
        double opposite[3][2], given[4] = {0, 0, 1};
        if (loads == APART && !are_apart(call->value))
            return false;
        for (const drawn &a : constants)
            a.draw(call);
        std::copy_n(call->value + NU + 1, constants.size(), given);
        for (int i = 0; i < 3; i++)
            opposite[i][0] = call->value[i], opposite[i][1] = -call->value[i];
        return gives(call, rwedge_criterion(criterion, given, 2, opposite[0], opposite[1],
                                            opposite[2], call->value[NU], 0, &call->result[0],
                                            &call->result[1], &call->result[2]));
    };
}

double some_part(probe *call)
{
    return chance(call, 0.1) ? 0 : between(call, 0, 1);
}

/* A number of the size of a stress, or of its inverse. */
double some_stress(probe *call, double lo, double hi)
{
    return fabs(call->value[0]) * between(call, lo, hi);
}

double some_k_over_sy(probe *call)
{
    const double k = fmin(log_between(call, 1e-3, 1e3) / fabs(call->value[0]), 1e60);
    return chance(call, 0.1) ? 0 : k;
}

/* The largest principal stress of the load that was drawn, the one between, the smallest. */
struct principals {
    ball largest, between, smallest, szz;
};

principals principals_of(const probe &call)
{
    const ball sxx = call.value[0], syy = call.value[1], txy = call.value[2];
    const ball twice = sxx + syy, R = hypot(syy - sxx, 2 * txy), szz = twice * call.value[3];
    const ball s1 = (twice + R) / 2, s2 = (twice - R) / 2;
    const ball largest = max(s1, szz), smallest = min(s2, szz);
    return {largest, twice + szz - largest - smallest, smallest, szz};
}

/* |s1+s3|/2 and (s1-s3)/2, of the outermost; and the largest magnitude. */
struct outermost {
    ball mean, half, s;
};

outermost outermost_of(const principals &s)
{
    const ball mean = abs(s.largest + s.smallest) / 2, half = (s.largest - s.smallest) / 2;
    return {mean, half, mean + half};
}

outermost outermost_of(const probe &call)
{
    return outermost_of(principals_of(call));
}

/* (1+nu)/E */
ball per_modulus(const probe &call)
{
    return (1 + ball(call.value[3])) / call.value[4];
}

/* ---- Findley, Fatemi and Socie ---- */

/* k |s1+s3|/2 + sqrt(1+k^2) (s1-s3)/2 */
ball judge_findley(const probe &call)
{
    const outermost at = outermost_of(call);
    const ball k = call.value[4];
    return error_over(call.result[0], k * at.mean + sqrt(1 + sqr(k)) * at.half, (1 + k) * at.s);
}

/* (1+nu)/E (s1-s3) */
ball judge_fatemi_socie(const probe &call)
{
    const outermost at = outermost_of(call);
    return error_over(call.result[0], 2 * at.half * per_modulus(call), at.s * per_modulus(call));
}

/* ---- Smith, Watson and Topper ---- */

struct weights {
    ball stress, strain;
};

/* The largest |stress strain| on the line between: at its ends, or where the slope is 0. */
ball largest_on_edge(const weights &from, const weights &to)
{
    const ball d = to.stress - from.stress, e = to.strain - from.strain;
    const ball place = (from.stress * e + from.strain * d) / (-2 * d * e); /* 0 to 1 */
    const ball ends = max(abs(from.stress * from.strain), abs(to.stress * to.strain));
    if (place > 0 && place < 1)
        return max(ends, abs((from.stress + d * place) * (from.strain + e * place)));
    return ends;
}

/* A plane's normal stress and strain are means of the principal ones, with the squares of the
 * normal's cosines as weights: two linear functions on a triangle, whose product is largest on an
 * edge. */
ball judge_smith_watson_topper(const probe &call)
{
    const principals s = principals_of(call);
    const weights corner[] = {{s.largest, s.largest - s.szz},
                              {s.between, s.between - s.szz},
                              {s.smallest, s.smallest - s.szz}};
    ball most;
    for (int i = 0; i < 3; i++)
        most = max(most, largest_on_edge(corner[i], corner[(i + 1) % 3]));
    return error_over(call.result[0], most * per_modulus(call),
                      sqr(outermost_of(s).s) * per_modulus(call));
}

/* ---- Susmel, McDiarmid ---- */

/* (s1-s3)/2 + kappa min(|s1+s3|/(s1-s3), rho_lim), over the first and kappa */
ball judge_modified_wohler(const probe &call)
{
    const outermost at = outermost_of(call);
    const double kappa = call.value[4], lambda = call.value[5], rho_lim = call.value[6];
    const ball most = rho_lim > 0 ? kappa * ball(rho_lim) : ball(lambda) / 2;
    const ball by_ratio = kappa * at.mean / at.half;
    return error_over(call.result[0], at.half + (by_ratio < most ? by_ratio : most),
                      at.s + kappa * at.s / at.half); /* s + kappa s/tau_a */
}

ball judge_mcdiarmid(const probe &call)
{
    const outermost at = outermost_of(call);
    const ball t_A = call.value[4], su = call.value[5];
    return error_over(call.result[0], at.half / t_A + at.mean / su / 2, at.s * (1 / t_A + 1 / su));
}

/* ---- Crossland, Dang Van ---- */

/* The sphere's centre is 0. Its radius is sqrt(J2) of either load. */
template <bool is_dang_van> ball judge_sphere(const probe &call)
{
    const principals s = principals_of(call);
    const outermost at = outermost_of(s);
    const ball hydrostatic = abs(s.largest + s.between + s.smallest) / 3, alpha = call.value[4];
    const ball J2 =
        (sqr(s.largest - s.between) + sqr(s.between - s.smallest) + sqr(s.smallest - s.largest)) /
        6;
    return error_over(call.result[0], (is_dang_van ? at.half : sqrt(J2)) + alpha * hydrostatic,
                      (1 + alpha) * at.s);
}

/* ---- The planes that contain z ---- */

/* The stress across a plane at the angle phi from the principal one is mean + R cos(phi), the shear
 * R sin(phi); and both at the plane that the library names, with the strain but for (1+nu)/E. */
struct on_z {
    ball mean, R, normal, shear, strain;

    explicit on_z(const probe &call)
    {
        const ball sxx = call.value[0], syy = call.value[1], txy = call.value[2];
        const ball s = (sxx + syy) / 2, d = (syy - sxx) / 2;
        const direction plane = direction_of(2 * ball(call.result[1]));
        const ball beside = d * plane.cosine + txy * plane.sine;
        mean = abs(s);
        R = sqrt(sqr(d) + sqr(txy));
        normal = abs(s + beside);
        shear = abs(txy * plane.cosine - d * plane.sine);
        strain = abs((1 - 2 * ball(call.value[3])) * s + beside);
    }
};

/* How far the value is from the largest of all planes, and the named plane's from it. */
ball error_on_z(const probe &call, const ball &largest, const ball &named, const ball &unit)
{
    return max(error_over(call.result[0], largest * per_modulus(call), unit * per_modulus(call)),
               abs((named - largest) / unit));
}

/* Stress and strain are largest in magnitude across the same principal plane. */
ball judge_swt_on_z(const probe &call)
{
    const on_z at(call);
    const ball s = at.mean + at.R, strain = s - 2 * ball(call.value[3]) * at.mean;
    return error_on_z(call, s * strain, at.normal * at.strain, sqr(s));
}

/* 2 R sin(phi) (A + B cos(phi)), A = 1 + k mean, B = k R: where A cos(phi) + B cos(2 phi) = 0. */
ball judge_fatemi_socie_on_z(const probe &call)
{
    const on_z at(call);
    const ball k = call.value[5], s = at.mean + at.R, A = 1 + k * at.mean, B = k * at.R;
    const ball cosine = 2 * B / (A + sqrt(sqr(A) + 8 * sqr(B)));
    const ball largest = 2 * at.R * sqrt(1 - sqr(cosine)) * (A + B * cosine);
    return error_on_z(call, largest, 2 * at.shear * (1 + k * at.normal), s * (1 + k * s));
}

#define OPPOSITE "two opposite loads, principal stresses apart by 1e-3"

const drawn E = {"E", [](probe *call) { return log_between(call, 1e-3, 1e6); }},
            k_over_sy = {"k_over_sy", some_k_over_sy}, k = {"k", some_part},
            alpha = {"alpha", some_part},
            kappa = {"kappa", [](probe *call) { return some_stress(call, 0, 1); }},
            lambda = {"lambda", [](probe *call) { return 1e-50 + some_stress(call, 0.1, 4); }},
            rho_lim = {"rho_lim",
                       [](probe *call) { return chance(call, 0.5) ? 0 : between(call, 0.1, 2); }},
            t_A = {"t_A", [](probe *call) { return 1e-50 + some_stress(call, 0.1, 10); }},
            su = {"su", [](probe *call) { return call->value[4] * between(call, 1, 10); }};

} // namespace

const row PLANE_ROWS[] = {
    {"swt_in_plane", "two opposite loads", "of s^2 (1+nu)/E", 1e-14, "1e-14", 1,
     of_cycle(RWEDGE_MEASURE_SWT_IN_PLANE, {E}, ANY), judge_swt_on_z},
    {"fatemi_socie_in_plane", "two opposite loads; k/sy", "of (1 + s k/sy) s (1+nu)/E", 1e-14,
     "1e-14", 1, of_cycle(RWEDGE_MEASURE_FATEMI_SOCIE_IN_PLANE, {E, k_over_sy}, ANY),
     judge_fatemi_socie_on_z},
    {"swt", OPPOSITE, "of s^2 (1+nu)/E", 1e-14, "1e-14", 0.1,
     of_cycle(RWEDGE_MEASURE_SWT, {E}, APART), judge_smith_watson_topper},
    {"fatemi_socie", OPPOSITE "; k/sy 0", "of s (1+nu)/E", 1e-14, "1e-14", 0.1,
     of_cycle(RWEDGE_MEASURE_FATEMI_SOCIE, {E}, APART), judge_fatemi_socie},
    {"findley", OPPOSITE, "of (1+k) s", 1e-14, "1e-14", 0.1,
     of_cycle(RWEDGE_MEASURE_FINDLEY, {k}, APART), judge_findley},
    {"modified_wohler", OPPOSITE, "of s + kappa s/tau_a", 1e-6, "1e-6", 0.1,
     of_cycle(RWEDGE_MEASURE_MODIFIED_WOHLER, {kappa, lambda, rho_lim}, APART),
     judge_modified_wohler},
    {"mcdiarmid", OPPOSITE, "of s (1/t_A + 1/su)", 1e-6, "1e-6", 0.1,
     of_cycle(RWEDGE_MEASURE_MCDIARMID, {t_A, su}, APART), judge_mcdiarmid},
    {"crossland", "two opposite loads", "of (1+alpha) s", 1e-14, "1e-14", 1,
     of_cycle(RWEDGE_MEASURE_CROSSLAND, {alpha}, ANY), judge_sphere<false>},
    {"dang_van", "two opposite loads", "of (1+alpha) s", 1e-14, "1e-14", 1,
     of_cycle(RWEDGE_MEASURE_DANG_VAN, {alpha}, ANY), judge_sphere<true>},
    {},
};
