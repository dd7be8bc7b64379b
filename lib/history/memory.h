/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The memory diagram of a contact: all that it remembers of its history. The tractions after any
 * history of loads (P, Q) are those of a load that grew along one path from the origin, never
 * steeper than friction. With the load s = P on the path and the shear T = Q/f,
 *     q(x) = f int D(s) dp(x; s),   D = dT/ds in [-1, 1],   0 <= s <= P,
 * where p(x; s) is the pressure under the load s. The path is a polygon. This file keeps its
 * corners and knows no geometry.
 *
 * With moment and bulk tension, load and shear are pairs: the tilt stands beside the load, the
 * stretch beside the shear. On a segment of the path the change of the second pair is D times that
 * of the first. Load and shear decide which corner a line meets; tilt and stretch follow. All this
 * holds only where the patches are nested: path.h decides that.
 *
 * A new load (P', T') extends the path where the step is not steeper than 1. Otherwise the edge
 * slips, D = +-1: a line of that slope is drawn from (P', T') back to where it meets the path.
 * What lay beyond is forgotten. The path meets each of the two lines |T - T'| = P' - s once,
 * because it is never steeper than they are. */
#ifndef RW_MEMORY_H
#define RW_MEMORY_H

#include "formulas/patch.h"

#include <stdbool.h>
#include <stddef.h>

/* Loads as the memory has them: P and Q/f, and in theta what the moment takes off the slope of the
 * profile, the tilt, and the stretch -A sigma/(4 theta f). */
typedef struct {
    double load, shear;
    double tilt, stretch;
} rw_memory_loads;

/* A corner. `ratio` is the slope D of the path from the corner before it. The caller sets the
 * patch, that of the contact under this load and tilt; it is NaN when the corner is new. Corners
 * that lie on the path to rounding are left out: for slopes between `least` and `most` none of them
 * is farther from the path than its rounding error. */
typedef struct {
    double load, shear, tilt, stretch;
    double ratio, least, most;
    rw_patch patch;
} rw_corner;

/* A corner at these loads, with no ratio yet and nothing left out. */
static inline rw_corner rw_corner_at(rw_memory_loads at, rw_patch patch)
{
    return (rw_corner){at.load, at.shear, at.tilt, at.stretch, 0, -HUGE_VAL, HUGE_VAL, patch};
}

/* corners[0] is the origin. The first `shared` corners are as in the path that was last kept
 * (slip_origin.h). Those from the second on and before `level` have no tilt, and the stretch of the
 * origin. */
typedef struct {
    rw_corner *corners;
    size_t count, capacity;
    size_t shared;
    size_t level;
} rw_memory;

/* A kept path (slip_origin.h), as a branch of the path kept before it: it has the first `shared`
 * corners of that path, and then its own. `before` is the nearest earlier branch that shares fewer
 * corners, `jump` one farther back, so that any corner is found in a few jumps. */
typedef struct {
    double end, from_load, from_shear, to_load, to_shear;
    size_t corners, shared;
    size_t first; /* the place of its first own corner in the row of all */
    size_t before, jump, depth;
} rw_slip_origin;

/* A path to read: the present one, or one that was. */
typedef struct {
    const rw_corner *corners;
    const rw_slip_origin *origins;
    size_t origin, count;
} rw_path;

rw_path rw_memory_path(const rw_memory *memory);

static inline const rw_corner *rw_path_corner(const rw_path *path, size_t i)
{
    const rw_slip_origin *branch = &path->origins[path->origin];
    while (i < branch->shared) {
        const rw_slip_origin *far = &path->origins[branch->jump];
        branch = i < far->shared ? far : &path->origins[branch->before];
    }
    return &path->corners[branch->first + (i - branch->shared)];
}

/* The path of a contact without load. false where memory is short, and nothing is to be freed. Of a
 * copy `is_whole` becomes false there, and what there is of it is only to be freed. */
bool rw_memory_create(rw_memory *memory);
rw_memory rw_memory_copy(const rw_memory *memory, bool *is_whole);
void rw_memory_destroy(rw_memory *memory);

/* How many of their first corners two paths have in common; the origin always. */
size_t rw_memory_common(const rw_memory *memory, const rw_path *earlier);

/* Makes room for that many more corners. false where memory is short; the path is as before. */
bool rw_memory_reserve(rw_memory *memory, size_t more);

/* Where the path to a new load leaves the present one. Its patch is NaN unless it is a corner of
 * the path. */
typedef struct {
    rw_corner corner;
    size_t kept; /* so many corners of the path stay */
    int slip;    /* the slope beyond: the sign of slip; 0 where nothing slips */
} rw_departure;

/* The load has |shear| <= load. Without slip the path is only cut off, or extended. */
rw_departure rw_memory_departure(const rw_memory *memory, rw_memory_loads to);
rw_departure rw_departure_from(const rw_path *path, rw_memory_loads to);

/* Extends the path to a load from the departure for it. There must be room for two more corners. */
void rw_memory_advance(rw_memory *memory, const rw_departure *departure, rw_memory_loads to);

/* Starts a new path, straight to a load from an origin with that load's tilt and stretch: for a
 * contact that slides, or that has no friction. */
void rw_memory_restart(rw_memory *memory, rw_memory_loads to, double ratio);

/* Whether the path and this load have one stretch and no tilt: a history of P and Q alone. */
static inline bool rw_memory_is_plain(const rw_memory *memory, rw_memory_loads to)
{
    const rw_corner *origin = &memory->corners[0];
    return to.tilt == 0 && origin->tilt == 0 && origin->stretch == to.stretch &&
           memory->level >= memory->count;
}

/* Finds `level` of corners that were set from outside. */
void rw_memory_relevel(rw_memory *memory);

/* The last corner. */
static inline const rw_corner *rw_memory_end(const rw_memory *memory)
{
    return &memory->corners[memory->count - 1];
}

static inline const rw_corner *rw_path_end(const rw_path *path)
{
    return rw_path_corner(path, path->count - 1);
}

/* The shear where the path has that load, 0 <= load <= that of its end. */
double rw_path_shear(const rw_path *path, double load);

/* V = (tilt' - tilt) - S (stretch' - stretch) beyond a corner, S = slip (lib/README.md, "Moment and
 * bulk tension"): 0, to rounding, where the corner is the front. */
double rw_memory_missing_tilt(const rw_corner *corner, int slip, rw_memory_loads to);

/* Whether friction is exhausted all over: the path is one line of the slope +-1. */
bool rw_memory_slides(const rw_memory *memory);

/* Differences of loads below this are rounding errors. */
double rw_memory_tolerance(double load);

#endif
