/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_FIELD_H
#define CLI_FIELD_H

#include "rows/rows.h"
#include "setup/setup.h"

/* ---- vtk ---- Stresses, or other numbers, at points as a file for ParaView. */

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

/* ---- grid ---- Stresses on a grid below the surface, as rows. */

typedef struct {
    loaded_contact loaded;
    range x, y;
} grid;

int64_t grid_size(const grid *points);

/* A row for every point, x fastest. */
void grid_write_rows(void *of_grid, records *rows);

/* The same as a file for ParaView. */
void grid_write_vtk(void *of_grid, records *rows);

#endif
