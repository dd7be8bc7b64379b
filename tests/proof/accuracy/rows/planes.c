/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Criteria over all planes, of cycles between two opposite loads, where they have closed forms in
 * the principal stresses s1, s2 and szz. */
#include <float.h>
#include <math.h>

#include "rows/rows.h"
#include "rwedge.h"

enum { FIELD = 2, LOADS = 2 };

/* ---- Opposite loads ---- */

typedef struct {
    double sxx[LOADS], syy[LOADS], txy[LOADS];
} cycle;

/* Whether the principal stresses are apart: where they are nearly equal a curve of planes is nearly
 * as bad, and the header promises less. */
static bool are_apart(const double s[3], double nu)
{
    const double mean = (s[0] + s[1]) / 2, R = hypot((s[0] - s[1]) / 2, s[2]), z = 2 * nu * mean;
    const double least = 1e-3 * (fabs(mean) + R);
    return R > least && fabs(mean + R - z) > least && fabs(mean - R - z) > least;
}

/* Stresses of one load, and nu; the other load is the opposite one. */
static bool draw_cycle(probe *call, cycle *c, double *nu)
{
    static const char *const NAMES[] = {"sxx", "syy", "txy"};
    const double size = log_between(call, 1e-50, 1e50);
    double s[3];
    for (int i = 0; i < 3; i++)
        s[i] = argument(call, NAMES[i], size * between(call, -1, 1));
    *nu = argument(call, "nu", some_poisson(call));
    *c = (cycle){{s[0], -s[0]}, {s[1], -s[1]}, {s[2], -s[2]}};
    return are_apart(s, *nu);
}

/* The largest principal stress of the load that was drawn, the one between, the smallest. */
static void principal(arb_ptr s, const probe *call, slong prec)
{
    arb_ptr t = _arb_vec_init(4);
    arb_set_d(t, call->value[0]);
    arb_set_d(t + 1, call->value[1]);
    arb_set_d(t + 3, call->value[2]);
    arb_sub(t + 2, t + 1, t, prec);
    arb_add(t, t, t + 1, prec); /* 2 s */
    arb_mul_2exp_si(t + 3, t + 3, 1);
    arb_hypot(t + 2, t + 2, t + 3, prec); /* 2 R */
    arb_set_d(t + 1, call->value[3]);
    arb_mul(t + 1, t + 1, t, prec); /* szz */
    arb_add(s, t, t + 2, prec);
    arb_sub(s + 2, t, t + 2, prec);
    arb_mul_2exp_si(s, s, -1);
    arb_mul_2exp_si(s + 2, s + 2, -1);
    arb_add(s + 1, s, s + 2, prec);
    arb_add(s + 1, s + 1, t + 1, prec); /* the sum of all three */
    arb_max(s, s, t + 1, prec);
    arb_min(s + 2, s + 2, t + 1, prec);
    arb_sub(s + 1, s + 1, s, prec);
    arb_sub(s + 1, s + 1, s + 2, prec);
    _arb_vec_clear(t, 4);
}

/* |s1+s3|/2 and (s1-s3)/2, of the outermost; and the largest magnitude. */
static void outermost(arb_ptr half, const probe *call, slong prec)
{
    arb_ptr s = _arb_vec_init(3);
    principal(s, call, prec);
    arb_add(half, s, s + 2, prec);
    arb_abs(half, half);
    arb_sub(half + 1, s, s + 2, prec);
    arb_mul_2exp_si(half, half, -1);
    arb_mul_2exp_si(half + 1, half + 1, -1);
    arb_add(half + 2, half, half + 1, prec);
    _arb_vec_clear(s, 3);
}

static void give(probe *call, int32_t status, double value)
{
    call->result[0] = status == RWEDGE_OK ? value : NAN;
}

/* ---- Findley, Fatemi and Socie ---- */

static bool draw_findley(probe *call)
{
    cycle c;
    double nu, value, angle, out;
    if (!draw_cycle(call, &c, &nu))
        return false;
    const double k = argument(call, "k", chance(call, 0.1) ? 0 : between(call, 0, 1));
    const int32_t status = rwedge_findley(LOADS, c.sxx, c.syy, c.txy, nu, k, &value, &angle, &out);
    give(call, status, value);
    return true;
}

