/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Systems of linear equations, in place. They are small, or well conditioned; in
 * plain arithmetic they are the same bits on every machine, also where there is no LAPACK. */
#ifndef RW_LINEAR_H
#define RW_LINEAR_H

#include <stdbool.h>
#include <stddef.h>

/* A x = b by elimination, A of n rows of n, b of n rows of right-hand sides; x takes the place of
 * b. false where A is singular to rounding. */
bool rw_solve(size_t n, size_t sides, double A[], double b[]);

/* A = L L', A of n rows of n, symmetric and positive; L takes the place of its lower half. false
 * where A is not positive to rounding. */
bool rw_cholesky(size_t n, double A[]);

/* L L' x = b; x takes the place of b. */
void rw_cholesky_solve(size_t n, const double L[], double b[]);

/* The sum of the products, in four sums, which a processor does at the same time. */
double rw_dot(size_t n, const double x[], const double y[]);

#endif
