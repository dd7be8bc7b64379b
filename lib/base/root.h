/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Root-finding in one dimension: the only room that sees GSL. */
#ifndef RW_ROOT_H
#define RW_ROOT_H

/* A function of one variable and whatever else it needs; finite on the bracket. */
typedef double (*rw_function)(double x, const void *context);

/* A root of f in [lo, hi], to the last bits of x or to the absolute error `nearest`, whichever
 * is larger (0 where no root is near 0). NaN where f(lo) and f(hi) are of one sign, or not
 * finite. */
double rw_root(rw_function f, const void *context, double lo, double hi, double nearest);

#endif