/* k |s1+s3|/2 + sqrt(1+k^2) (s1-s3)/2 */
static void judge_findley(arb_t error, const probe *call, slong prec)
{
    arb_ptr half = _arb_vec_init(5);
    outermost(half, call, prec);
    arb_set_d(half + 3, call->value[4]);
    arb_mul(half + 4, half + 3, half + 3, prec);
    arb_add_ui(half + 4, half + 4, 1, prec);
    arb_sqrt(half + 4, half + 4, prec);
    arb_mul(half + 1, half + 1, half + 4, prec);
    arb_addmul(half + 1, half, half + 3, prec);
    arb_add_ui(half + 3, half + 3, 1, prec);
    arb_mul(half + 2, half + 2, half + 3, prec);
    error_over(error, call->result[0], half + 1, half + 2, prec);
    _arb_vec_clear(half, 5);
}

static bool draw_fatemi_socie(probe *call)
{
    cycle c;
    double nu, value, angle, out;
    if (!draw_cycle(call, &c, &nu))
        return false;
    const double E = argument(call, "E", log_between(call, 1e-3, 1e6));
    const int32_t status =
        rwedge_fatemi_socie_planes(LOADS, c.sxx, c.syy, c.txy, E, nu, 0, 0, &value, &angle, &out);
    give(call, status, value);
    return true;
}

/* (1+nu)/E times a number, in place. */
static void per_modulus(arb_t number, const probe *call, slong prec)
{
    arb_t factor;
    arb_init(factor);
    arb_set_d(factor, call->value[3]);
    arb_add_ui(factor, factor, 1, prec);
    arb_mul(number, number, factor, prec);
    arb_set_d(factor, call->value[4]);
    arb_div(number, number, factor, prec);
    arb_clear(factor);
}

/* (1+nu)/E (s1-s3) */
static void judge_fatemi_socie(arb_t error, const probe *call, slong prec)
{
    arb_ptr half = _arb_vec_init(3);
    outermost(half, call, prec);
    arb_mul_2exp_si(half + 1, half + 1, 1);
    per_modulus(half + 1, call, prec);
    per_modulus(half + 2, call, prec);
    error_over(error, call->result[0], half + 1, half + 2, prec);
    _arb_vec_clear(half, 3);
}

/* ---- Smith, Watson and Topper ---- */

static bool draw_smith_watson_topper(probe *call)
{
    cycle c;
    double nu, value, angle, out;
    if (!draw_cycle(call, &c, &nu))
        return false;
    const double E = argument(call, "E", log_between(call, 1e-3, 1e6));
    const int32_t status = rwedge_smith_watson_topper_planes(LOADS, c.sxx, c.syy, c.txy, E, nu, 0,
                                                             &value, &angle, &out);
    give(call, status, value);
    return true;
}

/* The largest |A B| on the line from (a, b) to (c, d): at its ends, or where (A B)' is 0. */
static void largest_on_edge(arb_t most, arb_srcptr a, arb_srcptr b, slong prec)
{
    arb_ptr t = _arb_vec_init(5);
    arb_sub(t, a + 1, a, prec);
    arb_sub(t + 1, b + 1, b, prec);
    arb_mul(t + 2, a, t + 1, prec);
    arb_addmul(t + 2, b, t, prec);
    arb_mul(t + 3, t, t + 1, prec);
    arb_mul_si(t + 3, t + 3, -2, prec);
    arb_div(t + 2, t + 2, t + 3, prec); /* the place, 0 to 1 */
    arb_sub_ui(t + 4, t + 2, 1, prec);
    if (arb_is_positive(t + 2) && arb_is_negative(t + 4)) {
        arb_mul(t, t, t + 2, prec);
        arb_add(t, t, a, prec);
        arb_mul(t + 1, t + 1, t + 2, prec);
        arb_add(t + 1, t + 1, b, prec);
        arb_mul(t, t, t + 1, prec);
        arb_abs(t, t);
        arb_max(most, most, t, prec);
    }
    for (int i = 0; i < 2; i++) {
        arb_mul(t, a + i, b + i, prec);
        arb_abs(t, t);
        arb_max(most, most, t, prec);
    }
    _arb_vec_clear(t, 5);
}

