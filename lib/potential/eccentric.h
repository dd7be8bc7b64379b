/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The potential of a patch off the centre, as potential.h has it for a centred one. A centred patch
 * is passed on to potential.h. */
#ifndef RW_ECCENTRIC_H
#define RW_ECCENTRIC_H

#include "formulas/patch.h"
#include "potential/batch.h"
#include "potential/potential.h"

/* The profile as seen from one half of the plane, right or left of the patch's middle; from the
 * left half mirrored. */
typedef struct {
    double edge;                     /* of the patch on this side */
    double end, other_end;           /* of the arc: the one that is inside, or the left one */
    double centre, centre_low;       /* of the arc, in two parts */
    double sine[2], cosine[2];       /* of the angles of the arc's ends */
    double sin_middle, slant;        /* slant: the tangent of the angle midway */
    double above, beside, clearance; /* see turn_over() */
    double side;                     /* of the end that is inside, if one is: +1 flank beyond it */
    double arc_over;
} rw_half_view;

enum { RW_SERIES_TERMS = 27 };

typedef struct {
    rw_potential centred;
    rw_patch patch;
    double middle, half_width, per_half_width;
    double a; /* half of the arc */
    rw_arc_ends ends;
    bool is_centred;
    int inside;                  /* how many ends of the arc are inside the patch */
    rw_half_view view[2];        /* right, left */
    double far[RW_SERIES_TERMS]; /* of the series in R, from R^1 */
} rw_eccentric;

/* The potential of an arc that is partly inside the patch. */
void rw_eccentric_init_arc(rw_eccentric *potential, rw_arc arc, rw_patch patch);

/* The potential of any sum of arcs at points that are far: the series (2/pi) sum far[n - 1] R^n.
 * Its coefficients are 0 at first. */
void rw_eccentric_init_far(rw_eccentric *potential, rw_patch patch);

/* G, and H = y G' in the unit of the patch. Error below 20 epsilon max(|G|, 1/(1+|z|)), z from the
 * middle in half-widths, over 1 - |delta|. */
rw_field rw_eccentric_at(const rw_eccentric *potential, double x, double y);
void rw_eccentric_fields(const rw_eccentric *potential, int count, const double x[],
                         const double y[], rw_fields *fields);

#endif
