/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef RW_SORT_H
#define RW_SORT_H

#include <stdlib.h>

static inline int rw_by_size(const void *a, const void *b)
{
    const double first = *(const double *)a, second = *(const double *)b;
    return (first > second) - (first < second);
}

/* The smallest first; none is NaN. Of a few numbers, often in order already, each goes to its place
 * among those before it. */
static inline void rw_sort(double numbers[], size_t count)
{
    enum { FEW = 32 };
    if (count > FEW) {
        qsort(numbers, count, sizeof *numbers, rw_by_size);
        return;
    }
    for (size_t i = 1; i < count; i++) {
        const double number = numbers[i];
        size_t at = i;
        for (; at > 0 && numbers[at - 1] > number; at--)
            numbers[at] = numbers[at - 1];
        numbers[at] = number;
    }
}

#endif
