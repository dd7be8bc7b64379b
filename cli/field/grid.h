/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses on a grid below the surface, as rows. */
#ifndef CLI_GRID_H
#define CLI_GRID_H

#include "text/range.h"
#include "rows/records.h"
#include "contact/state.h"

enum { GRID_SXX, GRID_SYY, GRID_TXY, GRID_VON_MISES, GRID_S1, GRID_COUNT };
extern const char *const grid_quantities[GRID_COUNT];

typedef struct {
    contact_state state;
    range x, y;
} grid;

int64_t grid_size(const grid *what);

/* The quantities at the point (x, y); NAN where they are infinite. False, with the reason said. */
bool grid_compute(const grid *what, double x, double y, double quantity[GRID_COUNT]);

/* A row for every point, x fastest. */
bool grid_write_rows(void *of_grid, records *rows, bool show_progress);

#endif
