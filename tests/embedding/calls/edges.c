/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "calls.h"

#include <float.h>
#include <math.h>

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

static const double anything[] = {
    0,          -0.0,
    5e-324,     1e-310,
    1e-200,     9.9e-61,
    1e-60,      3e-60,
    1e-40,      1e-16,
    1e-14,      9.9e-15,
    3e-9,       1e-6,
    1e-3,       0.01,
    0.1,        0.25,
    0.3,        0.3605,
    0.5,        0.5 - DBL_EPSILON / 4,
    0.5 - 1e-9, 0.5 + DBL_EPSILON,
    0.9999,     1 - DBL_EPSILON / 2,
    1,          1 + DBL_EPSILON,
    1.5,        2,
    2.5,        100,
    1e5,        1e6,
    1.1e8,      1e10,
    1e18,       1e30,
    1e60,       1.1e60,
    1e200,      DBL_MAX,
    INFINITY,   NAN,
    -5e-324,    -1e-300,
    -1e-60,     -1e-9,
    -0.3,       -0.9999,
    -1,         -1 + DBL_EPSILON,
    -2,         -1e9,
    -DBL_MAX,   -INFINITY,
};

static const double numbers[] = {0,     1,       2,          3,         7,  50,       1001,
                                 65535, 1 << 20, 1073741823, INT32_MAX, -1, INT32_MIN};

size_t edge_count(const entry_argument *a)
{
    return a == &which_object ? COMPUTED : a->whole ? COUNT(numbers) : COUNT(anything);
}

double edge(const entry_argument *a, size_t i)
{
    return a == &which_object ? (double)i : a->whole ? numbers[i] : anything[i];
}
