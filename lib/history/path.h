/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether a load with moment and bulk tension leads to a state in closed form. The memory diagram
 * is exact as long as its patches are nested and slip has one sign at both edges at a time. Without
 * moment and under one tension this is always so. */
#ifndef RW_PATH_H
#define RW_PATH_H

#include "formulas/size.h"
#include "history/memory.h"

/* A straight step of the loads: of P, M, Q and sigma; of a held pad, of P, the tilt, Q and sigma.
 * The patches are those of the contact at its ends. */
typedef struct {
    const rw_geometry *geometry;
    const rw_memory *memory;
    bool is_held;
    double from_P, from_M, to_P, to_M;
    rw_memory_loads to;
    rw_patch patch; /* under the new load */
} rw_step;

typedef enum {
    RW_NO_OBSTACLE,
    RW_EDGES_PART,      /* one edge of the contact advances while the other recedes */
    RW_SLIPS_BOTH_WAYS, /* at the two edges */
    RW_FRONTS_PART,     /* the fronts of slip end in different layers */
    RW_GROWS_UNEVENLY   /* tilt or tension change while new rings come into contact with shear */
} rw_obstacle;

/* Why the step has no closed form; RW_NO_OBSTACLE where it has one, with the departure for its
 * load, whose patch is then known. */
rw_obstacle rw_path_departure(const rw_step *step, rw_departure *departure);

/* The front of a departure has passed the layers of the path from the edges of the contact. Whether
 * all points between have slipped the way of the departure, to rounding; false where that is not
 * shown. The front's patch must be known, and the patches of the path nested from it on. */
bool rw_slips_one_way(const rw_memory *path, const rw_departure *departure,
                      const rw_geometry *geometry);

/* Whether a step that separates the bodies slips nowhere on its way. */
bool rw_path_separates_stuck(const rw_step *step);
#endif
