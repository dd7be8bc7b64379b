/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The paper's series: each function, judged by the coefficients that the series holds. The header
 * promises no figures. The errors are relative to the sum of the terms' moduli; the rows bound
 * them. */
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "references/balls.h"
#include "rows/rows.h"
#include "rwedge.h"

static void destroy(void *series)
{
    rwedge_series_destroy(series);
}

/* Number i of n samples, about Chebyshev's points, |x| < 1. */
static double some_sample(probe *call, int i, int n)
{
    const double x = cos(3.14159265358979 * (i + uniform(call)) / n), last = 1 - DBL_EPSILON / 2;
    return fmax(-last, fmin(last, x));
}

/* Analytic coefficients, or a fit to samples of a bell with an odd part. NULL, and NaN for a
 * result, where it is refused. */
static rwedge_series *some_series(probe *call)
{
    enum { SAMPLES = 40 };
    const double terms = argument(call, "terms", floor(log_between(call, 1, 40)));
    rwedge_series *series = NULL;
    if (chance(call, 0.5)) {
        rwedge_series_create(argument(call, "alpha", some_alpha(call)), (int32_t)terms, &series);
    } else {
        double x[SAMPLES], p[SAMPLES];
        for (int i = 0; i < SAMPLES; i++) {
            x[i] = some_sample(call, i, SAMPLES);
            p[i] = -sqrt((1 - x[i]) * (1 + x[i])) * uniform(call);
        }
        rwedge_series_fit(SAMPLES, x, p, (int32_t)fmin(terms, 20), &series);
    }
    call->object = series;
    call->release = destroy;
    if (!series)
        call->result[0] = NAN;
    return series;
}

/* sum a_k R^(k+1), R = z - sqrt(z^2-1), its derivative, and the sum of the moduli of all terms. */
static void ball_sums(acb_t G, acb_t dG, arb_t moduli, const rwedge_series *series, const acb_t z,
                      slong prec)
{
    acb_ptr w = _acb_vec_init(4);
    acb_ptr R = w, X = w + 1, power = w + 2, term = w + 3;
    arb_t a, size;
    arb_init(a), arb_init(size);
    acb_sub_ui(term, z, 1, prec);
    ball_root(X, term, prec);
    acb_add_ui(term, z, 1, prec);
    ball_root(term, term, prec);
    acb_mul(X, X, term, prec);
    acb_add(R, z, X, prec); /* 1/R */
    acb_inv(R, R, prec);
    acb_one(power);
    acb_zero(G), acb_zero(dG), arb_zero(moduli);
    for (int32_t k = 0; k < rwedge_series_terms(series); k++) {
        arb_set_d(a, rwedge_series_coefficient(series, k));
        acb_mul(power, power, R, prec);
        acb_mul_arb(term, power, a, prec);
        acb_add(G, G, term, prec);
        acb_abs(size, term, prec);
        arb_add(moduli, moduli, size, prec);
        acb_submul_ui(dG, term, (ulong)k + 1, prec);
    }
    acb_div(dG, dG, X, prec);
    arb_clear(a), arb_clear(size);
    _acb_vec_clear(w, 4);
}

static bool draw_pressure(probe *call)
{
    const rwedge_series *series = some_series(call);
    if (!series)
        return true;
    const double x = argument(call, "x", some_place(call, 0.5, 1));
    call->result[0] = rwedge_series_pressure(series, x);
    return fabs(x) < 1;
}

static void judge_pressure(arb_t error, const probe *call, slong prec)
{
    acb_ptr w = _acb_vec_init(3);
    arb_t moduli;
    arb_init(moduli);
    acb_set_d(w, call->value[call->arguments - 1]);
    ball_sums(w + 1, w + 2, moduli, call->object, w, prec);
    error_over(error, call->result[0], acb_imagref(w + 1), moduli, prec);
    arb_clear(moduli);
    _acb_vec_clear(w, 3);
}

static bool draw_potential(probe *call)
{
    const rwedge_series *series = some_series(call);
    double x, y;
    if (!series)
        return true;
    const double f = argument(call, "f", uniform(call));
    some_point(call, 0.5, 1, &x, &y);
    if (rwedge_series_potential(series, f, x, y, &call->result[0], &call->result[1]) != RWEDGE_OK)
        call->result[0] = NAN;
    return fabs(x) < 1e8 && y < 1e8;
}

/* Phi = -((i+f)/2) G. */
static void judge_potential(arb_t error, const probe *call, slong prec)
{
    const double *last = call->value + call->arguments;
    acb_ptr w = _acb_vec_init(5);
    acb_ptr z = w, G = w + 1, dG = w + 2, factor = w + 3;
    arb_t moduli, other;
    arb_init(moduli), arb_init(other);
    acb_set_d_d(z, last[-2], last[-1]);
    ball_sums(G, dG, moduli, call->object, z, prec);
    acb_set_d_d(factor, -last[-3] / 2, -0.5);
    acb_mul(G, G, factor, prec);
    error_over(error, call->result[0], acb_realref(G), moduli, prec);
    error_over(other, call->result[1], acb_imagref(G), moduli, prec);
    arb_max(error, error, other, prec);
    arb_clear(moduli), arb_clear(other);
    _acb_vec_clear(w, 5);
}

