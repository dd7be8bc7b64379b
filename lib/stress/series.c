/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The paper's route to the stresses. The pressure p = -sqrt(1-x^2) sum a_k U_k(x) has the
 * potential G = sum a_k R^(k+1), Eq. (29), (30). With x = cos(t), sqrt(1-x^2) U_k(x) is
 * sin((k+1) t). So the series that is fitted and summed is a sine series. */
#include "rwedge.h"

#include "base/domain.h"
#include "potential/elliptic.h"
#include "base/least_squares.h"
#include "stress/stress.h"

#include <stdlib.h>

enum { MAX_TERMS = 1 << 24, MAX_ENTRIES = 1 << 27 };

/* The largest samples * terms^2. The time of a fit grows in proportion to it, 2 to 4 ns each with
 * the reference BLAS, so that the longest fit takes half a minute. */
static const uint64_t MAX_WORK = (uint64_t)1 << 33;

struct rwedge_series {
    double residual;
    int32_t terms;
    double a[];
};

static rwedge_series *allocate(int32_t terms)
{
    rwedge_series *series = malloc(sizeof *series + (size_t)terms * sizeof series->a[0]);
    if (series)
        series->terms = terms;
    return series;
}

/* An upper bound of sum_(n >= N) |b_n|, N >= 1, m = 2n+1. It rests on two bounds of
 * |m sin(m phi0) cot(phi0) - cos(m phi0)|:
 * - m^2 + 1, used for n up to M = c0/(2 alpha), with 1/m <= ln((n+1)/n)/2;
 * - m c0/alpha + 1, used beyond, with 1/(m^2-1) = (1/n - 1/(n+1))/4, which telescopes. */
static double analytic_tail(double alpha, double N)
{
    if (alpha >= 1)
        return 0;
    if (alpha == 0)
        return HUGE_VAL;
    const double slope = rw_cos_asin(alpha) / alpha, M = fmax(N, floor(slope / 2) + 1);
    return 2 / RW_PI * (1 + 0.5 / (N * (N + 1))) * log(M / N) +
           (slope + 1 / (2 * M + 1)) / (RW_PI * M);
}

int32_t rwedge_series_create(double alpha, int32_t terms, rwedge_series **series)
{
    if (!series)
        return RWEDGE_ENULL;
    if (!rw_is_magnitude(alpha))
        return RWEDGE_EDOMAIN;
    if (terms < 1 || terms > MAX_TERMS)
        return RWEDGE_ERANGE;
    rwedge_series *made = allocate(terms);
    if (!made)
        return RWEDGE_ENOMEM;
    for (int32_t k = 0; k < terms; k++)
        made->a[k] = k % 2 == 0 ? rwedge_coefficient(alpha, k / 2) : 0;
    made->residual = analytic_tail(alpha, (terms + 1) / 2); /* the first b_n that is cut off */
    *series = made;
    return RWEDGE_OK;
}

/* -sqrt(1-x^2) U_k(x), all k, at the samples. */
static void fill_columns(int32_t samples, int32_t terms, const double x[], double *A)
{
    for (int32_t i = 0; i < samples; i++) {
        const double t = atan2(rw_cos_asin(x[i]), x[i]);
        for (int32_t k = 0; k < terms; k++)
            A[(size_t)k * (size_t)samples + (size_t)i] = -sin((k + 1) * t);
    }
}

static double root_mean_square_of_misfit(const rwedge_series *series, size_t samples,
                                         const double x[], const double p[])
{
    double sum = 0;
    for (size_t i = 0; i < samples; i++) {
        const double misfit = rwedge_series_pressure(series, x[i]) - p[i];
        sum += misfit * misfit;
    }
    return sqrt(sum / (double)samples);
}

/* Solves for made->a. `work` has room for the matrix and the right-hand side. */
static int32_t fit(size_t samples, const double x[], const double p[], double *work,
                   rwedge_series *made)
{
    const size_t entries = samples * (size_t)made->terms;
    double *v = work + entries;
    fill_columns((int32_t)samples, made->terms, x, work);
    for (size_t i = 0; i < samples; i++)
        v[i] = p[i];
    const int32_t status = rw_least_squares((int32_t)samples, made->terms, work, v);
    if (status != RWEDGE_OK)
        return status;
    for (int32_t k = 0; k < made->terms; k++)
        made->a[k] = v[k];
    made->residual = root_mean_square_of_misfit(made, samples, x, p);
    return RWEDGE_OK;
}

