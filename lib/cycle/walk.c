/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How a contact goes through the loads of a cycle. A copy of it goes ahead to each load in parts.
 * Loads in whose closed form the slip is not known are computed by a second contact, which goes on
 * beside the first one. */
#include "cycle/walk.h"

#include "cycle/parts.h"
#include "cycle/stuck.h"
#include "loading/apply.h"
#include "loading/beside.h"

#include <stdlib.h>

/* The contact, a copy that goes ahead to each load in parts, and the one that goes on where the
 * contact does not know its slip: NULL where there is none. */
typedef struct {
    rwedge_contact *contact, *ahead, *follower;
    rw_stuck_zones stuck;
} walk;

/* The slip of a load that the contact has gone to, or which the follower computes. */
static int32_t follow_slip(rwedge_cycle *cycle, walk *w, rw_goal to)
{
    if (!w->follower && rw_contact_knows_slip(w->contact)) {
        const rw_entry *lender = &cycle->at_loads.entries[cycle->at_loads.count - 1];
        return rw_note_state(cycle, w->ahead, w->contact, lender);
    }
    if (!w->follower) {
        w->follower = w->ahead;
        w->ahead = NULL;
    }
    const int32_t status = rw_contact_follow_slip(w->follower);
    return status == RWEDGE_OK ? rw_go_part(cycle, w->follower, to) : status;
}

/* A rig slides the bodies on. */
static int32_t slide_on(rwedge_cycle *cycle, const walk *w, double slid)
{
    if (slid == 0 || cycle->slip_status != RWEDGE_OK)
        return RWEDGE_OK;
    return rw_note_sliding(cycle, w->follower ? w->follower : w->contact, slid);
}

/* The part of the way that it slides before P changes: half of it where it slides already. */
static double slid_before(const rwedge_contact *contact, double slid)
{
    return contact->phase == RW_SLIDING && contact->loads.Q * slid > 0 ? slid / 2 : 0;
}

static void note_half_width(rwedge_cycle *cycle, double b)
{
    if (b > 0)
        cycle->least = cycle->most > 0 ? fmin(cycle->least, b) : b;
    cycle->most = fmax(cycle->most, b);
}

/* A copy goes to the load in parts. Why slip is not known is no reason to refuse the load. */
static int32_t go_ahead(rwedge_cycle *cycle, walk *w, rw_goal to)
{
    rwedge_contact_destroy(w->ahead);
    w->ahead = NULL;
    int32_t status = rwedge_contact_copy(w->contact, &w->ahead);
    if (status == RWEDGE_OK && rw_contact_knows_slip(w->ahead))
        status = rw_contact_follow_slip(w->ahead);
    if (status == RWEDGE_OK && cycle->slip_status == RWEDGE_OK)
        cycle->slip_status = rw_go_parts(cycle, w->follower ? w->follower : w->ahead, to);
    return status;
}

/* Goes to the load itself, and tells the patch that has stuck all the way. */
static int32_t arrive(rwedge_cycle *cycle, const walk *w, rw_goal to, rw_patch *stuck)
{
    rwedge_contact *before = NULL;
    int32_t status = rwedge_contact_copy(w->contact, &before);
    if (status == RWEDGE_OK)
        status = rw_contact_apply(w->contact, to);
    if (status == RWEDGE_OK && !(rw_record_add(&cycle->at_loads, w->contact, NULL) &&
                                 rw_edges_add(&cycle->edges, w->contact)))
        status = RWEDGE_ENOMEM;
    if (status == RWEDGE_OK) {
        *stuck = rw_stuck_between(before, w->contact);
        note_half_width(cycle, rwedge_contact_half_width(w->contact));
    }
    rwedge_contact_destroy(before);
    return status;
}

/* `slid`: how far a rig slides the bodies on besides. */
static int32_t go_to(rwedge_cycle *cycle, walk *w, rw_goal to, double slid)
{
    const double slid_first = slid_before(w->contact, slid);
    rw_patch stuck = RW_NOWHERE;
    int32_t status = slide_on(cycle, w, slid_first);
    const size_t first = cycle->count;
    if (status == RWEDGE_OK)
        status = go_ahead(cycle, w, to);
    if (status == RWEDGE_OK)
        status = arrive(cycle, w, to, &stuck);
    if (status == RWEDGE_OK) {
        if (cycle->slip_status == RWEDGE_OK)
            cycle->slip_status = follow_slip(cycle, w, to);
        rw_note_stuck(cycle, first, w->follower ? (rw_patch){0, 0} : stuck);
        if (cycle->count > first)
            cycle->states[cycle->count - 1].is_load = true;
        if (!rw_stuck_go_on(&w->stuck, w->contact, slid != 0 ? RW_NOWHERE : stuck, cycle->rounding))
            status = RWEDGE_ENOMEM;
    }
    if (status == RWEDGE_OK)
        status = slide_on(cycle, w, slid - slid_first);
    return cycle->slip_status == RWEDGE_ENOMEM ? RWEDGE_ENOMEM : status;
}

/* Slip that is not known before the cycle counts from its beginning. */
static int32_t begin(rwedge_cycle *cycle, walk *w)
{
    int32_t status = rwedge_contact_copy(cycle->before, &w->contact);
    if (status == RWEDGE_OK &&
        !(rw_stuck_begin(&w->stuck, w->contact) && rw_edges_add(&cycle->edges, w->contact)))
        status = RWEDGE_ENOMEM;
    if (status == RWEDGE_OK && !rw_contact_knows_slip(w->contact)) {
        status = rwedge_contact_copy(w->contact, &w->follower);
        if (status == RWEDGE_OK)
            status = rw_contact_follow_slip(w->follower);
        if (status == RWEDGE_OK && !rw_contact_knows_slip(w->follower))
            cycle->slip_status = RWEDGE_EPATH;
    }
    if (status == RWEDGE_OK)
        status = rw_note_state(cycle, NULL, w->follower ? w->follower : w->contact, NULL);
    return status;
}

int32_t rw_go_through(rwedge_cycle *cycle)
{
    walk w = {NULL, NULL, NULL, {NULL, 0}};
    int32_t status = begin(cycle, &w);
    for (size_t i = 0; i < cycle->loads.count && status == RWEDGE_OK; i++)
        status = go_to(cycle, &w, rw_cycle_goal(cycle, w.contact, i), rw_cycle_slid(cycle, i));
    if (status == RWEDGE_OK)
        cycle->never_slips = rw_stuck_widest(&w.stuck);
    if (status == RWEDGE_OK)
        rw_edges_settle(&cycle->edges);
    rwedge_contact_destroy(w.contact);
    rwedge_contact_destroy(w.ahead);
    rwedge_contact_destroy(w.follower);
    free(w.stuck.all);
    return status;
}
