/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Off the centre the tractions of a load may have a closed form of which slip or energy have none.
 * If the contact allows errors, the same contact is then kept beside it, as it was before that
 * load. That one computes each load whose slip or energy has no closed form. So tractions have the
 * bits of their closed form, and slip and energy are known. */
#include "loading/beside.h"

#include "computed/beginning.h"
#include "loading/load.h"

/* Whether a closed form of the next load may leave slip or energy unknown. */
static bool may_lose(const rwedge_contact *contact, rw_goal to)
{
    return contact->tolerance > 0 && contact->f > 0 && !contact->unlike &&
           contact->slip.followed == RW_NONE_FOLLOWED && contact->phase != RW_COMPUTED &&
           rw_contact_knows_slip_and_energy(contact) &&
           (rw_contact_is_off_centre(contact) || to.turn != 0 || to.sigma != contact->loads.sigma ||
            !rw_is_symmetric(&contact->geometry));
}

/* The load of the contact that follows slip and energy. Where it cannot be computed, they are not
 * known any more. */
static int32_t follow(rwedge_contact *contact, rw_goal to)
{
    const rw_followed before = contact->slip.followed;
    contact->slip.followed = RW_SLIP_AND_ENERGY_FOLLOWED;
    const int32_t status = rw_contact_apply_alone(contact, to);
    contact->slip.followed = before;
    return status;
}

/* The first load that may lose them. `ahead` has the load. */
static int32_t begin(rwedge_contact *contact, rwedge_contact *ahead, rw_goal to)
{
    const bool loses = ahead->phase == RW_OFF_CENTRE && !rw_contact_knows_slip_and_energy(ahead);
    const bool is_apart = ahead->phase == RW_APART && !ahead->energy.is_known;
    if (!loses && !is_apart) {
        rw_contact_exchange(contact, ahead);
        rwedge_contact_destroy(ahead);
        return RWEDGE_OK;
    }
    const int32_t status = follow(contact, to);
    if (status == RWEDGE_ENOMEM) {
        rwedge_contact_destroy(ahead);
        return status;
    }
    if (is_apart && status == RWEDGE_OK) {
        rwedge_contact_destroy(ahead);
        return status;
    }
    rw_contact_exchange(contact, ahead);
    if (status == RWEDGE_OK)
        ahead = rw_contact_keep_beside(contact, ahead);
    rwedge_contact_destroy(ahead);
    return RWEDGE_OK;
}

/* A load of both. `ahead` has it, and nothing beside it. Where it has no closed form, or neither is
 * loaded any more, the other one is the contact from then on. */
static int32_t go_on(rwedge_contact *contact, rwedge_contact *ahead, rw_goal to)
{
    rwedge_contact *other = contact->beside;
    const int32_t status = follow(other, to);
    if (status == RWEDGE_ENOMEM) {
        rwedge_contact_destroy(ahead);
        return status;
    }
    contact->beside = NULL;
    if (status == RWEDGE_OK && (ahead->phase == RW_COMPUTED || ahead->phase == RW_APART)) {
        rw_contact_exchange(contact, other);
        contact->slip.followed = RW_NONE_FOLLOWED;
    } else {
        rw_contact_exchange(contact, ahead);
        if (status == RWEDGE_OK)
            other = rw_contact_keep_beside(contact, other);
    }
    rwedge_contact_destroy(ahead);
    rwedge_contact_destroy(other);
    return RWEDGE_OK;
}

/* Slip in closed form counts from here where there is no origin. */
int32_t rw_contact_follow_slip(rwedge_contact *contact)
{
    rwedge_contact *beside = contact->beside;
    if (beside) {
        contact->beside = NULL;
        rw_contact_exchange(contact, beside);
        rwedge_contact_destroy(beside);
    }
    rw_slip_record *slip = &contact->slip;
    rw_computed *computed = &contact->computed;
    slip->followed = contact->tolerance > 0 ? RW_SLIP_FOLLOWED : RW_NONE_FOLLOWED;
    if (contact->unlike || slip->followed == RW_NONE_FOLLOWED || rw_contact_knows_slip(contact))
        return RWEDGE_OK;
    const rw_frame frame = rw_contact_frame(contact);
    if (computed->now && !rw_numerical_count_slip(computed->now, &frame, NULL, NULL))
        return RWEDGE_ENOMEM;
    if (computed->start != computed->now)
        rw_numerical_destroy(computed->start); /* its slip is not known */
    computed->start = NULL;
    rw_slip_origins_destroy(&slip->origins);
    contact->drive.slide = (rw_slide){0, 0, 0};
    contact->memory.shared = 0;
    slip->is_known = true;
    slip->settled = rw_memory_end(&contact->memory)->patch;
    return RWEDGE_OK;
}

int32_t rw_contact_apply_beside(rwedge_contact *contact, rw_goal to)
{
    if (!contact->beside && !may_lose(contact, to))
        return rw_contact_apply_alone(contact, to);
    rwedge_contact *ahead;
    int32_t status = rwedge_contact_copy(contact, &ahead);
    if (status != RWEDGE_OK)
        return status;
    rw_contact_drop_beside(ahead);
    status = rw_contact_apply_alone(ahead, to);
    if (status != RWEDGE_OK) {
        rwedge_contact_destroy(ahead);
        return status;
    }
    return contact->beside ? go_on(contact, ahead, to) : begin(contact, ahead, to);
}
