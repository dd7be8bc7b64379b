/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Functions with the names of GSL's and LAPACK's that do something else. A host may have such
 * functions in its address space. Preloaded, they take the place of those that the library calls.
 * */
#include <stdint.h>

int gsl_root_fsolver_set(void *solver, void *function, double lower, double upper);
int gsl_root_fsolver_iterate(void *solver);
int gsl_root_test_interval(double lower, double upper, double absolute, double relative);
void dgelsd_(const int64_t *m, const int64_t *n, const int64_t *columns, double *a,
             const int64_t *lda, double *b, const int64_t *ldb, double *s, const double *condition,
             int64_t *rank, double *work, const int64_t *lwork, int64_t *iwork, int64_t *info);

int gsl_root_fsolver_set(void *solver, void *function, double lower, double upper)
{
    (void)solver;
    (void)function;
    return lower < upper;
}

int gsl_root_fsolver_iterate(void *solver)
{
    (void)solver;
    return 1;
}

int gsl_root_test_interval(double lower, double upper, double absolute, double relative)
{
    return lower + upper < absolute + relative;
}

void dgelsd_(const int64_t *m, const int64_t *n, const int64_t *columns, double *a,
             const int64_t *lda, double *b, const int64_t *ldb, double *s, const double *condition,
             int64_t *rank, double *work, const int64_t *lwork, int64_t *iwork, int64_t *info)
{
    (void)m;
    (void)n;
    (void)columns;
    (void)a;
    (void)lda;
    (void)ldb;
    (void)s;
    (void)condition;
    (void)rank;
    (void)lwork;
    (void)iwork;
    b[0] = 1;
    work[0] = 1e3;
    *(int32_t *)info = 7;
}
