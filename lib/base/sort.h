/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef RW_SORT_H
#define RW_SORT_H

#include <stdlib.h>

static inline int rw_by_size(const void *a, const void *b)
{
    const double first = *(const double *)a, second = *(const double *)b;
    return (first > second) - (first < second);
}

/* The smallest first; none is NaN. */
static inline void rw_sort(double numbers[], size_t count)
{
    if (count > 0) /* qsort() takes no NULL */
        qsort(numbers, count, sizeof *numbers, rw_by_size);
}

#endif
