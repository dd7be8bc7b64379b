/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses on a grid below the surface, as rows. */
#ifndef CLI_GRID_H
#define CLI_GRID_H

#include "number/range.h"
#include "rows/records.h"
#include "contact/loaded_contact.h"
#include "model/tensor.h"

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
