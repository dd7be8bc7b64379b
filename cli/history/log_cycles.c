/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "history.h"

#include <math.h>
#include <stdlib.h>

/* A log that ends where it begins is one cycle. */
static const double CLOSED = 0.05, /* of the range of what goes to and fro */
    WELL_BELOW = 0.1,              /* the middle: noise there is no crossing */
    REACHED = 1e-9;                /* the middle: a sine that ends below 0 by rounding ends there */

typedef struct {
    double middle, range;
} span;

static span span_of(size_t count, const load row[], load_part *part)
{
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (size_t i = 0; i < count; i++) {
        least = fmin(least, part(&row[i]));
        most = fmax(most, part(&row[i]));
    }
    return (span){least / 2 + most / 2, most - least};
}

log_cycles log_cycles_find(size_t count, const load row[], load_part *part)
{
    const span all = span_of(count, row, part);
    log_cycles cycles = {memory_zeroed(count + 2, sizeof *cycles.at), 0};
    const double reached = -REACHED * all.range;
    bool is_below = false;
    for (size_t i = 0; i < count; i++) {
        const double above = part(&row[i]) - all.middle;
        if (is_below && above >= reached)
            cycles.at[cycles.count++] = i;
        is_below = above < (is_below ? reached : -WELL_BELOW * all.range);
    }
    const double open = part(&row[count - 1]) - part(&row[0]);
    if (cycles.count < 2) {
        const bool is_closed = count > 3 && fabs(open) <= CLOSED * all.range;
        cycles.at[0] = 0;
        cycles.at[1] = count - 1;
        cycles.count = is_closed ? 2 : 0;
    }
    return cycles;
}

static double force(const load *at)
{
    return at->Q;
}

static double tension(const load *at)
{
    return at->sigma;
}

double load_displacement(const load *at)
{
    return at->displacement;
}

load_part *load_part_of_cycles(size_t count, const load row[])
{
    if (loads_are_driven(row, count))
        return load_displacement;
    return span_of(count, row, force).range > 0 ? force : tension;
}
