/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gauss-Legendre quadrature of fixed order. It allocates nothing, and cannot fail. */
#ifndef RW_INTEGRAL_H
#define RW_INTEGRAL_H

#include "base/root.h"

/* The integral of f over [lo, hi] with 16 points. It is exact for polynomials of degree 31. It is
 * exact to the last bits if the nearest singularity of f is at least half the length of the
 * interval away from it. */
double rw_integral(rw_function f, const void *context, double lo, double hi);

#endif
