/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The moment of a step at which slip begins at an edge that grows, because the traction there grows
 * as fast as friction from then on; or at which slip turns round. The rates change their course at
 * such a moment. A step that ends there and another one from there on are of second order; one step
 * over both is not, and neither are its halves. */
#ifndef RW_ONSET_H
#define RW_ONSET_H

#include "numerical/step.h"

/* The part of the step from the one state to the other at which that is, 0 < part < 1; 1 where
 * there is no such moment, or none is found. */
double rw_onset_of_slip(rw_work *work, const rw_numerical_state *from,
                        const rw_numerical_state *there);

#endif
