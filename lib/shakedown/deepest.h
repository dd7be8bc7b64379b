/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The depth at which a pass needs the highest strength. */
#ifndef RW_DEEPEST_H
#define RW_DEEPEST_H

#include "shakedown/least_peak.h"

#include <stdbool.h>

typedef struct {
    double peak, y; /* peak: in theta/A */
} rw_depth;

/* The highest local maximum below the surface; false where there is none. Of maxima less deep than
 * RW_SHALLOWEST of the shortest arc or of the half-width none counts. */
#define RW_SHALLOWEST 0.01
bool rw_subsurface_depth(const rw_pass *pass, rw_depth *depth);

/* The peak at the surface. */
double rw_surface_peak(const rw_pass *pass);

/* The surface, or the depth below it where the peak is higher. */
rw_depth rw_deepest(const rw_pass *pass);

#endif
