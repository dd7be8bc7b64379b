/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cells of a contact that grows, and what they carry. They are finest where the bodies touch
 * first. */
#ifndef RW_GROWING_CELLS_H
#define RW_GROWING_CELLS_H

#include "formulas/patch.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct {
    double f, start, scale; /* where cells are finest, and by how much */
    size_t before;          /* cells to the left of that */
    size_t count, from, to; /* all cells; those in contact at the end: from <= i < to */
    double *end;            /* of cells, count + 1 */
    double *x, *N, *t;      /* middles; pressure and shear of cells */
    double *slip;           /* since a cell came into contact, over theta */
    int *label;             /* 0 where a cell sticks, else the sign of t */
    double energy;
} rw_growth;

/* So many cells without traction on a patch with the start in it. false where memory is short. */
bool rw_growth_cells(rw_growth *growth, double f, size_t count, double start, rw_patch all);
void rw_growth_destroy(rw_growth *growth);

/* Shear over friction, and slip, at a place. */
double rw_growth_ratio(const rw_growth *growth, double x);
double rw_growth_slip(const rw_growth *growth, double x);

#endif
