/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The places of the surface next to which stresses vary over short lengths, in the order in which
 * yield_factor.c searches around them. */
#ifndef RW_MARKS_H
#define RW_MARKS_H

#include "contact/contact.h"

typedef struct {
    double at;
    double reach;   /* the outer radius of its grid */
    double nearest; /* the distance to the nearest of all marks, but those at the same place */
} rw_mark;

/* The edge of a patch on one side, 1 or -1. */
static inline double rw_mark_edge(rw_patch patch, int side)
{
    return side > 0 ? patch.right : patch.left;
}

/* The main marks: the centre; then right and left in turn the edges of the contact, and of each
 * arc. */
int rw_main_marks(const rwedge_contact *contact);
rw_mark rw_main_mark(const rwedge_contact *contact, int i);

/* The i-th kink of a computed shear. */
rw_mark rw_kink_mark(const rwedge_contact *contact, const rw_shear_state *shear, int i);

/* The edge of a patch. Its grid reaches twice the distance to the nearest of the marks before it,
 * whose grids take over there: those of the patches `inner` and `outer` are among them. */
rw_mark rw_patch_mark(const rwedge_contact *contact, size_t inner, size_t i, size_t outer,
                      int side);

#endif
