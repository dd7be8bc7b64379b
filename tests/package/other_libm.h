/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Another math library: every second result is one unit of the last place larger.
 * reproducible.sh includes it before each source of the library. */
#ifndef OTHER_LIBM_H
#define OTHER_LIBM_H

#include <math.h>
#include <stdint.h>
#include <string.h>

static inline double other(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    bits += bits & 1;
    memcpy(&value, &bits, sizeof bits);
    return value;
}

#define acos(x) other(acos(x))
#define asin(x) other(asin(x))
#define asinh(x) other(asinh(x))
#define atan(x) other(atan(x))
#define atan2(y, x) other(atan2(y, x))
#define cos(x) other(cos(x))
#define cosh(x) other(cosh(x))
#define exp(x) other(exp(x))
#define hypot(x, y) other(hypot(x, y))
#define log(x) other(log(x))
#define log1p(x) other(log1p(x))
#define pow(x, y) other(pow(x, y))
#define sin(x) other(sin(x))
#define sinh(x) other(sinh(x))
#define tan(x) other(tan(x))
#define tanh(x) other(tanh(x))

#endif
