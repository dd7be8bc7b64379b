/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses, or other numbers, at points as a file for ParaView. */
#ifndef CLI_VTK_H
#define CLI_VTK_H

#include "model/tensor.h"
#include "rows/records.h"

/* So many numbers of a point, with their names. */
typedef struct {
    int count;
    const char *(*name)(const void *source, int number);
    double (*value)(const void *source, int64_t column, int64_t row, int number);
} vtk_numbers;

/* Points, row by row: those of a grid, or of a single row, wherever each is. */
typedef struct {
    const char *title;
    bool is_grid;
    int64_t columns, rows;
    double (*x)(const void *source, int64_t column);
    double (*y)(const void *source, int64_t row); /* of a grid; else of the point in that column */
    tensor (*stress)(const void *source, int64_t column, int64_t row);
    const vtk_numbers *numbers; /* in place of the stresses; NULL for none */
    const void *source;
} vtk_points;

/* A rows_writer of output_options.h: legacy VTK, ASCII. The records say only where it goes, and
 * with how many digits. */
void vtk_write(void *of_points, records *rows);

#endif
