/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Yield below the surface: the local maximum of J2 at y > 0 in full sliding. */
#ifndef RW_SUBSURFACE_H
#define RW_SUBSURFACE_H

#include <stdbool.h>

#include "strength/surface.h"

/* False where there is no such maximum; *maximum is then untouched. alpha in (0, 1]. */
bool rw_subsurface_maximum(double alpha, double f, double kappa, rw_maximum *maximum);

#endif
