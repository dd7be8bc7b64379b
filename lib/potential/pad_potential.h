/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The potential of a patch of any pad: the sum of those of its arcs. */
#ifndef RW_PAD_POTENTIAL_H
#define RW_PAD_POTENTIAL_H

#include "formulas/arcs.h"
#include "potential/eccentric.h"

/* The pressure at n places of the surface, 0 outside of the patch; not at a kink. */
void rw_pad_pressures(const rw_arcs *arcs, rw_patch patch, size_t n, const double x[], double p[]);

/* The potential at count <= RW_BATCH points. */
void rw_pad_fields(const rw_arcs *arcs, rw_patch patch, int count, const double x[],
                   const double y[], rw_fields *fields);

#endif
