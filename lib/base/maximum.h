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

/* The top of a function around a place. `at` are three places in ascending order with the values
 * there, or in descending order; the middle one is the highest, or as high as another, and may be
 * the first or the last place too. The place of the top is found to the part `nearest` of their
 * distance, RW_NEAREST_TOP or more, or as well as values tell it, whichever is more. The function
 * is >= 0; where it is not finite it has no top. A top that will not reach the value `highest` is
 * given up. */
#define RW_NEAREST_TOP 1e-8
rw_maximum rw_top(rw_function f, const void *context, const rw_maximum at[3], double nearest,
                  double highest);

/* The largest value of a function, at n >= 1 places in ascending order, whose values are given, or
 * between the neighbours of one of them: the best is searched, and others that are tops and nearly
 * as high, as rw_top() does. The first of equal values counts. */
rw_maximum rw_largest_around(rw_function f, const void *context, size_t n, const double place[],
                             const double value[]);

/* The same; the values are computed into `value`, room for n numbers. */
rw_maximum rw_largest_value(rw_function f, const void *context, size_t n, const double place[],
                            double value[]);

#endif
