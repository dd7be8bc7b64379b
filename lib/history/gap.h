/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surface displacements of the patches of traction that a history is made of. */
#ifndef RW_GAP_H
#define RW_GAP_H

#include "formulas/size.h"

/* The gap outside a patch: a wedge's patch in the middle, x > 0, with the half-width s; any
 * patch. */
double rw_centred_gap(double a, double s, double x);
double rw_off_centre_gap(const rw_geometry *geometry, rw_patch patch, double x);

/* How far the profile, tilted as the contact of a patch tilts it, lies above the surface that this
 * contact deforms, at x, in theta and the unit of a: 0 inside the patch. Times f and a weight it is
 * the slip that a patch of shear traction causes. x finite. Relative error below 1e-13 over
 * 1 - |delta|, or 1e-12 of the half-width where the patch ends beside a rounding much smaller than
 * it; of a wedge in the middle 2e-15, and 2e-13 where the half-width is next to a. */
static inline double rw_patch_gap(const rw_geometry *g, rw_patch patch, double x)
{
    return rw_patch_has(patch, x)                 ? 0
           : g->pad || patch.left != -patch.right ? rw_off_centre_gap(g, patch, x)
                                                  : rw_centred_gap(g->a, patch.right, fabs(x));
}

#endif
