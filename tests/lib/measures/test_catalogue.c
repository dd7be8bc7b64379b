/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the library tells of its criteria, and that it holds to it. */
#include "claims.h"
#include "rwedge.h"

#include <math.h>
#include <string.h>

enum { CONSTANTS_MAX = 12 };

static const double sxx[4] = {300, 20, -80, 45}, syy[4] = {-40, 5, 60, -10},
                    txy[4] = {10, 30, -90, 2};

static bool is_of_friction(int32_t i)
{
    return i >= RWEDGE_MEASURE_SLIP_RANGE && i <= RWEDGE_MEASURE_ENERGY_PER_AREA;
}

static int32_t measured(int32_t criterion, const double constants[])
{
    double value, angle, out_of_plane;
    return rwedge_criterion(criterion, constants, 4, sxx, syy, txy, 0.3, 0, &value, &angle,
                            &out_of_plane);
}

/* In its range, away from its ends. */
static double some_constant(int32_t criterion, int32_t j)
{
    double low, high;
    assert_ok(rwedge_constant_range(criterion, j, &low, &high));
    return high > 1 ? 30 : (low + high) / 2;
}

static int32_t fill(int32_t criterion, double constants[CONSTANTS_MAX])
{
    int32_t j = 0;
    for (; rwedge_constant_name(criterion, j)[0] != '\0'; j++)
        constants[j] = some_constant(criterion, j);
    return j;
}

CLAIM(every_measure_says_what_it_is)
{
    for (int32_t i = 0; i < rwedge_criterion_count(); i++) {
        assert_true(strlen(rwedge_criterion_name(i)) > 0 && strlen(rwedge_criterion_title(i)) > 0);
        assert_true(strlen(rwedge_criterion_text(i)) > 0 && strlen(rwedge_criterion_unit(i)) > 0);
        for (int32_t k = 0; k < i; k++)
            assert_string_not_equal(rwedge_criterion_name(i), rwedge_criterion_name(k));
    }
    assert_string_equal(rwedge_criterion_name(RWEDGE_MEASURE_FATEMI_SOCIE_IN_PLANE),
                        "fatemi_socie_in_plane");
    assert_int_equal(rwedge_criterion_count(), RWEDGE_MEASURE_FATEMI_SOCIE_IN_PLANE + 1);
}

CLAIM(a_number_that_no_measure_has_tells_nothing)
{
    const int32_t none[] = {-1, INT32_MIN, rwedge_criterion_count(), INT32_MAX};
    double low = 5, high = 6;
    for (int i = 0; i < 4; i++) {
        assert_string_equal(rwedge_criterion_name(none[i]), "");
        assert_string_equal(rwedge_criterion_title(none[i]), "");
        assert_string_equal(rwedge_criterion_text(none[i]), "");
        assert_string_equal(rwedge_criterion_unit(none[i]), "");
        assert_string_equal(rwedge_criterion_limit(none[i]), "");
        assert_string_equal(rwedge_constant_name(none[i], 0), "");
        assert_string_equal(rwedge_constant_text(RWEDGE_MEASURE_SWT, none[i]), "");
        assert_string_equal(rwedge_constant_unit(RWEDGE_MEASURE_SWT, none[i]), "");
        assert_nan(rwedge_constant_usual(none[i], 0));
        assert_int_equal(rwedge_criterion_constants(none[i]), 0);
        assert_int_equal(rwedge_criterion_degree(none[i]), 0);
        assert_int_equal(rwedge_damage_constants(none[i]), 0);
        assert_int_equal(rwedge_constant_range(none[i], 0, &low, &high), RWEDGE_EDOMAIN);
    }
    assert_int_equal(rwedge_constant_range(RWEDGE_MEASURE_FINDLEY, 1, &low, &high), RWEDGE_EABSENT);
    assert_true(low == 5 && high == 6);
}

