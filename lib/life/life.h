/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves of life over a parameter: sums of two powers of the number of reversals. */
#ifndef RW_LIFE_H
#define RW_LIFE_H

#include <stdbool.h>
#include <stdint.h>

/* first (2N)^slope + second (2N)^other; a run-out below the limit. */
typedef struct {
    double height[2], slope[2], limit; /* heights: the logarithms of first and second */
} rw_life_curve;

/* Whether the criterion has a curve, and all constants of its damage are in their ranges; sets the
 * curve if it is so. */
bool rw_life_curve_of(int32_t criterion, const double constants[], rw_life_curve *curve);

/* Cycles to failure at a value, which is 0 or positive: HUGE_VAL for a run-out and beyond 1e60, NaN
 * below 1e-60. */
double rw_life(const rw_life_curve *curve, double value);

/* Lines of a table of u = log(2N), and its rate from line to line, over the logarithm of the value.
 * Each is filled when it is first asked for; lines that are far apart share a place. */
enum { RW_LIFE_LINES = 1024 };
typedef struct {
    double place, u, rate;
} rw_life_line;
typedef struct {
    const rw_life_curve *curve;
    rw_life_line line[RW_LIFE_LINES];
} rw_life_table;
void rw_life_table_begin(const rw_life_curve *curve, rw_life_table *table);

/* The same by a table, for many lives: to 1e-5 for constants of metals, whose slopes are steeper
 * than -0.04; to 1e-2 for any constants. */
double rw_life_by_table(rw_life_table *table, double value);

#endif
