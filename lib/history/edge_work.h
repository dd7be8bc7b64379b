/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The energy of a load step where patches are off the centre. */
#ifndef RW_EDGE_WORK_H
#define RW_EDGE_WORK_H

#include "history/memory.h"

/* The integral of |p| times the slip of a step under constant load and moment, which took the path
 * from `before` to `after`, over the two annuli that slip; p in theta/A, the slip in f theta. */
double rw_edge_work(const rw_memory *before, const rw_memory *after, double a);

#endif
