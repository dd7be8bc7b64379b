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

/* K of the load i is at [i stride]; shear is RWEDGE_FACES_MODE_I and so on. */
rw_crack_range rw_crack_range_of(size_t loads, size_t stride, const double K_I[],
                                 const double K_II[], int32_t shear);

bool rw_is_crack_shear(int32_t shear);

#endif
