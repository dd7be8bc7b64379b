/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Integrals for the tests: the routes to the library's numbers that use none of its closed
 * forms. */
#ifndef QUADRATURE_H
#define QUADRATURE_H

#include <stddef.h>

typedef double (*integrand)(double t, void *context);

/* int f over the pieces between n+1 <= 64 points, in any order; ends of pieces may be integrably
 * singular. To about 1e-13 relative. */
double integral(integrand f, const void *context, size_t n, const double points[]);

/* Cauchy principal value of int f(t)/(t-x) dt over [a, b], a < x < b. */
double principal_value(integrand f, const void *context, double a, double b, double x);

#endif
