/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The logarithms and angles of lib/base/logarithm.h, compared with the math library's in long
 * double. The error stays below what that file states, in units of the last digit. */
#include "claims.h"
#include "base/logarithm.h"

#include <float.h>

static const double STATED = 3, STATED_DIVIDED = 4; /* units of the last digit */

static double units(double value, long double expected)
{
    int exponent;
    frexpl(expected, &exponent);
    return (double)(fabsl(value - expected) / ldexpl(1, exponent - DBL_MANT_DIG));
}

static double power_of_two(double from, double to, uint64_t *seed)
{
    return pow(2, from + (to - from) * random_fraction(seed));
}

/* The logarithm of a quotient near 1, from its difference from 1, which is exact in long double
 * too. */
static long double log_quotient(double p, double q)
{
    return p > q / 2 && p < 2 * q ? log1pl(((long double)p - q) / q) : logl(p) - logl(q);
}

static void need_more_digits_than_a_double(void)
{
    if (LDBL_MANT_DIG < 64) {
        print_message("SKIPPED: long double has no more digits than double here\n");
        skip();
    }
}

CLAIM(logarithms_are_as_accurate_as_stated)
{
    need_more_digits_than_a_double();
    static const double ranges[] = {1e-15, 1e-8, 1e-3, 0.6, 3, 50, 499};
    uint64_t seed = 1;
    for (size_t k = 0; k < sizeof ranges / sizeof ranges[0]; k++)
        for (int i = 0; i < 100000; i++) {
            const double p = power_of_two(-ranges[k], ranges[k], &seed);
            const double q = i % 2 ? 1 : power_of_two(-ranges[k], ranges[k], &seed);
            assert_within(units(rw_log_of_quotient(p, q), log_quotient(p, q)), 0, STATED);
        }
    assert_within(rw_log_of_quotient(0.3, 0.3), 0, 0);
}

CLAIM(angles_are_as_accurate_as_stated)
{
    need_more_digits_than_a_double();
    static const double ranges[] = {0.01, 1, 3, 60, 900};
    uint64_t seed = 2;
    for (size_t k = 0; k < sizeof ranges / sizeof ranges[0]; k++)
        for (int i = 0; i < 100000; i++) {
            const double x = i % 2 ? 1 : -1,
                         y = (i % 4 < 2 ? 1 : -1) * power_of_two(-ranges[k], ranges[k], &seed);
            assert_within(units(rw_angle(x, y), atan2l(y, x)), 0, STATED);
        }
}

CLAIM(angles_on_the_axes)
{
    assert_within(rw_angle(1, 0), 0, 0);
    assert_within(rw_angle(0, 0), 0, 0);
    assert_within(rw_angle(-1, 0), PI, 0);
    assert_within(rw_angle(0, 1), PI / 2, 0);
    assert_within(rw_angle(0, -1), -PI / 2, 0);
    assert_close(rw_angle(1, 1), PI / 4, 2 * DBL_EPSILON);
    assert_close(rw_angle(-1, -1), -3 * PI / 4, 2 * DBL_EPSILON);
}

/* ln(1 + a)/a and atan(a)/a for a down to 0, where they are 1. */
CLAIM(quotients_by_a_small_parameter_are_relative)
{
    need_more_digits_than_a_double();
    uint64_t seed = 3;
    for (int i = 0; i < 100000; i++) {
        const double a = power_of_two(-200, -2, &seed), p = 1 + a, difference = a;
        const long double angle = atanl(a) / a, logarithm = log1pl(a) / a;
        assert_within(units(rw_angle_over(1, 1, a, 1 / a), angle), 0, STATED_DIVIDED);
        if (p - 1 == difference) /* 1 + a is exact */
            assert_within(units(rw_log_of_quotient_over(p, 1, 1, a, 1 / a), logarithm), 0,
                          STATED_DIVIDED);
    }
    assert_within(rw_angle_over(1, 1, 0, 0), 1, 0);
    assert_within(rw_log_of_quotient_over(1, 1, 1, 0, 0), 1, 0);
}
