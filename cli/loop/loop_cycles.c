/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "loop.h"

#include <math.h>
#include <stdlib.h>

/* A log that ends where it begins is one cycle. */
static const double CLOSED = 0.05, /* of the range of the displacement */
    WELL_BELOW = 0.1;              /* the middle: noise there is no crossing */

typedef struct {
    double middle, range;
} span;

static span span_of(size_t count, const load row[])
{
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (size_t i = 0; i < count; i++) {
        least = fmin(least, row[i].displacement);
        most = fmax(most, row[i].displacement);
    }
    return (span){least / 2 + most / 2, most - least};
}

loop_cycles loop_cycles_find(size_t count, const load row[])
{
    const span all = span_of(count, row);
    loop_cycles cycles = {memory_zeroed(count + 2, sizeof *cycles.at), 0};
    bool is_below = false;
    for (size_t i = 0; i < count; i++) {
        const double above = row[i].displacement - all.middle;
        if (is_below && above >= 0)
            cycles.at[cycles.count++] = i;
        is_below = above < (is_below ? 0 : -WELL_BELOW * all.range);
    }
    const double open = row[count - 1].displacement - row[0].displacement;
    if (cycles.count < 2) {
        const bool is_closed = count > 3 && fabs(open) <= CLOSED * all.range;
        cycles.at[0] = 0;
        cycles.at[1] = count - 1;
        cycles.count = is_closed ? 2 : 0;
    }
    return cycles;
}

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
