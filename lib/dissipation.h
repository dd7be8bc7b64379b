/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The energy that friction dissipates in one load step. */
#ifndef RW_DISSIPATION_H
#define RW_DISSIPATION_H

#include "history.h"

/* In the straight step from the end of the path to (load, shear): the integral of |p| |d(slip)|/f over the contact,
 * times pi/A, which has the unit of load^2. corner_load is the load A P/theta = (pi/2) a under which the contact
 * reaches the end of the rounding, in the unit of the path. Never negative. */
double rw_dissipation(const rw_path *path, double load, double shear, double corner_load);

#endif
