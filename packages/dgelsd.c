/* SPDX-License-Identifier: GPL-3.0-or-later */
/* LAPACK's dgelsd, as far as lib/base/least_squares.c calls it, by GSL's singular values: for
 * WebAssembly and macOS, as LAPACK is Fortran and no Fortran compiler for them is here. A = U S V',
 * and the solution of least length is x = V S^-1 U' b without the singular values below rcond times
 * the largest. */
#include <gsl/gsl_blas.h>
#include <gsl/gsl_linalg.h>
#include <stdint.h>
#include <stdlib.h>

void dgelsd_(const int32_t *m, const int32_t *n, const int32_t *nrhs, double *a, const int32_t *lda,
             double *b, const int32_t *ldb, double *s, const double *rcond, int32_t *rank,
             double *work, const int32_t *lwork, int32_t *iwork, int32_t *info);
void cblas_xerbla(int argument, const char *routine, const char *form, ...);

/* GSL's would print and end the program. */
void cblas_xerbla(int argument, const char *routine, const char *form, ...)
{
    (void)argument;
    (void)routine;
    (void)form;
}

/* The sizes of the work: GSL wants V, n by n; A's rows one after the other; and a vector. */
static void tell_sizes(size_t m, size_t n, double *work, int32_t *iwork)
{
    work[0] = (double)(n * n + m * n + n);
    iwork[0] = 1;
}

void dgelsd_(const int32_t *m, const int32_t *n, const int32_t *nrhs, double *a, const int32_t *lda,
             double *b, const int32_t *ldb, double *s, const double *rcond, int32_t *rank,
             double *work, const int32_t *lwork, int32_t *iwork, int32_t *info)
{
    const size_t rows = (size_t)*m, columns = (size_t)*n;
    (void)nrhs; /* 1 */
    (void)ldb;
    *info = 0;
    if (*lwork == -1) {
        tell_sizes(rows, columns, work, iwork);
        return;
    }
    gsl_matrix_view V = gsl_matrix_view_array(work, columns, columns);
    gsl_matrix_view U = gsl_matrix_view_array(work + columns * columns, rows, columns);
    gsl_vector_view turned = gsl_vector_view_array(work + columns * (columns + rows), columns);
    gsl_vector_view S = gsl_vector_view_array(s, columns), right = gsl_vector_view_array(b, rows);
    for (size_t i = 0; i < rows; i++)
        for (size_t j = 0; j < columns; j++)
            gsl_matrix_set(&U.matrix, i, j, a[i + j * (size_t)*lda]);
    if (gsl_linalg_SV_decomp_jacobi(&U.matrix, &V.matrix, &S.vector) != GSL_SUCCESS) {
        *info = 1;
        return;
    }
    gsl_blas_dgemv(CblasTrans, 1, &U.matrix, &right.vector, 0, &turned.vector);
    *rank = 0;
    for (size_t j = 0; j < columns; j++) {
        const int counts = s[j] > *rcond * s[0];
        *rank += counts;
        gsl_vector_set(&turned.vector, j, counts ? gsl_vector_get(&turned.vector, j) / s[j] : 0);
    }
    gsl_vector_view solution = gsl_vector_view_array(b, columns);
    gsl_blas_dgemv(CblasNoTrans, 1, &V.matrix, &turned.vector, 0, &solution.vector);
}
