/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where a step slips nowhere, and the zones that never slip. */
#ifndef RW_STUCK_H
#define RW_STUCK_H

#include "contact/contact.h"

/* No patch. */
static const rw_patch RW_NOWHERE = {HUGE_VAL, -HUGE_VAL};

/* Whether the contact slides off its centre under a rig: all places slip then. */
static inline bool rw_slides_as_known(const rwedge_contact *contact)
{
    return contact->phase == RW_SLIDING && contact->sliding.is_off_centre && contact->slip.is_known;
}

/* The patch in which a straight step slips nowhere: where the paths before and after it part. That
 * is the last corner that both have in common, or a corner beyond at which one of them leaves the
 * segment that both begin with. RW_NOWHERE for a computed step, of which it is not known. */
rw_patch rw_stuck_between(const rwedge_contact *before, const rwedge_contact *after);

/* The zones that never slip so far, as steps are added. */
typedef struct {
    rw_patch *all;
    size_t count;
} rw_stuck_zones;

/* Begins with a contact. Leaves of them what a step leaves: where the patch sticks, or the zones of
 * a computed state. false where memory is short. */
bool rw_stuck_begin(rw_stuck_zones *zones, const rwedge_contact *contact);
bool rw_stuck_go_on(rw_stuck_zones *zones, const rwedge_contact *after, rw_patch stuck,
                    double rounding);
rw_patch rw_stuck_widest(const rw_stuck_zones *zones);

#endif
