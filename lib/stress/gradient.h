/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How the potential of a patch changes with the place, the rounding and the half-width. */
#ifndef RW_GRADIENT_H
#define RW_GRADIENT_H

#include "potential/potential.h"

/* d/dx of G and of H = y G', by the unit of the points; d/dy follows, as both are made of what is
 * analytic. Not at the edges and at the corners of the rounding: there G' is infinite. */
rw_field rw_potential_by_x(const rw_potential *potential, double x, double y);

/* a d/da of G and H, the half-width being constant. */
rw_field rw_potential_by_rounding(const rw_potential *potential, double x, double y);

/* c d/dc of G and H, the rounding being constant: a flat punch. */
rw_field rw_potential_by_half_width(const rw_potential *potential, double x, double y);

#endif
