/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The energy that friction dissipates in a load step, in closed form (lib/README.md, "Load
 * histories"). */
#ifndef ENERGY_H
#define ENERGY_H

#include "references/memory.h"

/* In a straight line from the path's end to (load, shear), over A f^2/pi; unit is theta/A. ahead
 * receives by how much Q/f gets ahead of what sticks. */
void ball_dissipation(arb_t energy, arb_t ahead, const path *p, const arb_t load, const arb_t shear,
                      const arb_t a, const arb_t unit, slong prec);

#endif
