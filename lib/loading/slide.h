/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A contact that slides off its centre under a rig. */
#ifndef RW_SLIDE_H
#define RW_SLIDE_H

#include "contact/contact.h"

/* Slip and energy of a contact to which a rig prescribes displacements, and which the loads of the
 * goal lead from `before` to slide. They stay unknown where the last place that sticks is not
 * known. RWEDGE_ENOMEM. */
int32_t rw_contact_know_slide(const rwedge_contact *before, rw_goal to, rwedge_contact *contact);

#endif
