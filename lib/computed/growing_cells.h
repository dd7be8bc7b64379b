/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A contact of unlike bodies that grows from touching on, along a straight line of its loads. Each
 * part of the way adds the tractions of a flat punch as wide as the contact is then, under dP, dQ,
 * dM or no rotation, and d(stretch). Most of it is bonded; at its edges it slips, where the change
 * of the shear is f times that of the pressure. Tractions are constant over cells, and the
 * contact grows to the next cell, wherever that closes first: so no place comes into contact within
 * a step. Cells are finest where the bodies touch first. */
#ifndef RW_GROWING_CELLS_H
#define RW_GROWING_CELLS_H

#include "numerical/step.h"

#include <stdint.h>

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

/* From touching under `from` to the loads `to`, with about so many cells in contact at the end.
 * RWEDGE_ENOMEM; RWEDGE_ENOCONV where the contact does not grow all the way; then there is nothing
 * to destroy. */
int32_t rw_growth_create(rw_growth *growth, const rw_frame *frame, rw_scaled_loads from,
                         rw_scaled_loads to, size_t cells);
void rw_growth_destroy(rw_growth *growth);

/* Shear over friction, and slip, at a place. */
double rw_growth_ratio(const rw_growth *growth, double x);
double rw_growth_slip(const rw_growth *growth, double x);

#endif
