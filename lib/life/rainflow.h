/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cycles of a history by rainflow, and the highest of another quantity from where each begins to
 * where it closes. */
#ifndef RW_RAINFLOW_H
#define RW_RAINFLOW_H

#include <stdbool.h>
#include <stddef.h>

/* A turn of the history that no cycle has taken yet: its place in the history; the highest value of
 * the other quantity from there to before the next turn, and its last value at the turn. */
typedef struct {
    size_t at;
    double value, highest, own;
} rw_reversal;

/* from: where it begins; count: 1, or 1/2 for what is left over. */
typedef struct {
    size_t from;
    double range, mean, count, highest;
} rw_counted_cycle;

/* How many cycles n >= 1 values have, at most n of them; `other` is the quantity whose highest is
 * wanted. Both change straight from one value to the next. A history that repeats is counted from
 * its largest value to the same again, and nothing is left over. The stack has n + 1 turns,
 * `cycles` room for n. */
size_t rw_rainflow(size_t n, const double value[], const double other[], bool repeats,
                   rw_reversal stack[], rw_counted_cycle cycles[]);

#endif
