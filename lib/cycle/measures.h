/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a cycle does to a place: the measures of rwedge_contact_cycle_worst(). */
#ifndef RW_MEASURES_H
#define RW_MEASURES_H

#include "cycle/states.h"

/* The stresses after each load at n places, 3 loads n numbers: those of a load one after the other,
 * sxx of all loads first, then syy and txy. */
int32_t rw_cycle_stresses(const rw_cycle *cycle, size_t n, const double x[], const double y[],
                          double stress[]);

/* The largest sxx after any load at the place i, from the stresses at n places. */
double rw_largest_stress(const rw_cycle *cycle, size_t n, const double stress[], size_t i);

#endif
