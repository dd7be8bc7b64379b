/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Slip where patches are off the centre. */
#ifndef RW_OFF_CENTRE_H
#define RW_OFF_CENTRE_H

#include "history/path.h"

/* How far the profile, tilted as the contact of a patch tilts it, lies above the surface that this
 * contact deforms, at x, in theta and the unit of a: 0 inside the patch. Relative error below 1e-13
 * over 1 - |delta|. */
double rw_patch_gap(const rw_geometry *geometry, rw_patch patch, double x);

/* The tangential displacement at x, over f theta, that one path has beyond another of the same
 * slope in its first layer. What both paths have in common is left out. */
double rw_path_displacement(const rw_memory *path, const rw_memory *beyond,
                            const rw_geometry *geometry, double x);

#endif
