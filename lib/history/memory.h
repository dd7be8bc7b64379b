/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The memory diagram of a contact: all that it remembers of its history. The tractions after any
 * history of loads (P, Q) are those of a load that grew along one path from the origin, never
 * steeper than friction. With the load s = P on the path and the shear T = Q/f,
 *     q(x) = f int D(s) dp(x; s),   D = dT/ds in [-1, 1],   0 <= s <= P,
 * where p(x; s) is the pressure under the load s. The path is a polygon. This file keeps its
 * corners and knows no geometry.
 *
 * A new load (P', T') extends the path where the step is not steeper than 1. Otherwise the edge
 * slips, D = +-1: a line of that slope is drawn from (P', T') back to where it meets the path.
 * What lay beyond is forgotten. The path meets each of the two lines |T - T'| = P' - s once,
 * because it is never steeper than they are. */
#ifndef RW_MEMORY_H
#define RW_MEMORY_H

#include <stdbool.h>
#include <stddef.h>

/* A corner, with the slope D of the path from the corner before it. The caller sets half_width,
 * that of the contact under this load; it is NaN when the corner is new. least and most bound the
 * slope: within them, no corner that was left out is farther from the path than its rounding
 * error. */
typedef struct {
    double load, shear, ratio;
    double least, most;
    double half_width;
} rw_corner;

/* corners[0] is the origin. */
typedef struct {
    rw_corner *corners;
    size_t count, capacity;
} rw_memory;

/* The path of a contact without load. false where memory is short, and nothing is to be freed. */
bool rw_memory_create(rw_memory *memory);
bool rw_memory_copy(const rw_memory *memory, rw_memory *copy);
void rw_memory_destroy(rw_memory *memory);

/* Makes room for that many more corners. false where memory is short; the path is as before. */
bool rw_memory_reserve(rw_memory *memory, size_t more);

/* Where the path to a new load leaves the present one. Its half_width is NaN unless it is a
 * corner of the path. */
typedef struct {
    rw_corner corner;
    size_t kept; /* so many corners of the path stay */
    int slip;    /* the slope beyond: the sign of slip; 0 where nothing slips */
} rw_departure;

/* For the load (load, shear), |shear| <= load. Without slip the path is only cut off, or
 * extended. */
rw_departure rw_memory_departure(const rw_memory *memory, double load, double shear);

/* Goes on to (load, shear) by way of the departure for it. There is room for two more corners. */
void rw_memory_advance(rw_memory *memory, const rw_departure *departure, double load, double shear);

/* The last corner. */
static inline const rw_corner *rw_memory_end(const rw_memory *memory)
{
    return &memory->corners[memory->count - 1];
}

/* The shear where the path has that load, 0 <= load <= that of its end. */
double rw_memory_shear(const rw_memory *memory, double load);

/* Differences of loads below this are rounding errors. */
double rw_memory_tolerance(double load);

#endif
