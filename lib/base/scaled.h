/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Positive numbers whose exponent has no end, for products and quotients of dimensional
 * quantities: these may leave the range of a double on the way to a result that is inside it,
 * and would raise overflow in the host. Mantissas are rounded as the doubles would be, so that
 * nothing changes for those that stay inside. */
#ifndef RW_SCALED_H
#define RW_SCALED_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

typedef struct {
    double mantissa;
    int exponent; /* of two */
} rw_scaled;

/* v > 0, finite. */
static inline rw_scaled rw_scaled_from(double v)
{
    rw_scaled s;
    s.mantissa = frexp(v, &s.exponent);
    return s;
}

static inline rw_scaled rw_scaled_times(rw_scaled s, rw_scaled factor)
{
    const rw_scaled product = rw_scaled_from(s.mantissa * factor.mantissa);
    return (rw_scaled){product.mantissa, product.exponent + s.exponent + factor.exponent};
}

static inline rw_scaled rw_scaled_over(rw_scaled s, rw_scaled divisor)
{
    const rw_scaled quotient = rw_scaled_from(s.mantissa / divisor.mantissa);
    return (rw_scaled){quotient.mantissa, quotient.exponent + s.exponent - divisor.exponent};
}

static inline rw_scaled rw_scaled_root(rw_scaled s)
{
    const int odd = s.exponent % 2 != 0;
    const rw_scaled root = rw_scaled_from(sqrt(odd ? 2 * s.mantissa : s.mantissa));
    return (rw_scaled){root.mantissa, root.exponent + (s.exponent - odd) / 2};
}

/* Whether it is a normal double. */
static inline bool rw_scaled_is_normal(rw_scaled s)
{
    return s.exponent >= -1021 && s.exponent <= 1024;
}

/* Whether v/divisor is a normal double. */
static inline bool rw_quotient_is_normal(double v, double divisor)
{
    return rw_scaled_is_normal(rw_scaled_over(rw_scaled_from(v), rw_scaled_from(divisor)));
}

/* 2^exponent, a normal double. */
static inline double rw_power_of_two(int exponent)
{
    const uint64_t bits = (uint64_t)(exponent + 1023) << 52;
    double power;
    memcpy(&power, &bits, sizeof power);
    return power;
}

/* The double: NaN where it is too large for one, and 0 where it is too small. (ldexp() would set
 * errno.) */
static inline double rw_scaled_value(rw_scaled s)
{
    if (s.exponent > 1024)
        return NAN;
    if (s.exponent < -1100)
        return 0;
    const int half = s.exponent / 2;
    return s.mantissa * rw_power_of_two(half) * rw_power_of_two(s.exponent - half);
}

#endif
