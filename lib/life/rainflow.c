/* SPDX-License-Identifier: GPL-3.0-or-later */
/* ASTM E1049-85, 5.4.4 and, for a history that repeats, 5.4.5. The turns that no cycle has taken
 * wait on a stack. Each value of the history is put on it: a value that goes on in the direction of
 * the last one replaces it; a value that comes back to the turn before the last one, or beyond it,
 * closes the cycle of these two. Values are compared and not ranges: a range is rounded. */
#include "life/rainflow.h"

#include "base/domain.h"
#include "base/select.h"
#include "rwedge.h"

#include <stdlib.h>

typedef struct {
    rw_reversal *turn; /* the first that waits */
    size_t count, cycles;
    rw_counted_cycle *cycle;
    bool repeats;
} rainflow;

static double range_of(const rw_reversal *turn)
{
    return fabs(turn[1].value - turn[0].value);
}

/* Counts the cycle from a turn to the next one; `highest` is the highest value of the other
 * quantity in it. */
static void add_cycle(rainflow *r, const rw_reversal *turn, double count, double highest)
{
    r->cycle[r->cycles++] = (rw_counted_cycle){turn->at, range_of(turn),
                                               (turn[0].value + turn[1].value) / 2, count, highest};
}

/* Removes the last turn from the stack. The highest value since it passes to the turn below. */
static void drop_last(rainflow *r)
{
    const rw_reversal *last = &r->turn[--r->count];
    if (r->count > 0)
        r->turn[r->count - 1].highest = rw_larger(r->turn[r->count - 1].highest, last->highest);
}

static void add_half(rainflow *r)
{
    add_cycle(r, r->turn, 0.5, rw_larger(r->turn[0].highest, r->turn[1].own));
    r->turn++;
    r->count--;
}

/* Closes the cycle of the last two turns, on the straight way between two values of the history. */
static void close_last(rainflow *r, const rw_reversal *before, const rw_reversal *next)
{
    const rw_reversal *from = &r->turn[r->count - 2];
    const double way = (from->value - before->value) / (next->value - before->value);
    const double there = before->own + way * (next->own - before->own);
    add_cycle(r, from, 1, rw_larger(there, rw_larger(from[0].highest, from[1].highest)));
    drop_last(r);
    drop_last(r);
}

static bool goes_on(const rainflow *r, double value)
{
    if (r->count < 2)
        return false;
    const double before = r->turn[r->count - 2].value, last = r->turn[r->count - 1].value;
    return last > before ? value > last : value < last;
}

/* Whether a value comes back to the turn before the last one. */
static bool comes_back(const rainflow *r, double value)
{
    if (r->count < 2)
        return false;
    const double from = r->turn[r->count - 2].value, last = r->turn[r->count - 1].value;
    return from > last ? value >= from : value <= from;
}

static void push(rainflow *r, rw_reversal next)
{
    const rw_reversal before = r->count > 0 ? r->turn[r->count - 1] : next;
    if (r->count > 0 && next.value == before.value) {
        r->turn[r->count - 1].highest = rw_larger(before.highest, next.own);
        r->turn[r->count - 1].own = next.own;
        return;
    }
    if (goes_on(r, next.value))
        drop_last(r);
    while (comes_back(r, next.value)) {
        if (r->count == 2 && !r->repeats)
            add_half(r);
        else
            close_last(r, &before, &next);
    }
    r->turn[r->count++] = next;
}

static size_t largest(size_t n, const double value[])
{
    size_t best = 0;
    for (size_t i = 1; i < n; i++)
        best = value[i] > value[best] ? i : best;
    return best;
}

size_t rw_rainflow(size_t n, const double value[], const double other[], bool repeats,
                   rw_reversal stack[], rw_counted_cycle cycles[])
{
    rainflow r = {stack, 0, 0, cycles, repeats};
    const size_t start = repeats ? largest(n, value) : 0, last = start + n + (repeats ? 1 : 0);
    for (size_t k = start; k < last; k++) {
        const size_t i = k < n ? k : k - n;
        push(&r, (rw_reversal){i, value[i], other[i], other[i]});
    }
    while (r.count >= 2)
        add_half(&r);
    return r.cycles;
}

static int32_t status_of(size_t n, const double value[], int32_t repeats)
{
    if (n == 0 || n > SIZE_MAX / (sizeof(rw_reversal) + sizeof(rw_counted_cycle)) - 1)
        return RWEDGE_ERANGE;
    for (size_t i = 0; i < n; i++)
        if (!rw_is_stress(value[i]))
            return RWEDGE_EDOMAIN;
    return repeats >= 0 && repeats <= 1 ? RWEDGE_OK : RWEDGE_EDOMAIN;
}

int32_t rwedge_rainflow(size_t n, const double value[], int32_t repeats, double range[],
                        double mean[], double count[])
{
    if (!value || !range || !mean || !count)
        return RWEDGE_ENULL;
    const int32_t status = status_of(n, value, repeats);
    if (status != RWEDGE_OK)
        return status;
    rw_reversal *stack = malloc((n + 1) * sizeof *stack);
    rw_counted_cycle *cycles = malloc(n * sizeof *cycles);
    if (stack && cycles) {
        const size_t counted = rw_rainflow(n, value, value, repeats != 0, stack, cycles);
        for (size_t i = 0; i < n; i++)
            range[i] = mean[i] = count[i] = 0;
        for (size_t k = 0; k < counted; k++) {
            const size_t i = cycles[k].from;
            range[i] = cycles[k].range, mean[i] = cycles[k].mean, count[i] = cycles[k].count;
        }
    }
    const bool has_room = stack && cycles;
    free(stack);
    free(cycles);
    return has_room ? RWEDGE_OK : RWEDGE_ENOMEM;
}
