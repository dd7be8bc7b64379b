/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a cycle changes of K of a crack, at any length. */
#ifndef RW_CYCLE_RANGES_H
#define RW_CYCLE_RANGES_H

#include "crack/cycle_crack.h"
#include "crack/ranges.h"

/* The ranges at n <= RW_CRACK_LENGTHS lengths. shear is RWEDGE_FACES_MODE_I and so on. */
int32_t rw_cycle_ranges(rw_crack *crack, int32_t shear, size_t n, const double length[],
                        rw_crack_range range[]);

#endif
