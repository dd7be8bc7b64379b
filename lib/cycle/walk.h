/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How a cycle comes to be: a contact goes through its loads, in parts where P or M changes, and its
 * states are noted. */
#ifndef RW_WALK_H
#define RW_WALK_H

#include "cycle/states.h"

/* The slip of a place in contact. */
double rw_slip_at(const rwedge_contact *contact, double x);

/* The displacement in the first state, and after a step. */
rw_displacement rw_first_displacement(const rwedge_contact *contact);
rw_displacement rw_next_displacement(rw_displacement last, const rwedge_contact *before,
                                     const rwedge_contact *after);

/* Whether the contact slides off its centre under a rig: all places slip then. */
static inline bool rw_slides_as_known(const rwedge_contact *contact)
{
    return contact->phase == RW_SLIDING && contact->sliding.is_off_centre && contact->slip.is_known;
}

/* The patch in which a straight step slips nowhere: where the paths before and after it part. That
 * is the last corner that both have in common, or a corner beyond at which one of them leaves the
 * segment that both begin with. RW_NOWHERE for a computed step, of which it is not known. */
rw_patch rw_stuck_between(const rwedge_contact *before, const rwedge_contact *after);

static const rw_patch RW_NOWHERE = {HUGE_VAL, -HUGE_VAL};

/* Notes a state for slip, which may be computed beside the contact. `from`: the contact before the
 * step, NULL in the first state; `lender` as in rw_record_add(), of the contact alone. */
int32_t rw_note_state(rwedge_cycle *cycle, const rwedge_contact *from, const rwedge_contact *to,
                      const rw_entry *lender);

/* Notes that all places slip alike, by `slid`, under the loads that the contact has. */
int32_t rw_note_sliding(rwedge_cycle *cycle, const rwedge_contact *contact, double slid);

/* Notes that what the whole step leaves stuck has stuck in its parts too, which are the states from
 * `first` on. */
void rw_note_stuck(rwedge_cycle *cycle, size_t first, rw_patch stuck);

/* Goes on, and notes the state. */
int32_t rw_go_part(rwedge_cycle *cycle, rwedge_contact *going, rw_goal to);

/* Goes along the way to a load, but not to the load itself, and notes the states. It ends where one
 * of them has no closed form: the step as a whole has one. On the way to separation the slip is
 * then not known, RWEDGE_EPATH. */
int32_t rw_go_parts(rwedge_cycle *cycle, rwedge_contact *going, rw_goal to);

/* Goes through all loads of a cycle that has nothing but them and the contact before. */
int32_t rw_go_through(rwedge_cycle *cycle);

#endif
