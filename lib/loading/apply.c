/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The next load, also of a contact to which a rig prescribes displacements. */
#include "loading/apply.h"

#include "loading/beside.h"
#include "loading/slide.h"

/* How far from f P a place still sticks, over f P. The displacement then changes by some ten times
 * that until it slides. The first may be too near to compute. */
static const double VERGE[] = {1e-6, 1e-5, 1e-4};
enum { VERGES = sizeof VERGE / sizeof VERGE[0] };

/* The contact when it is about to slide under the loads: one of which the displacement is known.
 * RWEDGE_EPATH where it never is. */
static int32_t find_verge(const rwedge_contact *contact, rw_goal to, rwedge_contact **verge)
{
    for (int i = 0; i < VERGES; i++) {
        rw_goal before = to;
        before.Q *= 1 - VERGE[i];
        int32_t status = rwedge_contact_copy(contact, verge);
        if (status == RWEDGE_OK)
            status = rw_contact_apply(*verge, before);
        if (status == RWEDGE_ENOMEM ||
            (status == RWEDGE_OK && !isnan(rw_contact_displacement_of_loads(*verge))))
            return status;
        rwedge_contact_destroy(*verge);
        *verge = NULL;
    }
    return RWEDGE_EPATH;
}

static int32_t begin_to_slide(const rwedge_contact *before, rw_goal to, rwedge_contact *contact)
{
    rwedge_contact *verge = NULL;
    const int32_t status = find_verge(before, to, &verge);
    if (status == RWEDGE_OK) {
        rw_contact_count_slide(contact, rw_contact_displacement_of_loads(verge));
        contact->energy = rw_contact_of_slip(verge)->energy;
    }
    rwedge_contact_destroy(verge);
    return status == RWEDGE_ENOMEM ? status : RWEDGE_OK;
}

/* Slip and energy of a contact that the loads lead from `before` to slide. They stay unknown where
 * the last place that sticks is not known. RWEDGE_ENOMEM. */
static int32_t know_slide(const rwedge_contact *before, rw_goal to, rwedge_contact *contact)
{
    if (contact->phase != RW_SLIDING || !contact->sliding.is_off_centre || contact->unlike)
        return RWEDGE_OK;
    if (!rw_contact_slides_on(before, contact))
        return begin_to_slide(before, to, contact);
    rw_contact_slide_on(before, contact);
    return RWEDGE_OK;
}

/* The next load of a contact to which a rig prescribes displacements. */
static int32_t apply_driven(rwedge_contact *contact, rw_goal to)
{
    rwedge_contact *next;
    int32_t status = rwedge_contact_copy(contact, &next);
    if (status != RWEDGE_OK)
        return status;
    status = rw_contact_apply_beside(next, to);
    next->drive.b = contact->drive.b; /* it may be one that was kept before the rig began */
    if (status == RWEDGE_OK)
        status = know_slide(contact, to, next);
    if (status == RWEDGE_OK)
        rw_contact_exchange(contact, next);
    rwedge_contact_destroy(next);
    return status;
}

int32_t rw_contact_apply(rwedge_contact *contact, rw_goal to)
{
    return contact->drive.b > 0 ? apply_driven(contact, to) : rw_contact_apply_beside(contact, to);
}

int32_t rwedge_contact_apply(rwedge_contact *contact, double P, double M, double Q, double sigma)
{
    return contact ? rw_contact_apply(contact, rw_goal_of(contact, (rw_loads){P, M, Q, sigma}))
                   : RWEDGE_ENULL;
}

int32_t rwedge_contact_load(rwedge_contact *contact, double P, double Q)
{
    if (!contact)
        return RWEDGE_ENULL;
    const double M = P == 0 ? 0 : contact->loads.M;
    const rw_loads to = {P, M, Q, contact->loads.sigma};
    return rw_contact_apply(contact, rw_goal_of(contact, to));
}