static bool are_samples(size_t samples, const double x[], const double p[])
{
    for (size_t i = 0; i < samples; i++)
        if (!rw_is_signed(x[i]) || !rw_is_signed(p[i]) || fabs(x[i]) >= 1)
            return false;
    return true;
}

static bool is_too_large(size_t samples, int32_t terms)
{
    const uint64_t n = (uint64_t)terms;
    return samples > MAX_ENTRIES / n || samples > MAX_WORK / (n * n);
}

int32_t rwedge_series_fit(size_t samples, const double x[], const double p[], int32_t terms,
                          rwedge_series **series)
{
    if (!series || (samples > 0 && (!x || !p)))
        return RWEDGE_ENULL;
    if (terms < 1 || terms > MAX_TERMS || is_too_large(samples, terms))
        return RWEDGE_ERANGE;
    if (!are_samples(samples, x, p))
        return RWEDGE_EDOMAIN;
    if (samples < (size_t)terms)
        return RWEDGE_ERANK;
    rwedge_series *made = allocate(terms);
    double *work = malloc((samples * (size_t)terms + samples) * sizeof *work);
    const int32_t status = made && work ? fit(samples, x, p, work, made) : RWEDGE_ENOMEM;
    free(work);
    if (status == RWEDGE_OK)
        *series = made;
    else
        free(made);
    return status;
}

void rwedge_series_destroy(rwedge_series *series)
{
    free(series);
}

int32_t rwedge_series_terms(const rwedge_series *series)
{
    return series ? series->terms : 0;
}

double rwedge_series_coefficient(const rwedge_series *series, int32_t k)
{
    if (!series || k < 0)
        return NAN;
    return k < series->terms ? series->a[k] : 0;
}

double rwedge_series_residual(const rwedge_series *series)
{
    return series ? series->residual : NAN;
}

double rwedge_series_pressure(const rwedge_series *series, double x)
{
    if (!series || !rw_is_signed(x))
        return NAN;
    if (fabs(x) >= 1)
        return 0;
    /* R_n = T_n - i sqrt(1-x^2) U_(n-1) on y = 0 (E3) */
    const rw_outer_place at = {{x, -rw_cos_asin(x)}, {0, 0}};
    return rw_series_field((size_t)series->terms, series->a, at).G_im;
}

static rw_field field_at(const rwedge_series *series, double x, double y)
{
    const double right = fabs(x);
    return rw_series_field((size_t)series->terms, series->a,
                           rw_outer_place_of(right, y, right - 1, x < 0 ? -1 : 1));
}

static int32_t check(const rwedge_series *series, double f, double x, double y)
{
    if (!series)
        return RWEDGE_ENULL;
    return rw_is_friction(f) && rw_is_signed(x) && rw_is_magnitude(y) ? RWEDGE_OK : RWEDGE_EDOMAIN;
}

int32_t rwedge_series_potential(const rwedge_series *series, double f, double x, double y,
                                double *re, double *im)
{
    if (!re || !im)
        return RWEDGE_ENULL;
    const int32_t status = check(series, f, x, y);
    if (status != RWEDGE_OK)
        return status;
    const rw_field field = field_at(series, x, y);
    *re = (field.G_im - f * field.G_re) / 2;
    *im = -(field.G_re + f * field.G_im) / 2;
    return RWEDGE_OK;
}

int32_t rwedge_series_stress(const rwedge_series *series, double f, double x, double y, double *sxx,
                             double *syy, double *txy)
{
    if (!sxx || !syy || !txy)
        return RWEDGE_ENULL;
    const int32_t status = check(series, f, x, y);
    if (status != RWEDGE_OK)
        return status;
    const rw_field field = field_at(series, x, y);
    rw_give_stress(rw_superpose(field, rw_field_multiple(f, field)), sxx, syy, txy);
    return RWEDGE_OK;
}
