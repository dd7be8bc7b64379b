/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How exact the workbook's calculator is. Its computation in C is compared with the library. The
 * cells store the values of this computation; in workbook.sh LibreOffice repeats it. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include <rwedge.h>

#include "workbook/model.h"

/* What the sheet About, the calculator's notes and cli/README.md say. */
static const double EXACT = 1e-12, LIMIT = 5e-4, YIELD = 1.5e-3, YIELD_SMALL_TIP = 4e-3,
                    CRITICAL = 6e-3;
static const double SMALL_TIP = 0.02;

static limit_table table;

typedef struct {
    double exact, limit, yield, yield_small_tip, critical;
} errors;

static void keep_larger(double *worst, double error)
{
    if (!(error <= *worst)) /* NAN too */
        *worst = error;
}

static double relative(double got, double expected)
{
    return fabs(got / expected - 1);
}

/* k is such that it yields at this a/b. */
static void compare(double tip, double f, double nu, errors *worst)
{
    workbook_inputs in = {0.02, 0.3, 1e5, nu, 2e5, 0.3, 0, f, 0};
    const double A = rwedge_compliance(in.E1, in.nu1, in.E2, in.nu2),
                 limit = rwedge_elastic_limit(tip, f, nu);
    workbook_results got;
    in.P = rwedge_normal_load(in.theta, in.a, A, in.a / tip);
    in.k = in.P * tip / (in.a * limit);
    workbook_compute(&table, &in, &got);
    keep_larger(&worst->exact, relative(got.b, rwedge_half_width(in.theta, in.a, A, in.P)));
    keep_larger(&worst->exact, relative(got.p0, in.theta / A * rwedge_peak_pressure(tip)));
    keep_larger(&worst->exact, relative(got.tension_ratio, rwedge_max_tension(tip)));
    keep_larger(&worst->limit, relative(got.limit, limit));
    keep_larger(&worst->critical, fabs(got.f_critical - rwedge_critical_friction(tip, nu)));
    if (got.reached > 0) /* at the end of the table the interpolated load may be beyond it */
        keep_larger(tip < SMALL_TIP ? &worst->yield_small_tip : &worst->yield,
                    relative(got.P_yield, in.P));
    else
        assert_true(tip < 1.02 * WORKBOOK_TIP_MIN);
}

static void show(const char *where, const errors *worst)
{
    printf("%s: b, p0, tension %.1e; limit %.1e; load at yield %.1e, %.1e for a/b < %g; critical "
           "friction %.1e\n",
           where, worst->exact, worst->limit, worst->yield, worst->yield_small_tip, SMALL_TIP,
           worst->critical);
    assert_true(worst->exact <= EXACT);
    assert_true(worst->limit <= LIMIT);
    assert_true(worst->yield <= YIELD);
    assert_true(worst->yield_small_tip <= YIELD_SMALL_TIP);
    assert_true(worst->critical <= CRITICAL);
}

static void centres_of_all_cells_are_as_exact_as_stated(void **state)
{
    errors worst = {0};
    (void)state;
    for (int i = 0; i + 1 < TIPS; i++)
        for (int j = 0; j + 1 < NUS; j++)
            for (int k = 0; k + 1 < FRICTIONS; k++)
                compare(sqrt(table.tip[i] * table.tip[i + 1]), (table.f[k] + table.f[k + 1]) / 2,
                        (table.nu[j] + table.nu[j + 1]) / 2, &worst);
    show("centres of the cells", &worst);
}

/* A generator of its own, the same numbers everywhere. */
static double uniform(uint64_t *seed, double low, double high)
{
    *seed = *seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return low + (high - low) * (double)(*seed >> 11) / 9007199254740992.0;
}

static void random_points_are_as_exact_as_stated(void **state)
{
    errors worst = {0};
    uint64_t seed = 2026;
    (void)state;
    for (int i = 0; i < 10000; i++) {
        const double tip = i % 2 ? uniform(&seed, WORKBOOK_TIP_MIN, 1.5)
                                 : exp(uniform(&seed, log(WORKBOOK_TIP_MIN), 0));
        const double f =
            i % 10 == 0 ? 0 : uniform(&seed, 0, i % 3 == 0 ? WORKBOOK_FRICTION_MAX : 0.4);
        compare(tip, f, uniform(&seed, 0, 0.5), &worst);
    }
    show("random points", &worst);
}

/* f = 0.376, next to the end of the branch below the surface, cost 0.25 % while the table had no
 * node but 0.4 above it. */
static void next_to_the_last_cusp(void **state)
{
    errors worst = {0};
    (void)state;
    for (int i = 0; i <= 100; i++)
        compare(0.98 + 0.0002 * i, 0.3757, 0.494, &worst);
    show("next to the last cusp", &worst);
}

static int fill(void **state)
{
    (void)state;
    return limit_table_fill(&table) ? 0 : -1;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(centres_of_all_cells_are_as_exact_as_stated),
        cmocka_unit_test(random_points_are_as_exact_as_stated),
        cmocka_unit_test(next_to_the_last_cusp),
    };
    return cmocka_run_group_tests(tests, fill, NULL);
}
