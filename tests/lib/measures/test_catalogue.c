/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the library tells of its criteria, and that it holds to it. */
#include "claims.h"
#include "rwedge.h"

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
