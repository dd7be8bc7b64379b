/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Another math library: every second result is one unit of the last place larger.
 * reproducible.sh includes it before each source of the library. */
#ifndef OTHER_LIBM_H
#define OTHER_LIBM_H

#include <math.h>
#include <stdint.h>
#include <string.h>

static inline double unit_larger(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    bits += bits & 1;
    memcpy(&value, &bits, sizeof bits);
    return value;
}

#define acos(x) unit_larger(acos(x))
#define asin(x) unit_larger(asin(x))
#define asinh(x) unit_larger(asinh(x))
#define atan(x) unit_larger(atan(x))
#define atan2(y, x) unit_larger(atan2(y, x))
#define cos(x) unit_larger(cos(x))
#define cosh(x) unit_larger(cosh(x))
#define exp(x) unit_larger(exp(x))
#define hypot(x, y) unit_larger(hypot(x, y))
#define log(x) unit_larger(log(x))
#define log10(x) unit_larger(log10(x))
#define log1p(x) unit_larger(log1p(x))
#define pow(x, y) unit_larger(pow(x, y))
#define sin(x) unit_larger(sin(x))
#define sinh(x) unit_larger(sinh(x))
#define tan(x) unit_larger(tan(x))
#define tanh(x) unit_larger(tanh(x))

#endif
