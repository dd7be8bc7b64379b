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

/* The largest value of a function, >= 0, at n >= 1 places in ascending order, or between the
 * neighbours of one of them: the best is searched, and others that are tops and nearly as high. The
 * place is found to 1e-10 of the neighbours' distance, or as well as values tell it, whichever is
 * more. The first of equal values counts. `value` is room for n numbers. */
rw_maximum rw_largest_value(rw_function f, const void *context, size_t n, const double place[],
                            double value[]);

#endif
