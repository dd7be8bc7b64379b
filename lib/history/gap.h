/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surface displacements of the patches of traction that a history is made of. */
#ifndef RW_GAP_H
#define RW_GAP_H

#include "formulas/size.h"
#include "potential/potential.h"

/* How far the profile, tilted as the contact of a patch tilts it, lies above the surface that this
 * contact deforms, at x, in theta and the unit of a: 0 inside the patch. Times f and a weight it is
 * the slip that a patch of shear traction causes. Relative error below 1e-13 over 1 - |delta|; that
 * of rw_gap() for a wedge in the middle. */
double rw_patch_gap(const rw_geometry *geometry, rw_patch patch, double x);

/* The same of a pad, or of a patch off the centre, with x outside. */
double rw_off_centre_gap(const rw_geometry *geometry, rw_patch patch, double x);

/* The same of a wedge whose contact has the half-width 1 and its middle at 0, x >= 0 and finite:
 *     gap = int_0^x (g - Re G) dx,   g = x/alpha for x < alpha, 1 beyond.
 * Relative error below 2e-15; 2e-13 where alpha is next to 1. */
double rw_gap(const rw_potential *potential, double x);

#endif
