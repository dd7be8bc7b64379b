/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where slip is measured from: the path that the memory diagram had when a point came into
 * contact. The tangential displacement that the point had then is no slip. So that path is kept
 * here, though the memory may forget it. Points are named by the load u under which the edge of
 * the contact is at them.
 *
 * A load that rises without slip adds points whose path is the present one. They have not
 * slipped, and nothing is kept for them. The first slip after that keeps the path. It serves all of
 * these points, and those that the slipping step itself brings into contact: the path of each of
 * the latter is the kept path, extended along the step's straight line to the point. A falling load
 * removes the points that separate. So a load adds one origin at most, and only if the contact grew
 * since the origin before; a repeated cycle replaces its own origins.
 *
 * A path that is kept has its first corners in common with the one kept before it, as many as no
 * load has changed in between. Only the others are stored. Each load makes two new corners at most,
 * so all paths together take memory in proportion to the loads. */
#ifndef RW_SLIP_ORIGIN_H
#define RW_SLIP_ORIGIN_H

#include "history/memory.h"

/* An origin serves the points u up to the load `end`, from the end of the origin before it. For u >
 * from_load the path goes on along the straight line from (from_load, from_shear) to (to_load,
 * to_shear). Points from `fresh` on have not slipped. */
typedef struct {
    rw_slip_origin *all;
    size_t count, capacity;
    rw_memory own; /* all paths' own corners, in a row */
    double fresh;
} rw_slip_origins;

rw_slip_origins rw_slip_origins_copy(const rw_slip_origins *origins, bool *is_whole);
void rw_slip_origins_destroy(rw_slip_origins *origins);

/* Makes room for so many more origins and for so many more corners. false where memory is short;
 * all is as before. */
bool rw_slip_origins_reserve(rw_slip_origins *origins, size_t more, size_t corners);

/* Notes a step from the end of the path to (load, shear), before the path itself goes on. false
 * where memory is short; all is as before. */
bool rw_slip_origins_advance(rw_slip_origins *origins, rw_memory *memory, bool slips, double load,
                             double shear);

/* Adds an origin whose path shares its first corners with the last one, and goes on with its own.
 * There must be room. */
void rw_slip_origins_keep(rw_slip_origins *origins, rw_slip_origin origin, const rw_corner own[]);

/* How many corners the path has that was kept last; 0 where none is. */
size_t rw_slip_origins_last_corners(const rw_slip_origins *origins);

/* How many corners beyond the origin of their path are kept. */
size_t rw_slip_origins_corners(const rw_slip_origins *origins);

/* The origin of the point u; NULL where it has not slipped. */
const rw_slip_origin *rw_slip_origin_of(const rw_slip_origins *origins, double u);

/* The path it has kept. */
rw_path rw_slip_origin_path(const rw_slip_origins *origins, const rw_slip_origin *origin);

/* Where a path at the point u leaves that of the origin. */
rw_departure rw_slip_origin_departure(const rw_slip_origin *origin, const rw_path *path, double u);

#endif