static bool draw_stress(probe *call)
{
    const rwedge_series *series = some_series(call);
    double x, y, *r = call->result;
    if (!series)
        return true;
    const double f = argument(call, "f", uniform(call));
    some_point(call, 0.5, 1, &x, &y);
    if (rwedge_series_stress(series, f, x, y, &r[0], &r[1], &r[2]) != RWEDGE_OK)
        r[0] = NAN;
    return fabs(x) < 1e8 && y < 1e8 && (y > 0 || fabs(x) != 1);
}

/* s = Im G - f Re G, D = (-1 + i f) y G' + f G; beside the moduli of the terms and, with the
 * weights of G', of theirs. */
static void judge_stress(arb_t error, const probe *call, slong prec)
{
    const double *last = call->value + call->arguments;
    acb_ptr w = _acb_vec_init(5);
    acb_ptr z = w, G = w + 1, dG = w + 2, D = w + 3, mu = w + 4;
    arb_ptr v = _arb_vec_init(5);
    arb_ptr moduli = v, f = v + 1, s = v + 2, component = v + 3, one = v + 4;
    acb_set_d_d(z, last[-2], last[-1]);
    arb_set_d(f, last[-3]);
    ball_sums(G, dG, moduli, call->object, z, prec);
    acb_set_d_d(mu, -1, last[-3]);
    acb_mul_arb(D, dG, acb_imagref(z), prec);
    acb_mul(D, D, mu, prec);
    acb_addmul_arb(D, G, f, prec);
    arb_set(s, acb_imagref(G));
    arb_submul(s, f, acb_realref(G), prec);
    arb_mul_si(moduli, moduli, rwedge_series_terms(call->object), prec);
    arb_zero(error);
    for (int i = 0; i < 3; i++) {
        if (i == 0)
            arb_sub(component, s, acb_realref(D), prec);
        else if (i == 1)
            arb_add(component, s, acb_realref(D), prec);
        else
            arb_set(component, acb_imagref(D));
        error_over(one, call->result[i], component, moduli, prec);
        arb_max(error, error, one, prec);
    }
    _acb_vec_clear(w, 5);
    _arb_vec_clear(v, 5);
}

/* ---- Coefficients and residuals ---- */

static bool draw_coefficient(probe *call)
{
    rwedge_series *series = NULL;
    const double alpha = argument(call, "alpha", some_alpha(call)),
                 k = argument(call, "k", floor(log_between(call, 1, 500)) - 1);
    rwedge_series_create(alpha, (int32_t)k + 1, &series);
    call->result[0] = rwedge_series_coefficient(series, (int32_t)k);
    call->result[1] = (int32_t)k % 2 == 0 ? rwedge_coefficient(alpha, (int32_t)k / 2) : 0;
    rwedge_series_destroy(series);
    return true;
}

/* Those of rwedge_coefficient(), which has a row of its own, bit by bit. */
static void judge_coefficient(arb_t error, const probe *call, slong prec)
{
    arb_t expected;
    arb_init(expected);
    arb_set_d(expected, call->result[1]);
    relative_error(error, call->result[0], expected, prec);
    arb_clear(expected);
}

/* Of a fit: the root mean square of fit minus sample. Coefficients and samples are what is
 * judged. */
enum { FIT_SAMPLES = 24 };
typedef struct {
    rwedge_series *series;
    double x[FIT_SAMPLES], p[FIT_SAMPLES];
} fit;

static void destroy_fit(void *object)
{
    fit *f = object;
    rwedge_series_destroy(f->series);
    free(f);
}

static bool draw_fit(probe *call)
{
    fit *f = calloc(1, sizeof *f);
    if (!f)
        return false;
    call->object = f;
    call->release = destroy_fit;
    const double terms = argument(call, "terms", floor(between(call, 1, 13)));
    const double scatter = argument(call, "scatter", log_between(call, 1e-6, 1));
    for (int i = 0; i < FIT_SAMPLES; i++) {
        f->x[i] = some_sample(call, i, FIT_SAMPLES);
        f->p[i] = -sqrt((1 - f->x[i]) * (1 + f->x[i])) * (1 + scatter * uniform(call));
    }
    rwedge_series_fit(FIT_SAMPLES, f->x, f->p, (int32_t)terms, &f->series);
    call->result[0] = rwedge_series_residual(f->series);
    return true;
}