/* A plane's normal stress and strain are means of the principal ones, with the squares of the
 * normal's cosines as weights: two linear functions on a triangle, whose product is largest on an
 * edge. */
static void judge_smith_watson_topper(arb_t error, const probe *call, slong prec)
{
    arb_ptr s = _arb_vec_init(3), e = _arb_vec_init(3), t = _arb_vec_init(6);
    principal(s, call, prec);
    outermost(t, call, prec);
    arb_set_d(t + 3, call->value[0]);
    arb_set_d(t + 4, call->value[1]);
    arb_add(t + 3, t + 3, t + 4, prec);
    arb_set_d(t + 4, call->value[3]);
    arb_mul(t + 3, t + 3, t + 4, prec); /* szz */
    for (int i = 0; i < 3; i++)
        arb_sub(e + i, s + i, t + 3, prec);
    arb_zero(t + 5);
    for (int i = 0; i < 3; i++) {
        arb_ptr a = _arb_vec_init(2), b = _arb_vec_init(2);
        arb_set(a, s + i), arb_set(a + 1, s + (i + 1) % 3);
        arb_set(b, e + i), arb_set(b + 1, e + (i + 1) % 3);
        largest_on_edge(t + 5, a, b, prec);
        _arb_vec_clear(a, 2), _arb_vec_clear(b, 2);
    }
    per_modulus(t + 5, call, prec);
    arb_mul(t + 2, t + 2, t + 2, prec);
    per_modulus(t + 2, call, prec);
    error_over(error, call->result[0], t + 5, t + 2, prec);
    _arb_vec_clear(s, 3), _arb_vec_clear(e, 3), _arb_vec_clear(t, 6);
}

/* ---- Susmel, McDiarmid ---- */

static bool draw_modified_wohler(probe *call)
{
    cycle c;
    double nu, value, angle, out;
    if (!draw_cycle(call, &c, &nu))
        return false;
    const double kappa = argument(call, "kappa", fabs(c.sxx[0]) * between(call, 0, 1));
    const int32_t status =
        rwedge_modified_wohler(LOADS, c.sxx, c.syy, c.txy, nu, kappa, &value, &angle, &out);
    give(call, status, value);
    return true;
}

/* (s1-s3)/2 + kappa |s1+s3|/(s1-s3), over the first and kappa */
static void judge_modified_wohler(arb_t error, const probe *call, slong prec)
{
    arb_ptr half = _arb_vec_init(5);
    outermost(half, call, prec);
    arb_set_d(half + 3, call->value[4]);
    arb_div(half + 4, half + 2, half + 1, prec);
    arb_mul(half + 4, half + 4, half + 3, prec);
    arb_add(half + 2, half + 2, half + 4, prec); /* s + kappa s/tau_a */
    arb_div(half, half, half + 1, prec);
    arb_addmul(half + 1, half, half + 3, prec);
    error_over(error, call->result[0], half + 1, half + 2, prec);
    _arb_vec_clear(half, 5);
}

static bool draw_mcdiarmid(probe *call)
{
    cycle c;
    double nu, value, angle, out;
    if (!draw_cycle(call, &c, &nu))
        return false;
    const double t_A = argument(call, "t_A", 1e-50 + fabs(c.sxx[0]) * between(call, 0.1, 10)),
                 su = argument(call, "su", t_A * between(call, 1, 10));
    const int32_t status =
        rwedge_mcdiarmid(LOADS, c.sxx, c.syy, c.txy, nu, t_A, su, &value, &angle, &out);
    give(call, status, value);
    return true;
}

static void judge_mcdiarmid(arb_t error, const probe *call, slong prec)
{
    arb_ptr half = _arb_vec_init(6);
    outermost(half, call, prec);
    arb_set_d(half + 3, call->value[4]);
    arb_set_d(half + 4, call->value[5]);
    arb_div(half + 1, half + 1, half + 3, prec);
    arb_div(half, half, half + 4, prec);
    arb_mul_2exp_si(half, half, -1);
    arb_add(half + 1, half + 1, half, prec);
    arb_inv(half + 3, half + 3, prec);
    arb_inv(half + 4, half + 4, prec);
    arb_add(half + 3, half + 3, half + 4, prec);
    arb_mul(half + 2, half + 2, half + 3, prec);
    error_over(error, call->result[0], half + 1, half + 2, prec);
    _arb_vec_clear(half, 6);
}

