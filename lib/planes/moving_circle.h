/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The smallest circle around the path of a plane, and how its centre moves with the plane. */
#ifndef RW_MOVING_CIRCLE_H
#define RW_MOVING_CIRCLE_H

#include "planes/plane_cycle.h"

typedef struct {
    rw_ball ball;
    rw_vector by_chi, by_beta; /* rates of its centre */
} rw_circle;

/* The circle around the components of the first n loads, which must be set. */
rw_circle rw_circle_of(rw_plane_cycle *cycle, size_t n);

#endif
