/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A contact whose shear has no closed form. Its memory then holds the contact alone, without shear,
 * and the shear stands apart (numerical/computed_shear.h). */
#ifndef RW_COMPUTED_LOAD_H
#define RW_COMPUTED_LOAD_H

#include "contact/contact.h"

/* Goes on to a load under which the contact neither separates nor slides. Unless RWEDGE_OK, the
 * contact is as before. energy receives what the load dissipates. Of unlike bodies the step learns
 * where it leads. */
int32_t rw_numerical_go(rwedge_contact *contact, rw_step *step, double *energy);

/* The energy that the way to separation dissipates; NaN where that is not known. RWEDGE_ENOMEM. */
int32_t rw_numerical_energy_to_separation(const rwedge_contact *contact, double *energy);

/* Whether the contact may be in closed form again: P and M are those of the last closed form, and
 * one zone sticks, which has not slipped since, between two zones that slip the same way. */
bool rw_numerical_is_passed(const rwedge_contact *contact);

/* Whether a contact in closed form sticks and slips where this one does. */
bool rw_numerical_agrees(const rwedge_contact *contact, const rwedge_contact *exact);

#endif
