/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef RW_SLIDING_LAW_H
#define RW_SLIDING_LAW_H

#include "unlike/sliding_patch.h"

/* The load, middle and tilt of a wedge whose contact has the half-width 1 and slides with Q > 0;
 * and b s1/(fP) at the trailing edge. NaN where they are not found. */
typedef struct {
    double load, middle, tilt, tension;
} rw_sliding_law;

rw_sliding_law rw_sliding_law_of(const rw_unlike *unlike, double alpha, bool is_held);

#endif
