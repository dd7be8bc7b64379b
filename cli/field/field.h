/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_FIELD_H
#define CLI_FIELD_H

#include "rows/rows.h"
#include "setup/setup.h"

/* ---- vtk ---- Stresses, or other numbers, at points as a file for ParaView. */

/* Points with so many numbers each, and the names of these. */
typedef struct {
    const char *title;
    size_t count, columns; /* row by row where they are a grid; 0 columns where they are none */
    const double *x, *y;
    bool has_tensor; /* of stresses, whose numbers are those of a tensor */
    int numbers;
    const char *names[TENSOR_COUNT + 32];
    const double *value; /* the numbers of a point, then those of the next */
} vtk_points;

/* The numbers of the points are stresses. */
void vtk_of_stresses(vtk_points *points);

/* A rows_writer: legacy VTK, ASCII. The records say only where it goes, and with how many
 * digits. */
void vtk_write(void *of_points, records *rows);

#endif
