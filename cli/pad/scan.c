/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pad.h"

#include "text/text.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
    double x, value;
    int64_t line;
} place;

/* Places are in the order of x; at the same x lines stay in their order: slopes ascend, as they
 * must. */
static int compare(const void *of_a, const void *of_b)
{
    const place *a = of_a, *b = of_b;
    if (a->x != b->x)
        return a->x < b->x ? -1 : 1;
    return a->line < b->line ? -1 : a->line > b->line;
}

static int compare_slopes(const void *of_a, const void *of_b)
{
    const place *a = of_a, *b = of_b;
    if (a->x == b->x && a->value != b->value)
        return a->value < b->value ? -1 : 1;
    return compare(a, b);
}

static bool is_in_order(const scan *all)
{
    for (size_t i = 1; i < all->count; i++)
        if (all->x[i] < all->x[i - 1])
            return false;
    return true;
}

static void sort(scan *all, bool are_heights)
{
    place *places = memory_zeroed(all->count, sizeof *places);
    for (size_t i = 0; i < all->count; i++)
        places[i] = (place){all->x[i], all->value[i], all->line[i]};
    qsort(places, all->count, sizeof *places, are_heights ? compare : compare_slopes);
    for (size_t i = 0; i < all->count; i++) {
        all->x[i] = places[i].x;
        all->value[i] = places[i].value;
        all->line[i] = places[i].line;
    }
    free(places);
}

/* Equal places become one. */
static size_t take_means(scan *all)
{
    size_t kept = 0, means = 0;
    for (size_t i = 0, end; i < all->count; i = end, kept++) {
        double sum = 0;
        for (end = i; end < all->count && all->x[end] == all->x[i]; end++)
            sum += all->value[end];
        all->x[kept] = all->x[i];
        all->value[kept] = end == i + 1 ? all->value[i] : sum / (double)(end - i);
        all->line[kept] = all->line[i];
        means += end > i + 1 ? 1 : 0;
    }
    all->count = kept;
    return means;
}

size_t scan_settle(scan *all, bool are_heights)
{
    if (!is_in_order(all))
        sort(all, are_heights);
    return are_heights ? take_means(all) : 0;
}
