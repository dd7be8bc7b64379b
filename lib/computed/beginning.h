/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How a computed shear begins: from a closed form, or where the bodies touch. */
#ifndef RW_CONTACT_BEGINNING_H
#define RW_CONTACT_BEGINNING_H

#include "computed/computed_load.h"

/* Loads are on a line, and a traction is within friction, but for this part of friction. */
#define RW_ROUNDING_OF_FRICTION 1e-9

/* The profile, friction and tolerance of a contact, and its loads, for the computed shear. `turn`
 * is M, of a held pad its tilt. A held pad that touches has the tilt of the loads to come. */
rw_frame rw_contact_frame(const rwedge_contact *contact);
rw_scaled_loads rw_contact_scaled_loads(const rwedge_contact *contact, double P, double turn,
                                        double shear, double stretch);
rw_scaled_loads rw_loads_before_touching(const rwedge_contact *contact, rw_scaled_loads to);

/* The computed shear of a contact in closed form. NULL where memory is short. */
rw_numerical *rw_numerical_of_closed_form(const rwedge_contact *contact);

/* The same on a straight line from touching to the loads: at its end, or where slip begins before
 * that. RWEDGE_ENOMEM; RWEDGE_ENOCONV; then `begun` is NULL. */
int32_t rw_numerical_of_touching(const rwedge_contact *contact, rw_scaled_loads to,
                                 rw_numerical **begun);

#endif
