/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gauss-Legendre quadrature of fixed order: nothing to allocate, nothing that can fail. */
#ifndef RW_INTEGRAL_H
#define RW_INTEGRAL_H

#include "base/root.h"

/* The integral of f over [lo, hi] with 16 points: exact for degree 31, and to the last bits
 * where the nearest singularity of f is half the interval's length away from it, or more. */
double rw_integral(rw_function f, const void *context, double lo, double hi);

#endif
