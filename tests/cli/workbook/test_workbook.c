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
#include <string.h>

#include <cmocka.h>

#include <rwedge.h>

#include "workbook/case/model.h"

/* What the sheet About, the calculator's notes and cli/README.md say. */
static const double EXACT = 1e-12, LIMIT = 5e-4, YIELD = 1.5e-3, YIELD_SMALL_TIP = 5e-3,
                    YIELD_SMALLEST_TIP = 2e-2, CRITICAL = 1e-3, PLACE = 2e-2, PLACE_FLAT = 0.35,
                    PLACE_SMALL_TIP = 3e-3;
static const double SMALL_TIP = 0.02, SMALLER_TIP = 0.01;
/* Above it, J2 along the surface hardly changes. */
static const double FLAT_NU = 0.4;

static yield_table table;

typedef struct {
    double exact, limit, yield, yield_small_tip, yield_smallest_tip, critical, place, place_flat,
        place_small_tip;
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

/* The contact's tension under Q, from the stress of the library at its edge. */
static double tension(double theta, double A, double tip, double f, double Q_over_fP)
{
    double sxx = NAN, syy, txy;
    const double c = rwedge_stick_width(tip, Q_over_fP);
    assert_int_equal(rwedge_stress(tip, f, c, -1, 0, &sxx, &syy, &txy), RWEDGE_OK);
    return theta / A * sxx;
}

/* In a, or in b for Hertz; of a small tip in b. The branch is the workbook's: next to a cusp it may
 * be the other one. */
static void compare_place(double tip, double f, double nu, double b, const case_values *out,
                          errors *worst)
{
    const bool surface = strcmp(out->branch, "surface") == 0;
    double limit = NAN, x = NAN, y = 0;
    assert_int_equal(surface ? rwedge_surface_yield(tip, f, nu, &limit, &x)
                             : rwedge_subsurface_yield(tip, f, nu, &limit, &x, &y),
                     RWEDGE_OK);
    assert_true(limit <= rwedge_elastic_limit(tip, f, nu) * (1 + LIMIT));
    const bool small = tip < SMALL_TIP, flat = surface && nu > FLAT_NU;
    keep_larger(small  ? &worst->place_small_tip
                : flat ? &worst->place_flat
                       : &worst->place,
                hypot(out->number[CELL_YIELD_X] / b - x, out->number[CELL_YIELD_Y] / b - y) /
                    (small ? 1 : fmin(1, tip)));
}

/* k is such that it yields at this a/b. */
static void compare(double tip, double f, double nu, double Q_over_fP, errors *worst)
{
    const double theta = 0.02, a = 0.3, E1 = 1e5, E2 = 2e5, nu2 = 0.3;
    const double A = rwedge_compliance(E1, nu, E2, nu2), limit = rwedge_elastic_limit(tip, f, nu);
    const double P = rwedge_normal_load(theta, a, A, a / tip),
                 b = rwedge_half_width(theta, a, A, P);
    const double in[INPUT_CELLS] = {[CELL_E1] = E1,
                                    [CELL_NU1] = nu,
                                    [CELL_E2] = E2,
                                    [CELL_NU2] = nu2,
                                    [CELL_THETA] = theta,
                                    [CELL_THETA_DEG] = NAN,
                                    [CELL_ROUNDING] = a,
                                    [CELL_RADIUS] = NAN,
                                    [CELL_LOAD] = P,
                                    [CELL_Q] = Q_over_fP * f * P,
                                    [CELL_F] = f,
                                    [CELL_K] = P * tip / (a * limit),
                                    [CELL_YIELD_STRESS] = NAN};
    case_values out;
    const double *got = out.number;
    workbook_compute(&table, in, &out);
    keep_larger(&worst->exact, relative(got[CELL_B], b));
    keep_larger(&worst->exact, relative(got[CELL_P0], theta / A * rwedge_peak_pressure(tip)));
    keep_larger(&worst->exact,
                relative(got[CELL_TENSION_SLIDING], f * P / b * rwedge_max_tension(tip)) * (f > 0));
    if (f > 0) {
        keep_larger(&worst->exact, fabs(got[CELL_C_OVER_B] - rwedge_stick_width(tip, Q_over_fP)));
        keep_larger(&worst->exact, fabs(got[CELL_TENSION] - tension(theta, A, tip, f, Q_over_fP)) /
                                       got[CELL_TENSION_SLIDING]);
    }
    keep_larger(&worst->limit, relative(got[CELL_P_OVER_BK], limit));
    keep_larger(&worst->limit, relative(got[CELL_SAFETY_STRENGTH], 1));
    keep_larger(&worst->critical, fabs(got[CELL_F_CRITICAL] - rwedge_critical_friction(tip, nu)));
    /* At the end of the table the interpolated load may be beyond. */
    if (!isnan(got[CELL_P_YIELD])) {
        compare_place(tip, f, nu, b, &out, worst);
        keep_larger(tip < SMALLER_TIP ? &worst->yield_smallest_tip
                    : tip < SMALL_TIP ? &worst->yield_small_tip
                                      : &worst->yield,
                    relative(got[CELL_P_YIELD], P));
    } else
        assert_true(tip < 1.02 * WORKBOOK_TIP_MIN && out.safety[0] == '>');
}

static void show(const char *where, const errors *worst)
{
    printf("%s: contact and tension %.1e; limit %.1e; load at yield %.1e, %.1e for a/b < %g, %.1e "
           "for a/b < %g; critical friction %.1e; place %.1e a, %.1e a where it is flat, %.1e b "
           "for a/b < %g\n",
           where, worst->exact, worst->limit, worst->yield, worst->yield_small_tip, SMALL_TIP,
           worst->yield_smallest_tip, SMALLER_TIP, worst->critical, worst->place, worst->place_flat,
           worst->place_small_tip, SMALL_TIP);
    assert_true(worst->exact <= EXACT);
    assert_true(worst->limit <= LIMIT);
    assert_true(worst->yield <= YIELD);
    assert_true(worst->yield_small_tip <= YIELD_SMALL_TIP);
    assert_true(worst->yield_smallest_tip <= YIELD_SMALLEST_TIP);
    assert_true(worst->critical <= CRITICAL);
    assert_true(worst->place <= PLACE);
    assert_true(worst->place_small_tip <= PLACE_SMALL_TIP);
    assert_true(worst->place_flat <= PLACE_FLAT);
}

static void centres_of_all_cells_are_as_exact_as_stated(void **state)
{
    errors worst = {0};
    (void)state;
    for (int i = 0; i + 1 < TIPS; i++)
        for (int j = 0; j + 1 < NUS; j++)
            for (int k = 0; k + 1 < FRICTIONS; k++)
                compare(1 / cosh((table.t[i] + table.t[i + 1]) / 2),
                        (table.f[k] + table.f[k + 1]) / 2, (table.nu[j] + table.nu[j + 1]) / 2, 0.5,
                        &worst);
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
        const double nu = uniform(&seed, 0, 0.5), Q_over_fP = uniform(&seed, 0, 1);
        compare(tip, f, nu, Q_over_fP, &worst);
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
        compare(0.98 + 0.0002 * i, 0.3757, 0.494, 0, &worst);
    show("next to the last cusp", &worst);
}

static int fill(void **state)
{
    (void)state;
    return yield_table_fill(&table) ? 0 : -1;
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
