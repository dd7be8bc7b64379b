/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What friction does at a place of the surface in a cycle. */
#ifndef RW_FRICTION_H
#define RW_FRICTION_H

#include "cycle/states.h"

/* All 0 where there is no contact in the cycle. */
typedef struct {
    double slip_range, shear, energy; /* shear: the largest magnitude of q */
} rw_rubbing;

rw_rubbing rw_rubbing_at(const rw_cycle *cycle, double x);

#endif
