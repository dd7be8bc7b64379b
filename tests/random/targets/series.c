/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Analytic series, and fits to any samples. They are refused, or created and finite everywhere. */
#include "input.h"
#include "rwedge.h"

enum { SAMPLES_MAX = 40, TERMS_MAX = 64 };

static double take_number(input *in)
{
    return take_byte(in) < 32 ? take_double(in) : 2 * take_fraction(in) - 1;
}

/* A number of the header's domain, or 0. */
static bool is_magnitude(double v)
{
    return v == 0 || (isfinite(v) && v >= 1e-60 && v <= 1e60);
}

static void check_sums(const rwedge_series *series, double f, double x, double y)
{
    double s[5] = {NAN, NAN, NAN, NAN, NAN};
    const bool valid = is_magnitude(f) && f <= 1e6 && is_magnitude(fabs(x)) && is_magnitude(y);
    const int32_t expected = valid ? RWEDGE_OK : RWEDGE_EDOMAIN;
    CLAIM(rwedge_series_potential(series, f, x, y, &s[0], &s[1]) == expected, "f %g, x %g, y %g", f,
          x, y);
    CLAIM(rwedge_series_stress(series, f, x, y, &s[2], &s[3], &s[4]) == expected,
          "f %g, x %g, y %g", f, x, y);
    for (int i = 0; i < 5; i++)
        CLAIM(isfinite(s[i]) == valid, "f %g, x %g, y %g: %d is %g", f, x, y, i, s[i]);
    CLAIM(isfinite(rwedge_series_pressure(series, x)) == is_magnitude(fabs(x)), "x %g", x);
}

static void check(const rwedge_series *series, int32_t terms, input *in)
{
    CLAIM(rwedge_series_terms(series) == terms, "%d", (int)terms);
    CLAIM(rwedge_series_residual(series) >= 0, "%g", rwedge_series_residual(series));
    for (int32_t k = 0; k <= terms; k++)
        CLAIM(isfinite(rwedge_series_coefficient(series, k)), "%d", (int)k);
    CLAIM(isnan(rwedge_series_coefficient(series, -1)) &&
              rwedge_series_coefficient(series, INT32_MAX) == 0,
          "edges");
    for (int i = 0; i < 4; i++) {
        const double f = fabs(take_number(in)), x = 2 * take_number(in), y = take_number(in);
        check_sums(series, f, x, y);
    }
}

static void create(input *in)
{
    const double alpha = take_number(in);
    const int32_t terms = (int32_t)take_byte(in) - 2;
    rwedge_series *series = NULL;
    const int32_t status = rwedge_series_create(alpha, terms, &series);
    const bool valid = is_magnitude(alpha);
    CLAIM(status == (!valid      ? RWEDGE_EDOMAIN
                     : terms < 1 ? RWEDGE_ERANGE
                                 : RWEDGE_OK),
          "%g, %d: %d", alpha, (int)terms, (int)status);
    CLAIM((series != NULL) == (status == RWEDGE_OK), "%d", (int)status);
    if (series != NULL)
        check(series, terms, in);
    rwedge_series_destroy(series);
}

static void fit(input *in)
{
    double x[SAMPLES_MAX], p[SAMPLES_MAX];
    const size_t samples = take_byte(in) % (SAMPLES_MAX + 1);
    const int32_t terms = (int32_t)(take_byte(in) % TERMS_MAX) - 1;
    const bool near_chebyshev = take_byte(in) % 2 == 0;
    for (size_t i = 0; i < samples; i++) {
        x[i] = near_chebyshev ? cos(((double)i + 0.5) * 3.14159265358979323846 / (double)samples)
                              : take_number(in);
        p[i] = take_number(in);
    }
    rwedge_series *series = NULL;
    const int32_t status = rwedge_series_fit(samples, x, p, terms, &series);
    CLAIM((series != NULL) == (status == RWEDGE_OK) && status >= RWEDGE_OK &&
              status <= RWEDGE_EABSENT,
          "%d", (int)status);
    CLAIM(status != RWEDGE_OK || (terms > 0 && samples >= (size_t)terms), "%d", (int)terms);
    if (series != NULL)
        check(series, terms, in);
    rwedge_series_destroy(series);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    input in = {data, size};
    if (take_byte(&in) % 2 == 0)
        create(&in);
    else
        fit(&in);
    return 0;
}
