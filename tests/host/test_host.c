/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A call changes nothing in its host. This is tried over a grid of extreme arguments. errno stays
 * what it was. No valid call raises invalid, division by zero or overflow, on which a host may
 * trap. No call clears an exception that the host has raised. Results with RWEDGE_OK are finite.
 * */
#include "claims.h"
#include "rwedge.h"

#include <errno.h>
#include <fenv.h>
#include <float.h>
#include <locale.h>
#include <stdio.h>
#include <string.h>

enum { MARK = 12345 }; /* an errno that nobody sets */

enum {
    TROUBLE = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW,
    EVERYTHING = TROUBLE | FE_UNDERFLOW | FE_INEXACT
};

static const double ratios[] = {
    0,      1e-60,           1e-40, 1e-16,           1e-14, 3e-9, 1e-6, 1e-3, 0.25, 0.5,
    0.9999, 1 - DBL_EPSILON, 1,     1 + DBL_EPSILON, 2,     100,  1e10, 1e40, 1e60};
static const double frictions[] = {0, 1e-60, 1e-20, 1e-8, 0.01, 0.1, 0.3, 0.55, 1, 2, 100, 1e6};
static const double poissons[] = {
    0, 0.1, 0.25, 0.3, 0.3605, 0.49, 0.5 - 1e-9, 0.5 - DBL_EPSILON / 4, 0.5};
#define COUNT(array) (sizeof(array) / sizeof(array)[0])

static void begin(void)
{
    errno = MARK;
    feclearexcept(FE_ALL_EXCEPT);
}

/* what, of a, b and c, gave a value. */
static void end(const char *what, double a, double b, double c, double value)
{
    const int raised = fetestexcept(TROUBLE);
    if (errno != MARK || raised || !isfinite(value))
        fail_msg("%s(%g, %g, %g) = %g: errno %d, exceptions:%s%s%s", what, a, b, c, value,
                 errno == MARK ? 0 : errno, raised & FE_INVALID ? " invalid" : "",
                 raised & FE_DIVBYZERO ? " division by zero" : "",
                 raised & FE_OVERFLOW ? " overflow" : "");
}

/* A host that has raised every exception: by its arithmetic, so that they are where the
 * library's are. */
static void begin_raised(void)
{
    volatile double zero = 0, most = DBL_MAX, least = DBL_MIN, sink;
    begin();
    sink = zero / zero;
    sink = most / zero;
    sink = most * most;
    sink = least * least;
    (void)sink;
}

static void end_raised(const char *what, double a, double b, double c)
{
    const int cleared = EVERYTHING & ~fetestexcept(EVERYTHING);
    if (errno != MARK || cleared)
        fail_msg(
            "%s(%g, %g, %g) in a host with all exceptions raised: errno %d, cleared:%s%s%s%s%s",
            what, a, b, c, errno == MARK ? 0 : errno, cleared & FE_INVALID ? " invalid" : "",
            cleared & FE_DIVBYZERO ? " division by zero" : "",
            cleared & FE_OVERFLOW ? " overflow" : "", cleared & FE_UNDERFLOW ? " underflow" : "",
            cleared & FE_INEXACT ? " inexact" : "");
}

