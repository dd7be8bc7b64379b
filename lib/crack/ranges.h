/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a cycle changes of the stress intensities of a crack. */
#ifndef RW_RANGES_H
#define RW_RANGES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct {
    double I, II; /* ranges */
    double K_max; /* the largest sqrt(K_I^2 + K_II^2) while it is open */
    double R;     /* least over largest K_I, 0 where that is not positive */
} rw_crack_range;

/* The cycle of one crack: K of the load i is at [i stride]. */
typedef struct {
    size_t loads, stride;
    const double *I, *II;
    const double *passing; /* K_II where K_I becomes 0, or more, before the next load; NULL: K is
                              straight between loads */
} rw_cycle_of_K;

/* shear is RWEDGE_FACES_MODE_I and so on. */
rw_crack_range rw_crack_range_of(const rw_cycle_of_K *cycle, int32_t shear);

bool rw_is_crack_shear(int32_t shear);

#endif
