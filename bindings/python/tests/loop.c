/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the ufuncs are timed against: C's own loops over a formula. */
#include <stddef.h>

void loop_1(double (*formula)(double), size_t n, const double a[], double result[])
{
    for (size_t i = 0; i < n; i++)
        result[i] = formula(a[i]);
}

void loop_2(double (*formula)(double, double), size_t n, const double a[], const double b[],
            double result[])
{
    for (size_t i = 0; i < n; i++)
        result[i] = formula(a[i], b[i]);
}

void loop_3(double (*formula)(double, double, double), size_t n, const double a[], const double b[],
            const double c[], double result[])
{
    for (size_t i = 0; i < n; i++)
        result[i] = formula(a[i], b[i], c[i]);
}