/* Over the root mean square of the samples. */
static void judge_residual(arb_t error, const probe *call, slong prec)
{
    const fit *f = call->object;
    acb_ptr w = _acb_vec_init(3);
    arb_ptr v = _arb_vec_init(4);
    arb_ptr moduli = v, misfit = v + 1, sum = v + 2, size = v + 3;
    for (int i = 0; i < FIT_SAMPLES; i++) {
        acb_set_d(w, f->x[i]);
        ball_sums(w + 1, w + 2, moduli, f->series, w, prec);
        arb_set_d(misfit, f->p[i]);
        arb_addmul(size, misfit, misfit, prec);
        arb_sub(misfit, misfit, acb_imagref(w + 1), prec);
        arb_addmul(sum, misfit, misfit, prec);
    }
    arb_div_ui(sum, sum, FIT_SAMPLES, prec);
    arb_div_ui(size, size, FIT_SAMPLES, prec);
    arb_sqrt(sum, sum, prec);
    arb_sqrt(size, size, prec);
    error_over(error, call->result[0], sum, size, prec);
    _acb_vec_clear(w, 3);
    _arb_vec_clear(v, 4);
}

/* The exact least-squares coefficients come from the normal equations in many bits. Errors are
 * relative to the largest of them, and divided by the condition of the columns. */
static void judge_fit(arb_t error, const probe *call, slong prec)
{
    const fit *f = call->object;
    const slong n = rwedge_series_terms(f->series);
    arb_mat_t normal, right, solution;
    arb_mat_init(normal, n, n), arb_mat_init(right, n, 1), arb_mat_init(solution, n, 1);
    arb_ptr column = _arb_vec_init(n + 3);
    arb_ptr t = column + n, p = column + n + 1, largest = column + n + 2;
    for (int i = 0; i < FIT_SAMPLES; i++) {
        arb_set_d(t, f->x[i]);
        arb_acos(t, t, prec);
        arb_set_d(p, f->p[i]);
        for (slong k = 0; k < n; k++) {
            arb_mul_si(column + k, t, k + 1, prec);
            arb_sin(column + k, column + k, prec);
            arb_neg(column + k, column + k);
        }
        for (slong k = 0; k < n; k++) {
            arb_addmul(arb_mat_entry(right, k, 0), column + k, p, prec);
            for (slong l = 0; l < n; l++)
                arb_addmul(arb_mat_entry(normal, k, l), column + k, column + l, prec);
        }
    }
    if (arb_mat_solve(solution, normal, right, prec)) {
        for (slong k = 0; k < n; k++) {
            arb_abs(t, arb_mat_entry(solution, k, 0));
            arb_max(largest, largest, t, prec);
        }
        arb_zero(error);
        for (slong k = 0; k < n; k++) {
            error_over(t, rwedge_series_coefficient(f->series, (int32_t)k),
                       arb_mat_entry(solution, k, 0), largest, prec);
            arb_max(error, error, t, prec);
        }
    } else {
        arb_indeterminate(error);
    }
    arb_mat_clear(normal), arb_mat_clear(right), arb_mat_clear(solution);
    _arb_vec_clear(column, n + 3);
}

/* Of the analytic series: an upper bound of the tail. The error is what it lacks of the first
 * 200 terms that are cut off, relatively; 0 where it is enough. */
static bool draw_bound(probe *call)
{
    rwedge_series *series = NULL;
    const double alpha = argument(call, "alpha", some_rounded_alpha(call));
    const double terms = argument(call, "terms", floor(log_between(call, 1, 1000)));
    rwedge_series_create(alpha, (int32_t)terms, &series);
    call->result[0] = rwedge_series_residual(series);
    rwedge_series_destroy(series);
    return true;
}

static void judge_bound(arb_t error, const probe *call, slong prec)
{
    arb_t tail, term;
    arb_init(tail), arb_init(term);
    for (int32_t i = 0; i < 200; i++) {
        arb_set_d(term,
                  fabs(rwedge_coefficient(call->value[0], ((int32_t)call->value[1] + 1) / 2 + i)));
        arb_add(tail, tail, term, prec);
    }
    arb_set_d(term, call->result[0]);
    if (arb_le(tail, term))
        arb_zero(error);
    else
        relative_error(error, call->result[0], tail, prec);
    arb_clear(tail), arb_clear(term);
}

#define MODULI "of the sum of the terms' moduli"

const row SERIES_ROWS[] = {
    {"series_coefficient", "k 0 to 499", "from `coefficient`", 1e-300, "the same", 0.3,
     draw_coefficient, judge_coefficient},
    {"series_residual, create", "terms 1 to 1000", "short of the tail's first 200 terms, relative",
     1e-14, "a bound", 0.1, draw_bound, judge_bound},
    {"series_residual, fit", "24 samples, 1 to 12 terms", "of the samples' root mean square", 1e-15,
     "(1e-15)", 0.3, draw_fit, judge_residual},
    {"series_fit", "the same", "of the largest coefficient", 1e-13, "(1e-13)", 0.1, draw_fit,
     judge_fit},
    {"series_pressure", "1 to 40 terms", MODULI, 1e-14, "(1e-14)", 1, draw_pressure,
     judge_pressure},
    {"series_potential", "1 to 40 terms", MODULI, 1e-14, "(1e-14)", 1, draw_potential,
     judge_potential},
    {"series_stress", "1 to 40 terms",
     "of terms times "
     "that sum",
     1e-14, "(1e-14)", 1, draw_stress, judge_stress},
    {0},
};