CLAIM(a_criterion_takes_its_constants_in_their_ranges_and_no_others)
{
    for (int32_t i = 0; i < rwedge_criterion_count(); i++) {
        double constants[CONSTANTS_MAX] = {0};
        const int32_t all = fill(i, constants), own = rwedge_criterion_constants(i);
        assert_true(own <= all && (all == own || all == rwedge_damage_constants(i)));
        assert_int_equal(measured(i, constants), is_of_friction(i) ? RWEDGE_EDOMAIN : RWEDGE_OK);
        for (int32_t j = 0; j < own; j++) {
            const double right = constants[j], wrong[] = {-1, 2e60, NAN, INFINITY};
            assert_true(strlen(rwedge_constant_text(i, j)) > 0);
            for (int k = 0; k < 4; k++) {
                constants[j] = wrong[k];
                assert_int_equal(measured(i, constants), RWEDGE_EDOMAIN);
            }
            constants[j] = right;
        }
    }
    assert_int_equal(measured(RWEDGE_MEASURE_SWT, NULL), RWEDGE_ENULL);
    assert_int_equal(measured(RWEDGE_MEASURE_STRESS_RANGE, NULL), RWEDGE_OK); /* it has none */
}

CLAIM(a_life_takes_the_constants_of_its_damage)
{
    for (int32_t i = 0; i < rwedge_criterion_count(); i++) {
        double constants[CONSTANTS_MAX] = {0};
        const int32_t all = fill(i, constants);
        if (rwedge_damage_constants(i) == 0) {
            assert_nan(rwedge_life(i, constants, 1));
            continue;
        }
        constants[all - 1] = 0; /* no limit */
        assert_true(rwedge_life(i, constants, 1) > 0);
        for (int32_t j = 0; j < all; j++) {
            const double right = constants[j];
            constants[j] =
                rwedge_constant_name(i, j)[0] == 'b' || rwedge_constant_name(i, j)[0] == 'c' ? 0.1
                                                                                             : -1;
            assert_nan(rwedge_life(i, constants, 1));
            constants[j] = right;
        }
    }
    assert_nan(rwedge_life(RWEDGE_MEASURE_SWT, NULL, 1));
}

/* What is left out has a usual value; a limit of a curve is 0, k of Fatemi and Socie 1. */
CLAIM(a_constant_that_a_material_need_not_give_has_a_usual_value)
{
    assert_close(rwedge_constant_usual(RWEDGE_MEASURE_FATEMI_SOCIE, 1), 1, 0);
    assert_true(rwedge_constant_usual(RWEDGE_MEASURE_MODIFIED_WOHLER, 2) == 0);
    assert_true(rwedge_constant_usual(RWEDGE_MEASURE_SWT, 5) == 0);
    assert_nan(rwedge_constant_usual(RWEDGE_MEASURE_SWT, 0));
    assert_nan(rwedge_constant_usual(RWEDGE_MEASURE_MODIFIED_WOHLER, 1));
}

CLAIM(the_range_of_sxx_is_that_of_its_values)
{
    double value, angle = 1, out_of_plane = 1;
    assert_ok(rwedge_criterion(RWEDGE_MEASURE_STRESS_RANGE, NULL, 4, sxx, syy, txy, 0.3, 0, &value,
                               &angle, &out_of_plane));
    assert_true(value == 380 && angle == 0 && out_of_plane == 0);
}

/* ---- The factor on the stresses ---- */

static int32_t factor_of(int32_t criterion, const double constants[], double limit, double *factor)
{
    return rwedge_criterion_factor(criterion, constants, limit, 4, sxx, syy, txy, 0.3, 0, factor);
}

static double value_times(int32_t criterion, const double constants[], double factor)
{
    double xx[4], yy[4], xy[4], value, angle, out_of_plane;
    for (int i = 0; i < 4; i++) {
        xx[i] = factor * sxx[i];
        yy[i] = factor * syy[i];
        xy[i] = factor * txy[i];
    }
    assert_ok(rwedge_criterion(criterion, constants, 4, xx, yy, xy, 0.3, 0, &value, &angle,
                               &out_of_plane));
    return value;
}

