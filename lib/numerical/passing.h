/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The moment of a step at which an edge that grows comes to a kink of the profile. From then on it
 * is much slower, and D takes another course over the places that come into contact: a step that
 * ends there and another one from there on are of second order, one step over both is not. */
#ifndef RW_PASSING_H
#define RW_PASSING_H

#include "numerical/step.h"

/* The part of the step from the one state to the other at which that is, 0 < part < 1; 1 where no
 * such edge comes to a kink, or it does so near an end of the step. An edge that slips the same way
 * all the time does not count. */
double rw_passing_of_kink(const rw_work *work, const rw_numerical_state *from,
                          const rw_numerical_state *there);

#endif
