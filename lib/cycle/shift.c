/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far the surfaces have moved tangentially against each other: how its slope and its shift go
 * on from state to state. */
#include "cycle/shift.h"

#include "history/gap.h"

double rw_slip_at(const rwedge_contact *c, double x)
{
    double slip = 0;
    rwedge_contact_slip(c, 1, &x, &slip);
    return slip;
}

/* The displacement in a computed state, without its shift. */
static double computed_displacement(const rwedge_contact *c, double x)
{
    return c->geometry.theta * rw_displacement_of(&c->computed.now->now, x);
}

/* What the zones of a computed state that stick have moved. */
static double move_of(const rwedge_contact *c)
{
    return c->phase == RW_COMPUTED ? c->geometry.theta * c->computed.now->now.move : 0;
}

/* The sum over the patches is of their gap less the height of the profile; where all has stuck
 * since the bodies touched, what is left is linear. */
static double slope_of(const rwedge_contact *c)
{
    const rw_memory *path = &c->memory;
    const double unit = c->f * c->geometry.theta;
    if (c->phase == RW_COMPUTED)
        return c->geometry.theta * c->computed.now->now.at.stretch;
    const double ratio = path->count > 1 ? path->corners[1].ratio : 0;
    return unit * (ratio * path->corners[0].tilt - path->corners[0].stretch);
}

static double closed_displacement(const rwedge_contact *c, double x)
{
    const double height = rw_profile_height(&c->geometry, x);
    double sum = 0;
    for (size_t i = 1; i < c->memory.count; i++) {
        const rw_patch patch = c->memory.corners[i].patch;
        sum += rw_patch_weight(&c->memory, i) * (rw_patch_gap(&c->geometry, patch, x) - height);
    }
    return c->f * c->geometry.theta * sum + slope_of(c) * x;
}

static double displacement_of(const rwedge_contact *c, double x)
{
    return c->phase == RW_COMPUTED ? computed_displacement(c, x) : closed_displacement(c, x);
}

/* A place of both patches, or of the second alone. */
static double place_in(rw_patch before, rw_patch after)
{
    const double left = fmax(before.left, after.left), right = fmin(before.right, after.right);
    return left < right ? (left + right) / 2 : rw_patch_middle(after);
}

/* By how much the shift changes from a state to the next one: displacement and slip of a place that
 * stays in contact change alike; one that comes anew has slipped since it did. What separates meets
 * again where it was. */
static double shift_between(const rwedge_contact *before, const rwedge_contact *after, rw_patch old,
                            rw_patch now)
{
    const bool is_apart = isnan(now.left);
    const double x = is_apart ? rw_patch_middle(old) : place_in(old, now);
    const bool stays = !is_apart && rw_patch_has(old, x);
    if (is_apart && isnan(old.left))
        return 0;
    if (stays && before->phase == RW_COMPUTED && after->phase == RW_COMPUTED)
        return after->geometry.theta * (rw_traction_at(&after->computed.now->origin, x) -
                                        rw_traction_at(&before->computed.now->origin, x));
    return (is_apart ? 0 : rw_slip_at(after, x)) - (stays ? rw_slip_at(before, x) : 0) -
           (displacement_of(after, x) - displacement_of(before, x));
}

rw_displacement rw_first_displacement(const rwedge_contact *contact)
{
    return (rw_displacement){slope_of(contact), 0};
}

rw_displacement rw_next_displacement(rw_displacement last, const rwedge_contact *before,
                                     const rwedge_contact *after)
{
    const rw_patch old = rw_patch_of(before), now = rw_patch_of(after);
    const double shift =
        last.shift + move_of(before) + shift_between(before, after, old, now) - move_of(after);
    return (rw_displacement){slope_of(after), shift};
}
