/* SPDX-License-Identifier: GPL-3.0-or-later */
/* This uses LAPACK's dgelsd, which works by singular values and tells the rank. dgels would report
 * success on columns that are nearly dependent. The reference LAPACK ends the process on a bad
 * argument, and takes NaN for a number. So the caller must check the arguments. */
#include "base/least_squares.h"

#include "base/always.h"
#include "rwedge.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/* Fortran's calling convention for LP64, as in every LAPACK of the distributions: all by
 * reference. */
void dgelsd_(const int32_t *m, const int32_t *n, const int32_t *nrhs, double *a, const int32_t *lda,
             double *b, const int32_t *ldb, double *s, const double *rcond, int32_t *rank,
             double *work, const int32_t *lwork, int32_t *iwork, int32_t *info);

int32_t rw_least_squares(int32_t rows, int32_t columns, double *A, double *v)
{
    const int32_t right_sides = 1;
    const double condition = sqrt(DBL_EPSILON);
    int32_t rank = 0, info = 0, integer_size = 0, query = -1;
    double size = 0, unused = 0;
    dgelsd_(&rows, &columns, &right_sides, A, &rows, v, &rows, &unused, &condition, &rank, &size,
            &query, &integer_size, &info);
    /* never: the sizes are sound, and the work for 2^27 entries is not more than INT32_MAX */
    if (NEVER(info != 0 || !(size >= 1 && size <= INT32_MAX)))
        return RWEDGE_ENOCONV;
    const int32_t length = (int32_t)size;
    double *work = malloc(((size_t)length + (size_t)columns) * sizeof *work);
    /* an old LAPACK may leave the size 0 */
    const size_t integer_count = ALWAYS(integer_size > 0) ? (size_t)integer_size : 1;
    int32_t *integers = malloc(integer_count * sizeof *integers);
    int32_t status = RWEDGE_ENOMEM;
    if (work && integers) {
        dgelsd_(&rows, &columns, &right_sides, A, &rows, v, &rows, work + length, &condition, &rank,
                work, &length, integers, &info);
        /* no finite matrix is known whose singular values do not converge */
        status = NEVER(info != 0) ? RWEDGE_ENOCONV : rank < columns ? RWEDGE_ERANK : RWEDGE_OK;
    }
    free(integers);
    free(work);
    return status;
}
