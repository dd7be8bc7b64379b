/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where slip is measured from: the path that the memory diagram had when a point came into
 * contact. What the tangential displacement of the point was then is no slip, and it stays what
 * it was however much of that path is forgotten since. Points are named by the load u under
 * which the edge of the contact is at them.
 *
 * A load that rises without slip adds points whose path is the present one: they have not
 * slipped, and nothing is kept for them. The first slip after that takes a copy of the path, for
 * all of them and for those that the slipping step itself brings into contact: for each of these
 * the path of the copy, gone on to that point of the step's straight line. A falling load takes
 * its points off. So there is one entry at most per load, and only where the contact grew since
 * the entry before; a repeated cycle replaces its own. */
#ifndef RW_ENTRY_H
#define RW_ENTRY_H

#include "history.h"

/* The points up to the load `end` that are beyond the entry before. For u > from_load the path
 * goes on along the straight line from (from_load, from_shear) to (to_load, to_shear). */
typedef struct {
    double end;
    rw_path base;
    double from_load, from_shear, to_load, to_shear;
} rw_entry;

/* Points from `fresh` on have not slipped. */
typedef struct {
    rw_entry *entries;
    size_t count, capacity;
    double fresh;
} rw_entries;

bool rw_entries_copy(const rw_entries *entries, rw_entries *copy);
void rw_entries_destroy(rw_entries *entries);

/* The step from the end of the path, before the path is told of it. false where memory is short;
 * all is as before. */
bool rw_entries_advance(rw_entries *entries, const rw_path *path, double load, double shear);

/* The entry of the point u; NULL where it has not slipped. */
const rw_entry *rw_entry_of(const rw_entries *entries, double u);

/* The corner up to which the path of the point u is that of its entry's base, and how many
 * corners of the base come before it or are it; *slip is the slope beyond, 0 where the path ends
 * there. */
rw_corner rw_entry_departure(const rw_entry *entry, double u, size_t *kept, int *slip);

#endif
