/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Linear least squares: the only room that sees LAPACK. */
#ifndef RW_LEAST_SQUARES_H
#define RW_LEAST_SQUARES_H

#include <stdint.h>

/* Minimises |A u - v| over u. A is rows x columns, column by column, rows >= columns >= 1, all
 * entries finite; A and v are overwritten, v[0 ... columns-1] with u. RWEDGE_ERANK where the
 * condition number of A exceeds 1/sqrt(epsilon), RWEDGE_ENOMEM, RWEDGE_ENOCONV. */
int32_t rw_least_squares(int32_t rows, int32_t columns, double *A, double *v);

#endif
