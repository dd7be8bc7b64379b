/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contours of values on a grid, as closed loops that can be filled: where a contour meets the
 * grid's border it goes on along the border, around the higher values. */
#ifndef CLI_CONTOUR_H
#define CLI_CONTOUR_H

#include <stdbool.h>
#include <stddef.h>

typedef struct {
    int columns, rows;
    const double *x, *y; /* of the columns and the rows, ascending */
    const double *value; /* row by row, finite */
} contour_grid;

typedef struct {
    double x, y;
    bool on_border;
} contour_point;

/* One loop: higher values are inside, or outside for a hole. */
typedef struct {
    int level; /* as the caller counts */
    bool hole;
    double area;
    contour_point *point;
    size_t count;
} contour_loop;

typedef struct {
    contour_loop *loop;
    size_t count;
} contour_loops;

/* Adds the loops of a level. False where memory runs out. */
bool contour_trace(const contour_grid *grid, double height, int level, contour_loops *loops);

/* The larger ones first, so that each can be painted over those it lies in. */
void contour_sort(contour_loops *loops);
void contour_free(contour_loops *loops);

#endif
