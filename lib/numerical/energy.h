/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The energy of a step under which the contact changes. Slip times the mean of friction tells it
 * well where friction changes little. Where the edge passes the places that slip, they do so under
 * friction of the time between: there it is the integral of the power over the way. */
#ifndef RW_ENERGY_H
#define RW_ENERGY_H

#include "numerical/step.h"

/* Sets the energy of the state that a step has led to, where the slip does not tell it. `half` is
 * the state half-way, or that state itself where the step was taken as a whole. */
void rw_settle_energy(rw_work *work, const rw_numerical_state *from, const rw_numerical_state *half,
                      rw_numerical_state *there);

#endif