/* ---- Crossland, Dang Van ---- */

static bool draw_sphere(probe *call, bool is_dang_van)
{
    cycle c;
    double nu, value;
    draw_cycle(call, &c, &nu);
    const double alpha = argument(call, "alpha", chance(call, 0.1) ? 0 : between(call, 0, 1));
    const int32_t status = (is_dang_van ? rwedge_dang_van : rwedge_crossland)(
        LOADS, c.sxx, c.syy, c.txy, nu, alpha, &value);
    give(call, status, value);
    return true;
}

static bool draw_crossland(probe *call)
{
    return draw_sphere(call, false);
}

static bool draw_dang_van(probe *call)
{
    return draw_sphere(call, true);
}

/* The sphere's centre is 0. Its radius is sqrt(J2) of either load. */
static void judge_sphere(arb_t error, const probe *call, bool is_dang_van, slong prec)
{
    arb_ptr s = _arb_vec_init(3), t = _arb_vec_init(4);
    principal(s, call, prec);
    outermost(t, call, prec);
    arb_add(t, s, s + 1, prec);
    arb_add(t, t, s + 2, prec);
    arb_abs(t, t);
    arb_div_ui(t, t, 3, prec); /* the larger hydrostatic stress */
    if (!is_dang_van) {
        arb_zero(t + 1);
        for (int i = 0; i < 3; i++) {
            arb_sub(t + 3, s + i, s + (i + 1) % 3, prec);
            arb_addmul(t + 1, t + 3, t + 3, prec);
        }
        arb_div_ui(t + 1, t + 1, 6, prec);
        arb_sqrt(t + 1, t + 1, prec);
    }
    arb_set_d(t + 3, call->value[4]);
    arb_addmul(t + 1, t, t + 3, prec);
    arb_add_ui(t + 3, t + 3, 1, prec);
    arb_mul(t + 2, t + 2, t + 3, prec);
    error_over(error, call->result[0], t + 1, t + 2, prec);
    _arb_vec_clear(s, 3), _arb_vec_clear(t, 4);
}

static void judge_crossland(arb_t error, const probe *call, slong prec)
{
    judge_sphere(error, call, false, prec);
}

static void judge_dang_van(arb_t error, const probe *call, slong prec)
{
    judge_sphere(error, call, true, prec);
}

/* ---- Fields ---- */

/* The difference of a field's second point from the value of that point alone. */
static bool draw_field(probe *call, int criterion)
{
    cycle c;
    double nu, own, v[FIELD], a[FIELD], o[FIELD], at[3][LOADS * FIELD];
    draw_cycle(call, &c, &nu);
    for (int i = 0; i < LOADS; i++)
        for (int j = 0; j < FIELD; j++) {
            at[0][i * FIELD + j] = c.sxx[i] * (j == 0 ? 0.5 : 1);
            at[1][i * FIELD + j] = c.syy[i];
            at[2][i * FIELD + j] = c.txy[i];
        }
    const double *x = at[0], *y = at[1], *t = at[2];
    int32_t status = RWEDGE_OK, alone = RWEDGE_OK;
#define BOTH(name, ...)                                                                            \
    status = rwedge_##name##_field(LOADS, FIELD, x, y, t, __VA_ARGS__, v, a, o);                   \
    alone = rwedge_##name(LOADS, c.sxx, c.syy, c.txy, __VA_ARGS__, &own, a, o)
    if (criterion == 0) {
        BOTH(smith_watson_topper_planes, 1, nu, 1);
    } else if (criterion == 1) {
        BOTH(fatemi_socie_planes, 1, nu, 1, 0);
    } else if (criterion == 2) {
        BOTH(findley, nu, 0.3);
    } else if (criterion == 3) {
        BOTH(modified_wohler, nu, 1);
    } else {
        BOTH(mcdiarmid, nu, 1, 2);
    }
#undef BOTH
    give(call, status | alone, v[1] - own);
    return true;
}

