/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "claims.h"
#include "rwedge.h"

static void destroy(void *series)
{
    rwedge_series_destroy(series);
}

static rwedge_series *analytic(double alpha, int32_t terms)
{
    rwedge_series *series = NULL;
    assert_ok(rwedge_series_create(alpha, terms, &series));
    free_after_claim(series, destroy);
    return series;
}

enum { SAMPLES = 400 };

static rwedge_series *fitted(const double x[SAMPLES], const double p[SAMPLES], int32_t terms)
{
    rwedge_series *series = NULL;
    assert_ok(rwedge_series_fit(SAMPLES, x, p, terms, &series));
    free_after_claim(series, destroy);
    return series;
}

static void assert_stress(const rwedge_series *series, double alpha, double f, double x, double y,
                          double tolerance)
{
    double a[3], b[3];
    assert_ok(rwedge_series_stress(series, f, x, y, &a[0], &a[1], &a[2]));
    assert_ok(rwedge_stress(alpha, f, 0, x, y, &b[0], &b[1], &b[2]));
    for (int j = 0; j < 3; j++)
        assert_within(a[j], b[j], tolerance);
}

/* The two routes to the stresses test each other: deep enough, 1000 terms leave nothing out. */
CLAIM(series_and_closed_form_agree)
{
    uint64_t seed = 5;
    const double alphas[] = {0, 0.01, 0.1, 0.5, 0.99, 1, 2.5};
    for (size_t i = 0; i < sizeof alphas / sizeof alphas[0]; i++) {
        rwedge_series *series = analytic(alphas[i], alphas[i] < 1 ? 1000 : 1); /* Hertz has one */
        for (int k = 0; k < 50; k++) {
            const double x = 4 * random_fraction(&seed) - 2, y = 0.1 + 3 * random_fraction(&seed);
            assert_stress(series, alphas[i], 0.4, x, y, 1e-13);
        }
        for (double far = 10; far < 1e60; far *= 1e10)
            assert_stress(series, alphas[i], 0.4, -far, far, 1e-14 / far);
    }
}

/* Eq. (32): s = 2 Re Phi; and Phi on the surface of the contact, -(i+f)(g + i p)/2. */
CLAIM(potential_is_equation_30)
{
    const double f = 0.4;
    rwedge_series *series = analytic(1, 3);
    for (double x = -0.9; x < 1; x += 0.3) {
        double re, im, s[3];
        assert_ok(rwedge_series_potential(series, f, x, 0, &re, &im));
        const double g = x, p = -sqrt(1 - x * x);
        assert_within(re, (p - f * g) / 2, 1e-15);
        assert_within(im, -(g + f * p) / 2, 1e-15);
        assert_ok(rwedge_series_potential(series, f, x, 0.4, &re, &im));
        assert_ok(rwedge_series_stress(series, f, x, 0.4, &s[0], &s[1], &s[2]));
        assert_within((s[0] + s[1]) / 2, 2 * re, 1e-15);
    }
}

CLAIM(truncation_is_bounded)
{
    const double alphas[] = {1e-3, 0.1, 0.7};
    for (size_t i = 0; i < sizeof alphas / sizeof alphas[0]; i++)
        for (int32_t terms = 1; terms < 300; terms += 37) {
            rwedge_series *series = analytic(alphas[i], terms);
            double cut = 0;
            for (int32_t n = (terms + 1) / 2; n < 20000; n++)
                cut += fabs(rwedge_coefficient(alphas[i], n));
            const double bound = rwedge_series_residual(series);
            assert_true(cut <= bound);
            assert_true(bound < 10 * cut); /* and the bound is worth having */
            for (double x = 0.05; x < 1; x += 0.1)
                assert_within(rwedge_series_pressure(series, x), rwedge_pressure(alphas[i], x),
                              bound);
        }
    rwedge_series *hertz = analytic(1.5, 1), *sharp = analytic(0, 10);
    assert_within(rwedge_series_residual(hertz), 0, 0);
    assert_true(isinf(rwedge_series_residual(sharp)));
}

static void chebyshev_points(double x[SAMPLES])
{
    for (int i = 0; i < SAMPLES; i++)
        x[i] = cos(PI * (i + 0.5) / SAMPLES);
}

/* An uneven pressure of three terms, U_0, U_1, U_4, is recovered whole; its stresses are
 * Flamant's. */
CLAIM(fit_recovers_an_uneven_pressure)
{
    double x[SAMPLES], p[SAMPLES];
    chebyshev_points(x);
    for (int i = 0; i < SAMPLES; i++) {
        const double t = acos(x[i]);
        p[i] = -(sin(t) + 0.3 * sin(2 * t) - 0.1 * sin(5 * t));
    }
    rwedge_series *series = fitted(x, p, 12);
    assert_int_equal(rwedge_series_terms(series), 12);
    const double expected[12] = {1, 0.3, 0, 0, -0.1};
    for (int32_t k = 0; k < 12; k++)
        assert_within(rwedge_series_coefficient(series, k), expected[k], 1e-14);
    assert_within(rwedge_series_residual(series), 0, 1e-14);
    assert_within(rwedge_series_coefficient(series, 12), 0, 0);
    double s[3], surface[3];
    assert_ok(rwedge_series_stress(series, 0.2, 0.37, 0, &surface[0], &surface[1], &surface[2]));
    assert_within(surface[1], rwedge_series_pressure(series, 0.37), 1e-15);
    assert_within(surface[2], 0.2 * rwedge_series_pressure(series, 0.37), 1e-15);
    assert_ok(rwedge_series_stress(series, 0, 0, 1e6, &s[0], &s[1], &s[2]));
    assert_close(s[1], -2 / PI * (PI / 2) / 1e6, 1e-6); /* Flamant's -2P/(pi y); P = (pi/2) a_0 */
}