/* Called twice: in a host without exceptions, and in one that has raised them all. */
#define SPARES_THE_HOST(call, a, b, c)                                                             \
    do {                                                                                           \
        begin();                                                                                   \
        const double value = (call);                                                               \
        end(#call, (a), (b), (c), value);                                                          \
        begin_raised();                                                                            \
        const double again = (call);                                                               \
        end_raised(#call, (a), (b), (c));                                                          \
        assert_true(again == value);                                                               \
    } while (0)

/* What begin_raised() raises is all there is to clear: else the claims above claim less. */
static void the_host_can_raise_every_exception(void **state)
{
    (void)state;
    begin_raised();
    assert_int_equal(fetestexcept(EVERYTHING), EVERYTHING);
}

static void formulas_spare_the_host(void **state)
{
    (void)state;
    for (size_t i = 0; i < COUNT(ratios); i++) {
        const double alpha = ratios[i];
        SPARES_THE_HOST(rwedge_load(alpha), alpha, 0, 0);
        SPARES_THE_HOST(rwedge_max_tension(alpha), alpha, 0, 0);
        if (alpha > 0) {
            SPARES_THE_HOST(rwedge_a_over_b(alpha), alpha, 0, 0);
            SPARES_THE_HOST(rwedge_peak_pressure(alpha), alpha, 0, 0);
            SPARES_THE_HOST(rwedge_transition_pressure(alpha), alpha, 0, 0);
        }
        for (int32_t n = 0; n < 500000000; n = 3 * n + 1)
            SPARES_THE_HOST(rwedge_coefficient(alpha, n), alpha, n, 0);
        for (size_t j = 0; j < COUNT(ratios); j++) {
            const double x = ratios[j];
            if (alpha > 0 || x > 0)
                SPARES_THE_HOST(rwedge_pressure(alpha, x), alpha, x, 0);
            if (x > 1)
                continue;
            SPARES_THE_HOST(rwedge_shear_ratio(alpha, x), alpha, x, 0);
            SPARES_THE_HOST(rwedge_stick_width(alpha, x), alpha, x, 0);
            SPARES_THE_HOST(rwedge_stick_width(alpha, 1 - x), alpha, x, 0);
            for (size_t k = 0; k < COUNT(ratios); k++)
                if (alpha > 0 || x > 0 || ratios[k] > 0)
                    SPARES_THE_HOST(rwedge_shear(alpha, x, ratios[k]), alpha, x, ratios[k]);
        }
    }
}

static double sum_of_stress(double alpha, double c, double x, double y)
{
    double s[3] = {NAN, NAN, NAN};
    return rwedge_stress(alpha, 0.5, c, x, y, &s[0], &s[1], &s[2]) == RWEDGE_OK ? s[0] + s[1] + s[2]
                                                                                : NAN;
}

static void stresses_spare_the_host(void **state)
{
    (void)state;
    for (size_t i = 0; i < COUNT(ratios); i++)
        for (size_t j = 0; j < COUNT(ratios) && ratios[j] <= 1; j++)
            for (size_t k = 0; k < COUNT(ratios); k++)
                for (size_t l = 0; l < COUNT(ratios); l++)
                    if (ratios[i] > 0 || ratios[k] > 0 || ratios[l] > 0)
                        SPARES_THE_HOST(sum_of_stress(ratios[i], ratios[j], ratios[k], ratios[l]),
                                        ratios[i], ratios[k], ratios[l]);
}

/* 0 where a branch is absent: that is an answer. */
static double sum_of_yield(double alpha, double f, double nu)
{
    double limit = 0, x = 0, y = 0, sum;
    if (rwedge_yield_point(alpha, f, nu, &limit, &x, &y) != RWEDGE_OK || x < 0 || y < 0)
        return NAN;
    sum = limit;
    limit = 0;
    int32_t status = rwedge_subsurface_yield(alpha, f, nu, &limit, &x, &y);
    if (status != RWEDGE_OK && status != RWEDGE_EABSENT)
        return NAN;
    sum += limit;
    limit = 0;
    status = rwedge_surface_yield(alpha, f, nu, &limit, &x);
    return status == RWEDGE_OK || status == RWEDGE_EABSENT ? sum + limit : NAN;
}

static void strength_spares_the_host(void **state)
{
    (void)state;
    for (size_t i = 0; i < COUNT(ratios); i++) {
        if (ratios[i] > 0 && ratios[i] < 1e-14)
            continue;
        for (size_t k = 0; k < COUNT(poissons); k++) {
            for (size_t j = 0; j < COUNT(frictions); j++)
                SPARES_THE_HOST(sum_of_yield(ratios[i], frictions[j], poissons[k]), ratios[i],
                                frictions[j], poissons[k]);
            SPARES_THE_HOST(rwedge_critical_friction(ratios[i], poissons[k]), ratios[i],
                            poissons[k], 0);
        }
    }
}

static double sum_of_series(const rwedge_series *series, double x, double y)
{
    double s[3] = {NAN, NAN, NAN}, re = NAN, im = NAN;
    if (rwedge_series_stress(series, 0.5, x, y, &s[0], &s[1], &s[2]) != RWEDGE_OK ||
        rwedge_series_potential(series, 0.5, x, y, &re, &im) != RWEDGE_OK)
        return NAN;
    return s[0] + s[1] + s[2] + re + im + rwedge_series_pressure(series, x);
}

static void series_spare_the_host(void **state)
{
    (void)state;
    rwedge_series *series = NULL;
    assert_int_equal(rwedge_series_create(0.3, 51, &series), RWEDGE_OK);
    for (size_t k = 0; k < COUNT(ratios); k++)
        for (size_t l = 0; l < COUNT(ratios); l++)
            SPARES_THE_HOST(sum_of_series(series, -ratios[k], ratios[l]), ratios[k], ratios[l], 0);
    rwedge_series_destroy(series);
}

/* Cycles of three stresses of all sizes, with opposite ones and equal ones among them. */
static double sum_of_measures(double one, double other, double third)
{
    const double sxx[3] = {one, -one, third}, syy[3] = {other, -other, one},
                 txy[3] = {third, other, other};
    double r[7] = {NAN, NAN, NAN, NAN, NAN, NAN, NAN};
    if (rwedge_principal_stresses(one, other, third, &r[0], &r[1], &r[2]) != RWEDGE_OK ||
        rwedge_smith_watson_topper(3, sxx, syy, txy, 7, 0.3, &r[3], &r[4]) != RWEDGE_OK ||
        rwedge_fatemi_socie(3, sxx, syy, txy, 7, 0.3, 0.1, &r[5], &r[6]) != RWEDGE_OK)
        return NAN;
    return rwedge_von_mises(one, other, third, 0.3) + rwedge_largest_shear(one, other, third, 0.3) +
           rwedge_out_of_plane_stress(one, other, 0.3) + r[0] + r[1] + r[2] + r[3] + r[4] + r[5] +
           r[6];
}

static void measures_spare_the_host(void **state)
{
    (void)state;
    static const double sizes[] = {0,    5e-324, 1e-310, 1e-200, 1e-120, 1e-60, 1e-16,
                                   1e-3, 0.5,    1,      1.5,    1e10,   1e60};
    for (size_t i = 0; i < COUNT(sizes); i++)
        for (size_t j = 0; j < COUNT(sizes); j++)
            for (size_t k = 0; k < COUNT(sizes); k++) {
                SPARES_THE_HOST(sum_of_measures(sizes[i], sizes[j], sizes[k]), sizes[i], sizes[j],
                                sizes[k]);
                SPARES_THE_HOST(sum_of_measures(-sizes[i], sizes[j], -sizes[k]), -sizes[i],
                                sizes[j], -sizes[k]);
            }
}

/* The rounding mode of the host is not changed, and its locale does not matter. */
static void modes_are_left_alone(void **state)
{
    (void)state;
    const int modes[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    const double expected = rwedge_elastic_limit(0.3, 0.1, 0.3);
    for (int i = 0; i < 3; i++) {
        assert_int_equal(fesetround(modes[i]), 0);
        const double limit = rwedge_elastic_limit(0.3, 0.1, 0.3);
        assert_int_equal(fegetround(), modes[i]);
        fesetround(FE_TONEAREST);
        assert_close(limit, expected, 1e-13);
    }
    assert_string_equal(setlocale(LC_NUMERIC, NULL), "C");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_host_can_raise_every_exception),
        cmocka_unit_test(formulas_spare_the_host),
        cmocka_unit_test(stresses_spare_the_host),
        cmocka_unit_test(strength_spares_the_host),
        cmocka_unit_test(measures_spare_the_host),
        cmocka_unit_test(series_spare_the_host),
        cmocka_unit_test(modes_are_left_alone),
    };
    return RUN_CLAIMS("host", tests);
}