static bool draw_sphere_field(probe *call, bool is_dang_van)
{
    cycle c;
    double nu, own = NAN, v[FIELD];
    draw_cycle(call, &c, &nu);
    double at[3][LOADS * FIELD];
    for (int i = 0; i < LOADS * FIELD; i++)
        at[0][i] = c.sxx[i / FIELD], at[1][i] = c.syy[i / FIELD], at[2][i] = c.txy[i / FIELD];
    const int32_t status = (is_dang_van ? rwedge_dang_van_field : rwedge_crossland_field)(
        LOADS, FIELD, at[0], at[1], at[2], nu, 0.3, v);
    const int32_t alone = (is_dang_van ? rwedge_dang_van : rwedge_crossland)(LOADS, c.sxx, c.syy,
                                                                             c.txy, nu, 0.3, &own);
    give(call, status | alone, v[1] - own);
    return true;
}

#define FIELD_OF(name, criterion)                                                                  \
    static bool draw_##name##_field(probe *call)                                                   \
    {                                                                                              \
        return draw_field(call, criterion);                                                        \
    }
FIELD_OF(smith_watson_topper, 0)
FIELD_OF(fatemi_socie, 1)
FIELD_OF(findley, 2)
FIELD_OF(modified_wohler, 3)
FIELD_OF(mcdiarmid, 4)

static bool draw_crossland_field(probe *call)
{
    return draw_sphere_field(call, false);
}

static bool draw_dang_van_field(probe *call)
{
    return draw_sphere_field(call, true);
}

static void judge_difference(arb_t error, const probe *call, slong prec)
{
    (void)prec;
    arb_set_d(error, fabs(call->result[0]));
}

#define OPPOSITE "two opposite loads, principal stresses apart by 1e-3"
#define SAME "from one point alone"

const row PLANE_ROWS[] = {
    {"smith_watson_topper_planes", OPPOSITE, "of s^2 (1+nu)/E", 1e-14, "1e-14", 0.1,
     draw_smith_watson_topper, judge_smith_watson_topper},
    {"smith_watson_topper_planes_field", "the same, at two points", SAME, 0, "the same", 0.1,
     draw_smith_watson_topper_field, judge_difference},
    {"fatemi_socie_planes", OPPOSITE "; k/sy 0", "of s (1+nu)/E", 1e-14, "1e-14", 0.1,
     draw_fatemi_socie, judge_fatemi_socie},
    {"fatemi_socie_planes_field", "the same, at two points", SAME, 0, "the same", 0.1,
     draw_fatemi_socie_field, judge_difference},
    {"findley", OPPOSITE, "of (1+k) s", 1e-14, "1e-14", 0.1, draw_findley, judge_findley},
    {"findley_field", "the same, at two points", SAME, 0, "the same", 0.1, draw_findley_field,
     judge_difference},
    {"modified_wohler", OPPOSITE, "of s + kappa s/tau_a", 1e-6, "1e-6", 0.1, draw_modified_wohler,
     judge_modified_wohler},
    {"modified_wohler_field", "the same, at two points", SAME, 0, "the same", 0.1,
     draw_modified_wohler_field, judge_difference},
    {"mcdiarmid", OPPOSITE, "of s (1/t_A + 1/su)", 1e-6, "1e-6", 0.1, draw_mcdiarmid,
     judge_mcdiarmid},
    {"mcdiarmid_field", "the same, at two points", SAME, 0, "the same", 0.1, draw_mcdiarmid_field,
     judge_difference},
    {"crossland", "two opposite loads", "of (1+alpha) s", 1e-14, "1e-14", 1, draw_crossland,
     judge_crossland},
    {"crossland_field", "the same, at two points", SAME, 0, "the same", 1, draw_crossland_field,
     judge_difference},
    {"dang_van", "two opposite loads", "of (1+alpha) s", 1e-14, "1e-14", 1, draw_dang_van,
     judge_dang_van},
    {"dang_van_field", "the same, at two points", SAME, 0, "the same", 1, draw_dang_van_field,
     judge_difference},
    {0},
};
