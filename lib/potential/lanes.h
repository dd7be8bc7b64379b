/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the loops over many points share: points go by as many as RW_LANES, and the loop is compiled
 * for each kind of processor. */
#ifndef RW_LANES_H
#define RW_LANES_H

#include "base/processor.h"
#include "potential/batch.h"

enum { RW_LANES = 8 }; /* a multiple of the numbers in a vector */

/* Defines NAME(potential, count, x, y, fields), which does LOOP for the processor at hand. */
#define RW_BEST_PROCESSOR(NAME, LOOP, POTENTIAL)                                                   \
    RW_DISPATCH(                                                                                   \
        NAME, LOOP,                                                                                \
        (const POTENTIAL *p, int count, const double x[], const double y[], rw_fields *fields),    \
        (p, count, x, y, fields))

#endif
