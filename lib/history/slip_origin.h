/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where slip is measured from: the path that the memory diagram had when a point came into
 * contact. The tangential displacement that the point had then is no slip. So that path is kept
 * here, though the memory may forget it. Points are named by the load u under which the edge of
 * the contact is at them.
 *
 * A load that rises without slip adds points whose path is the present one. They have not
 * slipped, and nothing is kept for them. The first slip after that takes a copy of the path. The
 * copy serves all of these points, and those that the slipping step itself brings into contact:
 * the path of each of the latter is the copy, gone on along the step's straight line to the point.
 * A falling load takes its points off. So a load adds one origin at most, and only if the contact
 * grew since the origin before; a repeated cycle replaces its own. */
#ifndef RW_SLIP_ORIGIN_H
#define RW_SLIP_ORIGIN_H

#include "history/memory.h"

/* The points up to the load `end` that are beyond those of the one before. For u > from_load the
 * path goes on along the straight line from (from_load, from_shear) to (to_load, to_shear). */
typedef struct {
    double end;
    rw_memory base;
    double from_load, from_shear, to_load, to_shear;
} rw_slip_origin;

/* Points from `fresh` on have not slipped. */
typedef struct {
    rw_slip_origin *all;
    size_t count, capacity;
    double fresh;
} rw_slip_origins;

bool rw_slip_origins_copy(const rw_slip_origins *origins, rw_slip_origins *copy);
void rw_slip_origins_destroy(rw_slip_origins *origins);

/* The step from the end of the path, before the path is told of it; slips: whether it does.
 * false where memory is short; all is as before. */
bool rw_slip_origins_advance(rw_slip_origins *origins, const rw_memory *memory, bool slips,
                             double load, double shear);

/* The origin of the point u; NULL where it has not slipped. */
const rw_slip_origin *rw_slip_origin_of(const rw_slip_origins *origins, double u);

/* Where the path of the point u leaves its origin's base. */
rw_departure rw_slip_origin_departure(const rw_slip_origin *origin, double u);

#endif
