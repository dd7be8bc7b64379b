/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The powers of e of lib/base/exponential.h, compared with the math library's in long double. */
#include "claims.h"
#include "base/exponential.h"

#include <float.h>

static const double STATED = 2; /* units of the last digit */

static void need_more_digits_than_a_double(void)
{
    if (LDBL_MANT_DIG < 64) {
        print_message("SKIPPED: long double has no more digits than double here\n");
        skip();
    }
}

CLAIM(powers_of_e_are_as_accurate_as_stated)
{
    need_more_digits_than_a_double();
    static const double ranges[] = {1e-15, 0.3, 1, 40, 700};
    uint64_t seed = 1;
    for (size_t k = 0; k < sizeof ranges / sizeof ranges[0]; k++)
        for (int i = 0; i < 100000; i++) {
            const double x = random_between(&seed, -ranges[k], ranges[k]);
            const long double expected = expl(x);
            assert_within((double)((rw_exponential(x) - expected) / expected), 0,
                          STATED * DBL_EPSILON);
        }
    assert_true(rw_exponential(0) == 1);
}

CLAIM(directions_are_as_accurate_as_stated)
{
    need_more_digits_than_a_double();
    static const double ranges[] = {1e-10, 0.5, 4};
    uint64_t seed = 2;
    for (size_t k = 0; k < sizeof ranges / sizeof ranges[0]; k++)
        for (int i = 0; i < 100000; i++) {
            const double angle = random_between(&seed, -ranges[k], ranges[k]);
            const rw_complex at = rw_direction(angle);
            assert_within((double)(at.re - cosl(angle)), 0, STATED * DBL_EPSILON);
            assert_within((double)(at.im - sinl(angle)), 0, STATED * DBL_EPSILON);
        }
    const rw_complex ahead = rw_direction(0);
    assert_true(ahead.re == 1 && ahead.im == 0);
}
