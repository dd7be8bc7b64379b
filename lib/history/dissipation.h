/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The energy that friction dissipates in one load step. */
#ifndef RW_DISSIPATION_H
#define RW_DISSIPATION_H

#include "formulas/size.h"
#include "history/memory.h"

/* In the straight step from the end of the path to (load, shear): the integral of |p|
 * |d(slip)|/f over the contact, times pi/A. For a centred patch of a symmetric pad. Not negative,
 * to rounding. */
double rw_dissipation(const rw_memory *memory, double load, double shear,
                      const rw_geometry *geometry);

#endif
