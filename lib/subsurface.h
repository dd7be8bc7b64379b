/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Yield below the surface: the local maximum of J2 at y > 0 in full sliding. */
#ifndef RW_SUBSURFACE_H
#define RW_SUBSURFACE_H

#include <stdbool.h>

#include "surface.h"

/* What to do where the branch lies below the surface maximum. */
typedef enum {
    RW_FOLLOW_TO_ITS_END,
    RW_STOP_WHERE_OVERTAKEN /* give up as soon as the surface is known to yield first */
} rw_branch_extent;

/* False where there is no such maximum (or none that matters); *maximum is then untouched. alpha in (0, 1]. */
bool rw_subsurface_maximum(double alpha, double f, double kappa, rw_branch_extent extent, rw_maximum *maximum);

#endif
