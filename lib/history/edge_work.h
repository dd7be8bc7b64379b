/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The energy of a load step where patches are off the centre. */
#ifndef RW_EDGE_WORK_H
#define RW_EDGE_WORK_H

#include "formulas/size.h"
#include "history/memory.h"

/* The integral of |p| times the slip of a step under constant load and moment over the two annuli
 * that slip; p in theta/A, the slip in f theta. The path is that before the step, the departure the
 * front of slip, its patch known. */
double rw_edge_work(const rw_memory *path, const rw_departure *departure,
                    const rw_geometry *geometry);

#endif
