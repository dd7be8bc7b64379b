/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A contact in closed form, and beside it the same one whose slip and energy are computed. */
#ifndef RW_BESIDE_H
#define RW_BESIDE_H

#include "contact/contact.h"

/* The next load of both. */
int32_t rw_contact_apply_beside(rwedge_contact *contact, rw_goal to);

/* From now on the slip stays known, if the contact allows errors, until it slides. Where it is not
 * known now it counts from here. RWEDGE_ENOMEM. */
int32_t rw_contact_follow_slip(rwedge_contact *contact);

#endif
