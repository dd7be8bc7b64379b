/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The paper's series: each function, judged by the coefficients that the series holds. The header
 * promises no figures. The errors are relative to the sum of the terms' moduli; the rows bound
 * them. */
#include <float.h>
#include <math.h>
#include <vector>

#include "references/ball_matrix.hpp"
#include "rows/rows.hpp"
#include "rwedge.h"

namespace
{

void destroy(void *series)
{
    rwedge_series_destroy(static_cast<rwedge_series *>(series));
}

/* Number i of n samples, about Chebyshev's points, |x| < 1. */
double some_sample(probe *call, int i, int n)
{
    const double x = cos(3.14159265358979 * (i + uniform(call)) / n), last = 1 - DBL_EPSILON / 2;
    return fmax(-last, fmin(last, x));
}

/* Analytic coefficients, or a fit to samples of a bell with an odd part. NULL, and NaN for a
 * result, where it is refused. */
const rwedge_series *some_series(probe *call)
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
struct sums {
    complex_ball G, slope;
    ball moduli;
};

sums sums_of(const rwedge_series *series, const complex_ball &z)
{
    const complex_ball X = root(z - 1) * root(z + 1), R = inv(z + X);
    complex_ball power = 1;
    sums s;
    for (int32_t k = 0; k < rwedge_series_terms(series); k++) {
        power *= R;
        const complex_ball term = rwedge_series_coefficient(series, k) * power;
        s.G += term;
        s.slope -= (k + 1.0) * term;
        s.moduli += abs(term);
    }
    s.slope /= X;
    return s;
}

const rwedge_series *series_of(const probe &call)
{
    return static_cast<const rwedge_series *>(call.object);
}

bool draw_pressure(probe *call)
{
    const rwedge_series *series = some_series(call);
    if (!series)
        return true;
    const double x = argument(call, "x", some_place(call, 0.5, 1));
    call->result[0] = rwedge_series_pressure(series, x);
    return fabs(x) < 1;
}

ball judge_pressure(const probe &call)
{
    const sums s = sums_of(series_of(call), call.value[call.arguments - 1]);
    return error_over(call.result[0], im(s.G), s.moduli);
}

bool draw_potential(probe *call)
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
ball judge_potential(const probe &call)
{
    const double *last = call.value + call.arguments;
    const sums s = sums_of(series_of(call), {last[-2], last[-1]});
    const complex_ball phi = s.G * complex_ball(-last[-3] / 2, -0.5);
    return max(error_over(call.result[0], re(phi), s.moduli),
               error_over(call.result[1], im(phi), s.moduli));
}

bool draw_stress(probe *call)
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
ball judge_stress(const probe &call)
{
    const double *last = call.value + call.arguments;
    const ball f = last[-3], y = last[-1];
    const sums at = sums_of(series_of(call), {last[-2], y});
    const ball s = im(at.G) - f * re(at.G),
               moduli = at.moduli * rwedge_series_terms(series_of(call));
    const complex_ball D = complex_ball(-1, f) * (y * at.slope) + f * at.G;
    const ball xx = error_over(call.result[0], s - re(D), moduli),
               yy = error_over(call.result[1], s + re(D), moduli),
               xy = error_over(call.result[2], im(D), moduli);
    return max(max(xx, yy), xy);
}

/* ---- Coefficients and residuals ---- */

bool draw_coefficient(probe *call)
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
ball judge_coefficient(const probe &call)
{
    return relative_error(call.result[0], call.result[1]);
}

/* Of a fit: the root mean square of fit minus sample. Coefficients and samples are what is
 * judged. */
enum { FIT_SAMPLES = 24 };
typedef struct {
    rwedge_series *series;
    double x[FIT_SAMPLES], p[FIT_SAMPLES];
} fit;

void destroy_fit(void *object)
{
    fit *f = static_cast<fit *>(object);
    rwedge_series_destroy(f->series);
    delete f;
}

bool draw_fit(probe *call)
{
    fit *f = new fit();
    call->object = f;
    call->release = destroy_fit;
    const double terms = argument(call, "terms", floor(between(call, 1, 13)));
    const double scatter = argument(call, "scatter", log_between(call, 1e-6, 1));
    for (int i = 0; i < FIT_SAMPLES; i++) {
        f->x[i] = some_sample(call, i, FIT_SAMPLES);
        f->p[i] = -sqrt((1 - f->x[i]) * (1 + f->x[i])) * (1 + scatter * uniform(call));
    }
    rwedge_series_fit(FIT_SAMPLES, f->x, f->p, (int32_t)terms, &f->series);
    return gives(call, rwedge_series_residual(f->series));
}

/* Over the root mean square of the samples. */
ball judge_residual(const probe &call)
{
    const fit &f = *static_cast<const fit *>(call.object);
    ball sum, size;
    for (int i = 0; i < FIT_SAMPLES; i++) {
        size += sqr(f.p[i]);
        sum += sqr(f.p[i] - im(sums_of(f.series, f.x[i]).G));
    }
    return error_over(call.result[0], sqrt(sum / FIT_SAMPLES), sqrt(size / FIT_SAMPLES));
}

/* The exact least-squares coefficients come from the normal equations in many bits. Errors are
 * relative to the largest of them, and divided by the condition of the columns. */
ball judge_fit(const probe &call)
{
    const fit &f = *static_cast<const fit *>(call.object);
    const int n = rwedge_series_terms(f.series);
    ball_matrix normal(n, n), right(n, 1), solution(n, 1);
    for (int i = 0; i < FIT_SAMPLES; i++) {
        std::vector<ball> column;
        for (int k = 1; k <= n; k++)
            column.push_back(-sin(k * acos(ball(f.x[i]))));
        for (int k = 0; k < n; k++) {
            right.add(k, 0, column[(size_t)k] * f.p[i]);
            for (int l = 0; l < n; l++)
                normal.add(k, l, column[(size_t)k] * column[(size_t)l]);
        }
    }
    if (!solve(solution, normal, right))
        return unknown();
    ball largest, error;
    for (int k = 0; k < n; k++)
        largest = max(largest, abs(solution(k, 0)));
    for (int k = 0; k < n; k++)
        error =
            max(error, error_over(rwedge_series_coefficient(f.series, k), solution(k, 0), largest));
    return error;
}

/* Of the analytic series: an upper bound of the tail. The error is what it lacks of the first
 * 200 terms that are cut off, relatively; 0 where it is enough. */
bool draw_bound(probe *call)
{
    rwedge_series *series = NULL;
    const double alpha = argument(call, "alpha", some_rounded_alpha(call));
    const double terms = argument(call, "terms", floor(log_between(call, 1, 1000)));
    rwedge_series_create(alpha, (int32_t)terms, &series);
    call->result[0] = rwedge_series_residual(series);
    rwedge_series_destroy(series);
    return true;
}

ball judge_bound(const probe &call)
{
    ball tail;
    for (int32_t i = 0; i < 200; i++)
        tail += fabs(rwedge_coefficient(call.value[0], ((int32_t)call.value[1] + 1) / 2 + i));
    return tail <= call.result[0] ? 0 : relative_error(call.result[0], tail);
}

#define MODULI "of the sum of the terms' moduli"

} // namespace

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
    {},
};
