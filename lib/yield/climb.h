/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The climb of J2 to a top, and the highest place of all climbs. */
#ifndef RW_CLIMB_H
#define RW_CLIMB_H

#include "contact/contact.h"

/* The highest J2 so far, in (theta/A)^2, and where. */
typedef struct {
    const rwedge_contact *contact;
    double kappa;
    double tension; /* half the bulk tension */
    double J2, x, y;
    double known; /* the highest of the grids too */
    /* the highest top climbed, and its distance from the mark; infinite before the first */
    double top_x, top_y, top_radius;
} rw_highest;

/* A place in polar coordinates around a mark. */
typedef struct {
    double angle, log_radius;
} rw_polar;

/* A climb around a mark. It begins at a maximum of the grid; its top is the highest so far. */
typedef struct {
    double centre, innermost, outermost;
    rw_polar top;
    double J2, hidden; /* hidden: what the steps of the grid may hide */
} rw_climb;

/* The ratio of neighbouring radii of a grid. */
#define RW_FALL 0.5

/* J2 from the fields at n points; for side = -1 at their mirror images. */
void rw_J2_from(rw_highest *highest, const rw_contact_fields *fields, int side, int n, double J2[]);

/* The depth at which a place at the distance r from its mark is looked at. By rounding the place
 * may be the apex of a sharp wedge, which has no stress. Beside it J2 is not high. */
static inline double rw_off_apex(const rwedge_contact *contact, double x, double y, double r)
{
    return y == 0 && rw_is_kink(&contact->geometry, x) ? 1e-3 * r : y;
}

/* Looks at the mark, and climbs from the start to its top. */
void rw_climb_from(rw_highest *highest, rw_climb start);

#endif
