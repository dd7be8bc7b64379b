/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The energy that friction dissipates in one load step. */
#ifndef RW_DISSIPATION_H
#define RW_DISSIPATION_H

#include "formulas/size.h"
#include "history/memory.h"

/* The integral of |p| |d(slip)|/f over the contact, times pi/A, in the straight step from the end
 * of the path to a load, for a centred patch of a symmetric pad. It is not negative, to
 * rounding. */
double rw_dissipation(const rw_memory *memory, rw_memory_loads to, const rw_geometry *geometry);

/* Off the centre: the integral of |p| times the slip of a step under constant load and moment over
 * the two annuli that slip; p in theta/A, the slip in f theta. The path is that before the step,
 * the departure the front of slip, its patch known. */
double rw_edge_work(const rw_memory *path, const rw_departure *departure,
                    const rw_geometry *geometry);

/* The next of the places on the way from `from` to `next`: this one, if it lies between. */
static inline double rw_earlier(double place, double from, double next)
{
    return place > from && place < next ? place : next;
}

#endif
