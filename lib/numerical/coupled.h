/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A step of unlike bodies. With N = -p on a contact, B = -beta and L[t] of bounded_inverse.h,
 *     N = (that of the pad alone) + B L[t],   w' = Omega + stretch - B N,
 * so each of both tractions asks for the other. They are found in passes: from the shear of the
 * pass before follow the edges and the pressure, by two equations in its moments; then the shear as
 * of similar bodies (problem.h), with that pressure. Its change by N' - N where nothing slips is
 * the layer t2 = -B L[N' - N] on the union of both contacts: its transform is B (N' - N) + c, c =
 * -(B/pi) int (N' - N)/|X|. */
#ifndef RW_COUPLED_H
#define RW_COUPLED_H

#include "numerical/step.h"

/* Does what rw_implicit_step() does, of unlike bodies. */
bool rw_coupled_step(rw_work *work, const rw_numerical_state *from, rw_scaled_loads to,
                     const rw_zones *guess, bool coarse, rw_numerical_state *there);

/* Sets the contact and the pressure of a state from its loads and its shear, which is known on a
 * contact that need not be that of the loads. false where memory is short or there is none. */
bool rw_coupled_press(const rw_frame *frame, rw_numerical_state *state);

#endif
