/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Powers of e, the inverse of logarithm.h in its manner: additions, multiplications and the bits of
 * a number, so that they are the same bits everywhere, and vector instructions in a loop. The error
 * is below 2 units of the last digit, of a cosine or sine below that of 1. */
#ifndef RW_EXPONENTIAL_H
#define RW_EXPONENTIAL_H

#include "base/complex.h"

/* A number of moderate size plus this is rounded to an integer, which are then its last bits. */
#define RW_ROUNDING 0x1.8p52

/* e^x, |x| <= 700: 2^k e^r, |r| <= ln(2)/2. */
RW_INLINE double rw_exponential(double x)
{
    static const double LN2_HIGH = 0x1.62e42fefa0000p-1, LN2_LOW = 0x1.cf79abc9e3b3ap-40;
    const uint64_t bits = rw_bits_of(x * (1 / RW_LN2) + RW_ROUNDING);
    const double k = rw_double_of(bits) - RW_ROUNDING;
    const double r = (x - k * LN2_HIGH) - k * LN2_LOW, u = r * r;
    const double even =
        1.0 / 2 +
        u * (1.0 / 24 + u * (1.0 / 720 + u * (1.0 / 40320 + u * (1.0 / 3628800 + u / 479001600))));
    const double odd =
        1.0 / 6 + u * (1.0 / 120 + u * (1.0 / 5040 + u * (1.0 / 362880 +
                                                          u * (1.0 / 39916800 + u / 6227020800))));
    return rw_double_of((bits + 1023) << 52) * (1 + (r + u * (even + r * odd)));
}

/* cos(angle) + i sin(angle), |angle| <= 4: a quarter turn k times, and r, |r| <= pi/4. */
RW_INLINE rw_complex rw_direction(double angle)
{
    static const double QUARTER_HIGH = 1.57079632679489661923, QUARTER_LOW = 0x1.1a62633145c07p-54;
    const uint64_t bits = rw_bits_of(angle * (1 / QUARTER_HIGH) + RW_ROUNDING);
    const double k = rw_double_of(bits) - RW_ROUNDING;
    const double r = (angle - k * QUARTER_HIGH) - k * QUARTER_LOW, u = r * r;
    const double sine =
        r - r * u *
                (1.0 / 6 -
                 u * (1.0 / 120 -
                      u * (1.0 / 5040 -
                           u * (1.0 / 362880 - u * (1.0 / 39916800 -
                                                    u * (1.0 / 6227020800 - u / 1307674368000))))));
    const double cosine =
        1 - u * (1.0 / 2 -
                 u * (1.0 / 24 -
                      u * (1.0 / 720 - u * (1.0 / 40320 - u * (1.0 / 3628800 -
                                                               u * (1.0 / 479001600 -
                                                                    u * (1.0 / 87178291200 -
                                                                         u / 20922789888000)))))));
    const uint64_t odd = 0 - (bits & 1), one = rw_bits_of(cosine), two = rw_bits_of(sine);
    return (rw_complex){rw_double_of(((one & ~odd) | (two & odd)) ^ (((bits + 1) & 2) << 62)),
                        rw_double_of(((two & ~odd) | (one & odd)) ^ ((bits & 2) << 62))};
}

#endif
