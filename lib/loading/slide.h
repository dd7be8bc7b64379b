/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A contact that slides off its centre under a rig. */
#ifndef RW_SLIDE_H
#define RW_SLIDE_H

#include "contact/contact.h"

/* The displacement of a contact under a rig, without what the rig has slid; NaN where it is not
 * known. */
double rw_contact_displacement_of_loads(const rwedge_contact *contact);

/* From now on the slip of a contact that slides, with this displacement, counts from here. */
void rw_contact_count_slide(rwedge_contact *contact, double displacement);

/* Whether a contact of which the slip is known slides on the same way; then its slip and energy. */
bool rw_contact_slides_on(const rwedge_contact *before, const rwedge_contact *contact);
void rw_contact_slide_on(const rwedge_contact *before, rwedge_contact *contact);

#endif