CLAIM(a_criterion_with_a_degree_grows_with_that_power_of_the_stresses)
{
    for (int32_t i = 0; i < rwedge_criterion_count(); i++) {
        double constants[CONSTANTS_MAX] = {0};
        const int32_t degree = rwedge_criterion_degree(i);
        fill(i, constants);
        if (is_of_friction(i)) {
            assert_int_equal(degree, 0);
            continue;
        }
        const double grown = log(value_times(i, constants, 3) / value_times(i, constants, 1));
        if (degree > 0)
            assert_close(grown / log(3), degree, 1e-6); /* of McDiarmid's plane */
        else
            assert_true(fabs(grown / log(3) - 1) > 1e-3 && fabs(grown / log(3) - 2) > 1e-3);
    }
    assert_int_equal(rwedge_criterion_degree(RWEDGE_MEASURE_SWT), 2);
    assert_int_equal(rwedge_criterion_degree(RWEDGE_MEASURE_CROSSLAND), 1);
}

CLAIM(stresses_times_the_factor_have_the_value)
{
    static const double ratio[] = {0.3, 0.999, 1, 7};
    for (int32_t i = 0; i < rwedge_criterion_count(); i++) {
        double constants[CONSTANTS_MAX] = {0}, factor;
        fill(i, constants);
        for (int k = 0; k < 4 && !is_of_friction(i); k++) {
            const double limit = ratio[k] * value_times(i, constants, 1);
            assert_ok(factor_of(i, constants, limit, &factor));
            assert_close(value_times(i, constants, factor), limit, 1e-7); /* McDiarmid's plane */
        }
    }
}

/* On one plane tau_a + kappa rho is straight over the factor: (lambda - kappa rho)/tau_a. */
CLAIM(the_factor_of_a_pulsating_tension_by_the_modified_woehler_curve)
{
    static const double pulsating[2] = {300, 0}, nothing[2] = {0, 0};
    const double constants[3] = {50, 400, 10};
    double factor = 5;
    assert_ok(rwedge_criterion_factor(RWEDGE_MEASURE_MODIFIED_WOHLER, constants, 400, 2, pulsating,
                                      nothing, nothing, 0, 0, &factor));
    assert_close(factor, (400 - 50 * 2) / 75.0, 1e-6); /* the plane of 45 deg, rho 150/75 */
    factor = 5;
    assert_int_equal(rwedge_criterion_factor(RWEDGE_MEASURE_MODIFIED_WOHLER, constants, 90, 2,
                                             pulsating, nothing, nothing, 0, 0, &factor),
                     RWEDGE_EABSENT); /* kappa rho alone is 100 */
    assert_true(factor == 5);
}

CLAIM(a_factor_is_refused_as_the_criterion_is)
{
    const double E = 2e5, zero[4] = {0};
    double factor = 5;
    assert_int_equal(factor_of(RWEDGE_MEASURE_SWT, &E, 0, &factor), RWEDGE_EDOMAIN);
    assert_int_equal(factor_of(RWEDGE_MEASURE_SWT, &E, NAN, &factor), RWEDGE_EDOMAIN);
    assert_int_equal(factor_of(RWEDGE_MEASURE_RUIZ_F1, &E, 1, &factor), RWEDGE_EDOMAIN);
    assert_int_equal(factor_of(RWEDGE_MEASURE_SWT, NULL, 1, &factor), RWEDGE_ENULL);
    assert_int_equal(factor_of(RWEDGE_MEASURE_SWT, &E, 1, NULL), RWEDGE_ENULL);
    assert_int_equal(
        rwedge_criterion_factor(RWEDGE_MEASURE_SWT, &E, 1, 4, zero, zero, zero, 0.3, 0, &factor),
        RWEDGE_EABSENT);
    assert_int_equal(
        rwedge_criterion_factor(RWEDGE_MEASURE_SWT, &E, 1, 0, sxx, syy, txy, 0.3, 0, &factor),
        RWEDGE_ERANGE);
    assert_true(factor == 5);
}