CLAIM(rank_deficiency_is_refused)
{
    double x[SAMPLES], p[SAMPLES];
    rwedge_series *untouched = NULL, *series = untouched;
    chebyshev_points(x);
    for (int i = 0; i < SAMPLES; i++) {
        x[i] = x[i % 20]; /* twenty different points */
        p[i] = -1;
    }
    assert_int_equal(rwedge_series_fit(SAMPLES, x, p, 21, &series), RWEDGE_ERANK);
    /* fewer samples than terms */
    assert_int_equal(rwedge_series_fit(20, x, p, 21, &series), RWEDGE_ERANK);
    for (int i = 0; i < SAMPLES; i++)
        x[i] = 1e-6 * i / SAMPLES; /* clustered: independent in exact arithmetic only */
    assert_int_equal(rwedge_series_fit(SAMPLES, x, p, 21, &series), RWEDGE_ERANK);
    assert_ptr_equal(series, untouched);
}

CLAIM(samples_are_as_many_as_terms_need_and_memory_holds)
{
    const double x[3] = {-0.5, 0, 0.5}, p[3] = {-1, -1, -1};
    rwedge_series *series = NULL;
    assert_int_equal(rwedge_series_fit(SIZE_MAX, x, p, 2, &series), RWEDGE_ERANGE);
    assert_int_equal(rwedge_series_fit(0, NULL, NULL, 2, &series), RWEDGE_ERANK);
    assert_int_equal(rwedge_series_fit(3, x, p, 0, &series), RWEDGE_ERANGE);
    assert_null(series);
    series = analytic(0.5, 4);
    assert_nan(rwedge_series_coefficient(series, -1));
    assert_within(rwedge_series_pressure(series, 1), 0, 0);
}

/* As long as 2n+1 is small beside 1/alpha, |b_n| is 4/(pi (2n+1)). The sum from n = N on is nearly
 * that of 2/(pi n) up to n = 1/(2 alpha): a logarithm. */
CLAIM(the_smallest_tips_have_a_bound_too)
{
    for (int decade = 40; decade < 60; decade++) {
        const double alpha = pow(10, -decade), N = 10;
        rwedge_series *series = analytic(alpha, 20);
        const double sum = 2 / PI * (-log(2 * alpha) - log(N)),
                     bound = rwedge_series_residual(series);
        assert_true(bound >= sum);
        assert_close(bound, sum, 0.02);
    }
}

/* Samples of any size: the fit is in proportion to them. The residual of a sample that no term
 * fits, -sin(3t) for two terms, is its root mean square over Chebyshev's points, sqrt(1/2). */
CLAIM(fits_scale_with_the_samples)
{
    double x[SAMPLES], p[SAMPLES];
    chebyshev_points(x);
    for (int exponent = -130; exponent <= 190; exponent += 40) {
        const double unit = ldexp(1, exponent);
        for (int i = 0; i < SAMPLES; i++)
            p[i] = -unit * (sin(acos(x[i])) + sin(3 * acos(x[i])));
        rwedge_series *series = fitted(x, p, 2);
        assert_within(rwedge_series_coefficient(series, 0) / unit, 1, 1e-14);
        assert_within(rwedge_series_coefficient(series, 1) / unit, 0, 1e-14);
        assert_within(rwedge_series_residual(series) / unit, sqrt(0.5), 1e-13);
    }
}

CLAIM(no_pressure_is_fitted_by_none)
{
    double x[SAMPLES], p[SAMPLES] = {0};
    chebyshev_points(x);
    rwedge_series *series = fitted(x, p, 5);
    for (int32_t k = 0; k < 5; k++)
        assert_true(rwedge_series_coefficient(series, k) == 0);
    assert_true(rwedge_series_residual(series) == 0);
    assert_int_equal(rwedge_series_fit(SAMPLES, x, p, (1 << 24) + 1, &series), RWEDGE_ERANGE);
    assert_int_equal(rwedge_series_fit((1 << 26) + 1, x, p, 2, &series), RWEDGE_ERANGE);
    /* both sides of what a minute suffices for: inside, the first sample is looked at */
    x[0] = NAN;
    assert_int_equal(rwedge_series_fit(1 << 26, x, p, 2, &series), RWEDGE_EDOMAIN);
    for (int half = 6; half <= 11; half++) {
        const size_t most = (size_t)1 << (33 - 2 * half);
        assert_int_equal(rwedge_series_fit(most, x, p, 1 << half, &series), RWEDGE_EDOMAIN);
        assert_int_equal(rwedge_series_fit(most + 1, x, p, 1 << half, &series), RWEDGE_ERANGE);
    }
    assert_int_equal(rwedge_series_fit(1 << 14, x, p, 1 << 13, &series), RWEDGE_ERANGE);
}
