/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where a function of one variable is largest. */
#ifndef RW_MAXIMUM_H
#define RW_MAXIMUM_H

#include "base/root.h"

#include <stddef.h>

typedef struct {
    double x, value;
} rw_maximum;

/* Places between two others, dense at both. */
enum { RW_SPREAD = 65 };
void rw_spread_places(double left, double right, double place[RW_SPREAD]);

/* The largest value of a function, at n >= 1 places in ascending order, whose values are given, or
 * between the neighbours of one of them: the best is searched, and others that are tops and nearly
 * as high. A place is found to 1e-8 of the distance of its neighbours, or as well as values tell
 * it. The function is >= 0; where it is not finite it has no top. The first of equal values
 * counts. */
rw_maximum rw_largest_around(rw_function f, const void *context, size_t n, const double place[],
                             const double value[]);

/* The same; the values are computed into `value`, room for n numbers. */
rw_maximum rw_largest_value(rw_function f, const void *context, size_t n, const double place[],
                            double value[]);

#endif
