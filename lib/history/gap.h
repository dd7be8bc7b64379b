/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surface displacements of the patches of traction that a history is made of. */
#ifndef RW_GAP_H
#define RW_GAP_H

#include "potential/potential.h"

/* How far the profile h(x) lies above the surface that a contact of half-width 1 has deformed,
 * at x >= 0, in theta:
 *     gap = int_0^x (g - Re G) dx,   g = x/alpha for x < alpha, 1 beyond.
 * 0 for x <= 1. Times f and a weight it is the slip that a patch of shear traction causes. x
 * finite. Relative error below 2e-15; 2e-13 where alpha is next to 1. */
double rw_gap(const rw_potential *potential, double x);

#endif
