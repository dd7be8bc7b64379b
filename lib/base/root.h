/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Roots and integrals of functions of one variable. */
#ifndef RW_ROOT_H
#define RW_ROOT_H

/* A function of one variable and whatever else it needs; finite on the bracket. */
typedef double (*rw_function)(double x, const void *context);

/* A root of f in [lo, hi], to the last bits of x or to the absolute error `nearest`, whichever
 * is larger (0 where no root is near 0). NaN where f(lo) and f(hi) are of one sign, or not
 * finite. */
double rw_root(rw_function f, const void *context, double lo, double hi, double nearest);

/* Gauss's nodes and weights for 0 to 1; n is 4, 8 or 16. */
void rw_gauss(int n, double node[], double weight[]);

/* The midpoint rule of n points in the angle, 0 to pi, of a circle over the interval from 0 to 1:
 * for functions like square roots at both ends. */
void rw_half_circle(int n, double node[], double weight[]);

/* The integral of f over [lo, hi] by Gauss and Legendre with 16 points. It is exact for polynomials
 * of degree 31. It is exact to the last bits if the nearest singularity of f is at least half the
 * length of the interval away from it. */
double rw_integral(rw_function f, const void *context, double lo, double hi);

#endif
