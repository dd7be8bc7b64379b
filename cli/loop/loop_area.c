/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "loop.h"

#include <math.h>

/* The last row is joined to the first. */
double loop_area(const load row[], size_t from, size_t to)
{
    double area = 0;
    for (size_t i = from; i <= to; i++) {
        const load *next = &row[i < to ? i + 1 : from];
        area += (row[i].Q + next->Q) / 2 * (next->displacement - row[i].displacement);
    }
    return area;
}

double loop_area_noise(const load row[], size_t from, size_t to, double noise)
{
    double sum = 0;
    for (size_t i = from; i <= to; i++) {
        const double way =
            row[i < to ? i + 1 : from].displacement - row[i > from ? i - 1 : to].displacement;
        sum += way / 2 * (way / 2);
    }
    return noise * sqrt(sum);
}
