/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_FIELD_H
#define CLI_FIELD_H

#include "rows/rows.h"
#include "setup/setup.h"

/* ---- vtk ---- Stresses, or other numbers, at points as a file for ParaView. */

/* Points, row by row: those of a grid, or of a single row, wherever each is; and so many numbers of
 * each, with their names. */
typedef struct {
    const char *title;
    bool is_grid, has_tensor; /* of stresses, whose numbers are those of a tensor */
    int64_t columns, rows;
    int count;
    const char *names[TENSOR_COUNT + 32];
    double (*x)(const void *source, int64_t column);
    double (*y)(const void *source, int64_t row); /* of a grid; else of the point in that column */
    void (*numbers)(const void *source, int64_t column, int64_t row, double value[]);
    const void *source;
} vtk_points;

/* The numbers of the points are stresses. */
void vtk_of_stresses(vtk_points *points);

/* A rows_writer: legacy VTK, ASCII. The records say only where it goes, and with how many
 * digits. */
void vtk_write(void *of_points, records *rows);

#endif
