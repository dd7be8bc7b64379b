/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A pad that a rig holds at a tilt. Load and tilt determine the contact as load and moment do. */
#include "loading/apply.h"
#include "loading/step_to.h"

/* The present tilt. Apart, a pad that is not held is as its profile was given. */
static double present_tilt(const rwedge_contact *c)
{
    return c->phase != RW_APART ? rw_memory_end(&c->memory)->tilt
           : c->is_held         ? c->held_tilt
                                : rw_as_held(&c->geometry, 0);
}

/* A computed shear begins a new line, on which something else goes straight. The line from touching
 * was another one, unless the pad has not turned. RWEDGE_ENOMEM. */
static int32_t begin_line(rw_computed *computed, double turn, bool is_level)
{
    bool is_whole = true;
    rw_numerical *now = computed->now, *start = rw_numerical_copy(now, &is_whole);
    if (!is_whole) {
        rw_numerical_destroy(start);
        return RWEDGE_ENOMEM;
    }
    rw_numerical_destroy(computed->start);
    computed->start = start;
    computed->strayed = 0;
    now->now.at.turn = start->now.at.turn = turn;
    now->now.is_still = start->now.is_still = now->now.is_still && is_level;
    return RWEDGE_OK;
}

static int32_t hold(rwedge_contact *c, bool is_held)
{
    if (!c || c->is_held == is_held)
        return RWEDGE_OK;
    const double tilt = present_tilt(c), moment = rw_as_length(&c->geometry, c->loads.M);
    int32_t status = hold(c->beside, is_held);
    if (status == RWEDGE_OK)
        status = hold(c->computed.exact, is_held);
    if (status == RWEDGE_OK && c->phase == RW_COMPUTED)
        status = begin_line(&c->computed, is_held ? tilt : moment, tilt == 0 && moment == 0);
    if (status == RWEDGE_OK) {
        c->is_held = is_held;
        c->held_tilt = is_held ? tilt : 0;
    }
    return status;
}

/* A copy is turned, so that an error leaves all as it was. */
int32_t rwedge_contact_set_rotation(rwedge_contact *contact, int32_t held)
{
    if (!contact)
        return RWEDGE_ENULL;
    if (held < 0 || held > 1 || (held && !(fabs(present_tilt(contact)) < RW_LARGEST_TILT)))
        return RWEDGE_EDOMAIN;
    rwedge_contact *copy;
    int32_t status = rwedge_contact_copy(contact, &copy);
    if (status != RWEDGE_OK)
        return status;
    status = hold(copy, held);
    if (status == RWEDGE_OK)
        rw_contact_exchange(contact, copy);
    rwedge_contact_destroy(copy);
    return status;
}

bool rw_can_be_guided(const rwedge_contact *c, double tilt)
{
    return c->is_held && rw_is_signed(tilt) && isless(fabs(tilt), RW_HALF_PI) &&
           isless(fabs(rw_as_held(&c->geometry, tilt)), RW_LARGEST_TILT);
}

int32_t rwedge_contact_guide(rwedge_contact *contact, double P, double tilt, double Q, double sigma)
{
    if (!contact)
        return RWEDGE_ENULL;
    if (!rw_can_be_guided(contact, tilt))
        return RWEDGE_EDOMAIN;
    const rw_goal to = {P, rw_as_held(&contact->geometry, tilt), Q, sigma};
    return rw_contact_apply(contact, to);
}
