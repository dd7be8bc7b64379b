/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef RW_PROFILE_H
#define RW_PROFILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* ---- hull ---- */

enum { RW_MOST_HEIGHTS = 1 << 24 };

/* Whether places ascend, and all numbers are in their domain; `apart` allows no equal places. */
bool rw_are_heights(size_t n, const double x[], const double height[], bool apart);

/* The places on the lower convex hull, from left to right; how many there are. */
size_t rw_hull(size_t n, const double x[], const double h[], size_t corner[]);

/* ---- compressed ---- Heights as equations for a parabola: those of a range of cells are three
 * rows, whatever their number, by orthogonal transformations. */

enum { RW_CELLS = 1 << 13 };

/* c0 + c1 t + c2 t^2 = h: three equations, row k without the unknowns before k, and the sum of the
 * squares that no parabola can reduce. */
typedef struct {
    double row[3][4], rest;
} rw_equations;

/* A tree over the cells, which divide -1 < t < 1. */
typedef struct {
    rw_equations node[2 * RW_CELLS];
} rw_compressed;

/* Compresses n heights at t, in units of their own. */
void rw_compress(size_t n, const double t[], const double h[], rw_compressed *all);

/* The equations of the cells from `first` on, before `end`. */
rw_equations rw_compressed_range(const rw_compressed *all, size_t first, size_t end);

/* ---- nonnegative ---- */

enum { RW_MOST_ARCS = 16, RW_MOST_ROWS = 3 * RW_MOST_ARCS, RW_MOST_COLUMNS = RW_MOST_ARCS + 2 };

/* Minimises |A u - v|; the unknowns from `free` on must not be negative. A is rows x columns,
 * column by column, the columns of length 1. RWEDGE_ERANK where a solve has no one answer,
 * RWEDGE_ENOMEM, RWEDGE_ENOCONV. */
int32_t rw_nonnegative(int32_t rows, int32_t columns, int32_t free_count, const double *A,
                       const double *v, double u[], double *square);

/* ---- knots ---- */

/* Arcs between knots, which are whole numbers of cells: slope and level at t = -1, the rate of the
 * slope on each arc, and the sum of squares that is left. A straight arc has the rate 0, whatever
 * the heights. */
typedef struct {
    int32_t arcs, knot[RW_MOST_ARCS + 1];
    bool is_straight[RW_MOST_ARCS];
    double level, slope, rate[RW_MOST_ARCS], square;
} rw_arcs;

/* The arcs that fit n heights best: so many, or, where `arcs` is 0, as many as Schwarz's criterion
 * asks for, at most `most`. */
int32_t rw_fit_arcs(const rw_compressed *all, size_t n, int32_t arcs, int32_t most, rw_arcs *best);

#endif
