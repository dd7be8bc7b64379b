/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The potential of a patch of any pad: the sum of those of its arcs. */
#ifndef RW_PAD_POTENTIAL_H
#define RW_PAD_POTENTIAL_H

#include "formulas/pad.h"
#include "potential/eccentric.h"

typedef struct {
    double weight;
    rw_eccentric potential;
} rw_arc_potential;

/* Prepared for many places. */
typedef struct {
    rw_patch patch;
    size_t count;
    rw_arc_potential single; /* the wedge's: it takes no memory */
    rw_arc_potential *many;  /* of a pad; NULL for the wedge */
} rw_pad_potential;

/* false where memory is short; then there is nothing to destroy. */
bool rw_pad_potential_create(rw_pad_potential *potential, const rw_arcs *arcs, rw_patch patch);
void rw_pad_potential_destroy(rw_pad_potential *potential);

/* The pressure at a place of the surface, 0 outside of the patch; not at a kink. */
double rw_pad_pressure(const rw_pad_potential *potential, double x);

/* The same at n places, without memory. */
void rw_pad_pressures(const rw_arcs *arcs, rw_patch patch, size_t n, const double x[], double p[]);

/* The potential at count <= RW_BATCH points, without memory. */
void rw_pad_fields(const rw_arcs *arcs, rw_patch patch, int count, const double x[],
                   const double y[], rw_fields *fields);

#endif
