/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The way to a load, on which P or M changes: it is cut into parts, and the states between them are
 * noted. */
#include "cycle/parts.h"

#include "base/tuned.h"
#include "loading/apply.h"
#include "loading/step_to.h"

/* A step in which P or M changes is cut into parts, and where an edge of the contact turns: places
 * that it leaves and meets again slip anew. Where the step ends in separation no edge turns, and
 * its last part is halved again and again, because the contact shrinks to nothing. */
enum { PARTS = 32, HALVINGS = 10, MOST_PARTS = 128, MOST_COMPUTED = 48 };

static double share_of(int part, int parts)
{
    return part < parts ? (double)part / parts : 1 - ldexp(1.0 / parts, parts - 1 - part);
}

/* In a part an edge moves little: a measured log has such noise in every load. */
static int parts_of(const rwedge_contact *from, rw_patch old, rw_patch now)
{
    if (isnan(now.left) || isnan(old.left))
        return PARTS;
    const bool is_computed = from->phase == RW_COMPUTED;
    const double moved = fmax(fabs(now.left - old.left), fabs(now.right - old.right)) /
                         fmax(rw_patch_half_width(now), rw_patch_half_width(old));
    const double parts = ceil(moved / (is_computed ? RW_COMPUTED_EDGE_MOVE : RW_EDGE_MOVE));
    return (int)fmax(1, fmin(parts, is_computed ? MOST_COMPUTED : MOST_PARTS));
}

/* A pad that is held turns where it is guided. */
static rw_turns turns_of(const rwedge_contact *from, bool is_turned, rw_patch old, rw_patch now)
{
    const rw_arcs arcs = rw_arcs_of(&from->geometry);
    const bool is_straight = (from->is_held && !is_turned) || isnan(old.left) || isnan(now.left);
    return is_straight     ? (rw_turns){{1, 1}}
           : from->is_held ? rw_arcs_turns_of_tilt(&arcs, old, now)
                           : rw_arcs_turns(&arcs, old, now);
}

static rw_goal goal_between(rw_goal from, rw_goal to, double part)
{
    return (rw_goal){from.P + (to.P - from.P) * part, from.turn + (to.turn - from.turn) * part,
                     from.Q + (to.Q - from.Q) * part, from.sigma + (to.sigma - from.sigma) * part};
}

int32_t rw_go_part(rwedge_cycle *cycle, rwedge_contact *going, rw_goal to)
{
    rwedge_contact *before;
    int32_t status = rwedge_contact_copy(going, &before);
    if (status != RWEDGE_OK)
        return status;
    status = rw_contact_apply(going, to);
    if (status == RWEDGE_OK && !rw_contact_knows_slip(going))
        status = RWEDGE_EPATH;
    if (status == RWEDGE_OK)
        status = rw_note_state(cycle, before, going, NULL);
    rwedge_contact_destroy(before);
    return status;
}

int32_t rw_go_parts(rwedge_cycle *cycle, rwedge_contact *going, rw_goal to)
{
    const rw_goal from = rw_goal_of(going, going->loads);
    const rw_patch old = rw_patch_of(going), now = rw_contact_patch_under(going, to);
    int32_t status = RWEDGE_OK;
    if (from.P == to.P && from.turn == to.turn)
        return status;
    const int parts = parts_of(going, old, now), end = to.P == 0 ? parts + HALVINGS : parts;
    const rw_turns turns = turns_of(going, from.turn != to.turn, old, now);
    double done = 0;
    for (int i = 1; done < 1 && status == RWEDGE_OK;) {
        const double share = i < end ? share_of(i, parts) : 1;
        done = rw_stop_before(&turns, done, share);
        i += done == share;
        if (done < 1)
            status = rw_go_part(cycle, going, goal_between(from, to, done));
    }
    return status == RWEDGE_OK || status == RWEDGE_ENOMEM ? status
           : to.P == 0                                    ? RWEDGE_EPATH
                                                          : RWEDGE_OK;
}
