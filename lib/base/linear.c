/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/linear.h"

#include "base/processor.h"

#include <float.h>
#include <math.h>

static void swap(size_t n, double row[], double other[])
{
    for (size_t j = 0; j < n; j++) {
        const double kept = row[j];
        row[j] = other[j];
        other[j] = kept;
    }
}

/* Rows below the pivot are swapped for the largest. */
static bool pivot(size_t n, size_t sides, double A[], double b[], size_t k)
{
    size_t best = k;
    for (size_t i = k + 1; i < n; i++)
        if (fabs(A[i * n + k]) > fabs(A[best * n + k]))
            best = i;
    const double size = fabs(A[best * n + k]);
    if (!(isgreater(size, DBL_MIN) && isless(size, HUGE_VAL)))
        return false;
    if (best != k) {
        swap(n, A + best * n, A + k * n);
        swap(sides, b + best * sides, b + k * sides);
    }
    return true;
}

RW_INLINE void subtract(size_t n, double factor, const double *restrict row, double *restrict from)
{
    for (size_t j = 0; j < n; j++)
        from[j] -= factor * row[j];
}

/* How many numbers of a row are not 0 behind them: of two systems in one, half of a row. */
RW_INLINE size_t width_of(size_t n, const double row[])
{
    while (n > 0 && row[n - 1] == 0)
        n--;
    return n;
}

/* From the last row upwards. */
static bool substitute(size_t n, size_t sides, const double A[], double b[])
{
    for (size_t k = n; k-- > 0;) {
        for (size_t j = k + 1; j < n; j++)
            if (A[k * n + j] != 0) /* as above */
                subtract(sides, A[k * n + j], b + j * sides, b + k * sides);
        for (size_t side = 0; side < sides; side++) {
            b[k * sides + side] /= A[k * n + k];
            if (!isfinite(b[k * sides + side]))
                return false;
        }
    }
    return true;
}

/* The unknown k out of the rows below its own. */
RW_INLINE void eliminate_below(size_t n, size_t sides, double A[], double b[], size_t k)
{
    const size_t width = width_of(n - k, A + k * n + k);
    for (size_t i = k + 1; i < n; i++) {
        const double factor = A[i * n + k] / A[k * n + k];
        if (factor == 0)
            continue; /* of two systems in one, as of a normal crack: half of all rows */
        subtract(width, factor, A + k * n + k, A + i * n + k);
        subtract(sides, factor, b + k * sides, b + i * sides);
    }
}

RW_DISPATCH(eliminate, eliminate_below, (size_t n, size_t sides, double A[], double b[], size_t k),
            (n, sides, A, b, k))

bool rw_solve(size_t n, size_t sides, double A[], double b[])
{
    for (size_t k = 0; k < n; k++) {
        if (!pivot(n, sides, A, b, k))
            return false;
        eliminate(n, sides, A, b, k);
    }
    return substitute(n, sides, A, b);
}

double rw_dot(size_t n, const double x[], const double y[])
{
    double s0 = 0, s1 = 0, s2 = 0, s3 = 0;
    size_t i = 0;
    for (; i + 4 <= n; i += 4) {
        s0 += x[i] * y[i];
        s1 += x[i + 1] * y[i + 1];
        s2 += x[i + 2] * y[i + 2];
        s3 += x[i + 3] * y[i + 3];
    }
    for (; i < n; i++)
        s0 += x[i] * y[i];
    return (s0 + s1) + (s2 + s3);
}

/* Column by column: a processor works at several rows at a time. */
bool rw_cholesky(size_t n, double A[])
{
    for (size_t j = 0; j < n; j++) {
        double *row = A + j * n;
        const double rest = row[j] - rw_dot(j, row, row);
        if (!isgreater(rest, 0))
            return false;
        row[j] = sqrt(rest);
        for (size_t i = j + 1; i < n; i++)
            A[i * n + j] = (A[i * n + j] - rw_dot(j, A + i * n, row)) / row[j];
    }
    return true;
}

void rw_cholesky_solve(size_t n, const double L[], double b[])
{
    for (size_t i = 0; i < n; i++)
        b[i] = (b[i] - rw_dot(i, L + i * n, b)) / L[i * n + i];
    for (size_t i = n; i-- > 0;) {
        b[i] /= L[i * n + i];
        for (size_t j = 0; j < i; j++)
            b[j] -= L[i * n + j] * b[i];
    }
}
