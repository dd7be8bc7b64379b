/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Each doubt by itself, at its threshold; the thresholds are those of the header. */
#include "claims.h"
#include "rwedge.h"

#include <fenv.h>
#include <string.h>

static int32_t of_angle(double theta)
{
    return rwedge_validity(theta, NAN, NAN, NAN, NAN, NAN);
}

static int32_t of_rounding(double alpha)
{
    return rwedge_validity(NAN, alpha, NAN, NAN, NAN, NAN);
}

static int32_t of_bodies(double beta, double f)
{
    return rwedge_validity(NAN, NAN, beta, f, NAN, NAN);
}

static int32_t of_strength(double k_over_E)
{
    return rwedge_validity(NAN, NAN, NAN, NAN, k_over_E, NAN);
}

static int32_t of_safety(double safety)
{
    return rwedge_validity(NAN, NAN, NAN, NAN, NAN, safety);
}

CLAIM(a_sound_contact_has_no_doubts)
{
    assert_ok(rwedge_validity(0.01, 0.5, 0, 0.3, 2e-3, 1.5));
    assert_ok(rwedge_validity(0.01, 0, 0.2, 0, 2e-3, HUGE_VAL)); /* sharp; frictionless */
}

CLAIM(an_angle_above_a_tenth_is_doubted)
{
    assert_int_equal(of_angle(0.1), 0);
    assert_int_equal(of_angle(nextafter(0.1, 1)), RWEDGE_DOUBT_ANGLE);
}

CLAIM(dissimilar_bodies_are_doubted_with_friction)
{
    assert_int_equal(of_bodies(0.1, 0), 0);
    assert_int_equal(of_bodies(0, 0.3), 0);
    assert_int_equal(of_bodies(rwedge_dundurs_beta(2.1e5, 0.3, 2.1e5, 0.3), 0.3), 0);
    assert_int_equal(of_bodies(rwedge_dundurs_beta(2.1e5, 0.3, 7e4, 0.33), 0.3),
                     RWEDGE_DOUBT_COUPLING);
    assert_int_equal(of_bodies(-0.1, 1e-9), RWEDGE_DOUBT_COUPLING);
}

CLAIM(a_load_above_yield_is_doubted)
{
    assert_int_equal(of_safety(1), 0);
    assert_int_equal(of_safety(nextafter(1, 0)), RWEDGE_DOUBT_YIELD);
    assert_int_equal(of_safety(0), RWEDGE_DOUBT_YIELD); /* the sharp wedge */
}

/* Steel in GPa beside a load in N/mm: a/b = 0.0046 in place of 4.6. */
CLAIM(mixed_units_are_doubted)
{
    assert_int_equal(of_rounding(0.01), 0);
    assert_int_equal(of_rounding(1e4), 0);
    assert_int_equal(of_rounding(nextafter(0.01, 0)), RWEDGE_DOUBT_ROUNDING);
    assert_int_equal(of_rounding(nextafter(1e4, 1e5)), RWEDGE_DOUBT_ROUNDING);
    assert_int_equal(of_rounding(0), 0);
    const double A = rwedge_compliance(210, 0.3, 210, 0.3);
    assert_int_equal(of_rounding(1 / rwedge_half_width(0.01, 1, A, 500)), RWEDGE_DOUBT_ROUNDING);
    assert_int_equal(of_rounding(1 / rwedge_half_width(0.01, 1, A / 1000, 500)), 0);
    assert_int_equal(of_strength(1e-5), 0);
    assert_int_equal(of_strength(0.1), 0);
    assert_int_equal(of_strength(nextafter(1e-5, 0)), RWEDGE_DOUBT_STRENGTH);
    assert_int_equal(of_strength(nextafter(0.1, 1)), RWEDGE_DOUBT_STRENGTH);
    assert_int_equal(of_strength(0), 0);
}

CLAIM(doubts_add_up)
{
    assert_int_equal(rwedge_validity(1.15, 1e-3, 0.1, 0.6, 1, 0.5), 1 + 2 + 4 + 8 + 16);
}

CLAIM(what_is_not_known_is_not_doubted_and_raises_nothing)
{
    feclearexcept(FE_ALL_EXCEPT);
    assert_ok(rwedge_validity(NAN, NAN, NAN, NAN, NAN, NAN));
    assert_int_equal(fetestexcept(FE_INVALID), 0);
}

CLAIM(every_bit_has_its_own_text_and_nothing_else_has_one)
{
    int32_t all = 0;
    for (int32_t bit = 1; rwedge_validity_text(bit)[0] != '\0'; bit *= 2) {
        all |= bit;
        for (int32_t other = 1; other < bit; other *= 2)
            assert_string_not_equal(rwedge_validity_text(bit), rwedge_validity_text(other));
    }
    assert_int_equal(all, rwedge_validity(1.15, 1e-3, 0.1, 0.6, 1, 0.5));
    const int32_t none[] = {0, 3, -1, INT32_MAX, INT32_MIN};
    for (size_t i = 0; i < sizeof none / sizeof none[0]; i++)
        assert_string_equal(rwedge_validity_text(none[i]), "");
}
