/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How a contact goes through the loads of a cycle. Where P or M changes, states on the way to a
 * load are noted too: a copy of the contact goes there in parts. Loads in whose closed form the
 * slip is not known are computed by a second contact, which goes on beside the first one. */
#include "cycle/states.h"

#include "base/array.h"
#include "base/tuned.h"
#include "history/gap.h"
#include "loading/beside.h"
#include "loading/step_to.h"

#include <stdlib.h>
#include <string.h>

/* ---- The displacement of a state ---- */

/* That of a computed state, without its shift. */
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

double rw_profile_height(const rw_geometry *g, double x)
{
    const rw_arcs arcs = rw_arcs_of(g);
    double sum = 0;
    for (size_t i = 0; i < arcs.count; i++) {
        const rw_arc arc = rw_arc_at(&arcs, i);
        const double from_middle = x - (arc.left + arc.right) / 2, width = arc.right - arc.left;
        sum += rw_arc_weight(&arcs, i) * (x > arc.left && x < arc.right
                                              ? from_middle * (from_middle / width) + width / 4
                                              : fabs(from_middle));
    }
    return sum;
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

/* The slip of a place in contact. */
static double slip_at(const rwedge_contact *c, double x)
{
    double slip = 0;
    rwedge_contact_slip(c, 1, &x, &slip);
    return slip;
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
    return (is_apart ? 0 : slip_at(after, x)) - (stays ? slip_at(before, x) : 0) -
           (displacement_of(after, x) - displacement_of(before, x));
}

/* The inner and the outer end of what the contact has gained, or lost, at an edge. */
static rw_patch ring_of(rw_patch old, rw_patch now, int side)
{
    const bool is_new = isnan(old.left) || !(fmax(old.left, now.left) < fmin(old.right, now.right));
    const double middle = rw_patch_middle(now);
    return side == 0 ? (rw_patch){is_new ? middle : old.left, now.left}
                     : (rw_patch){is_new ? middle : old.right, now.right};
}

/* ---- Steps ---- */

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

static const rw_patch NOWHERE = {HUGE_VAL, -HUGE_VAL};

/* The patch in which a straight step slips nowhere: where the paths before and after it part. That
 * is the last corner that both have in common, or a corner beyond at which one of them leaves the
 * segment that both begin with. Not known of a computed step. */
static rw_patch stuck_between(const rwedge_contact *before, const rwedge_contact *after)
{
    if (before->phase == RW_COMPUTED || after->phase == RW_COMPUTED)
        return NOWHERE;
    const rw_memory *path = &after->memory, *old = &before->memory;
    const rw_path old_path = rw_memory_path(old);
    const size_t common = rw_memory_common(path, &old_path);
    if (common == path->count || common == old->count)
        return path->corners[common - 1].patch;
    const rw_corner *next = &path->corners[common], *next_of_old = &old->corners[common];
    if (next->ratio != next_of_old->ratio)
        return path->corners[common - 1].patch;
    return next->load < next_of_old->load ? next->patch : next_of_old->patch;
}

static rw_patch patch_of(const rwedge_contact *c)
{
    return c->memory.count > 1 ? rw_memory_end(&c->memory)->patch : (rw_patch){NAN, NAN};
}

/* ---- Notes ---- */

static const double ROUNDING = 1e-12; /* of an edge, in widths of the contact */

static rw_state *next_state(rwedge_cycle *cycle)
{
    rw_state *states = rw_grown(cycle->states, cycle->count, &cycle->capacity, 1, sizeof *states);
    if (!states)
        return NULL;
    cycle->states = states;
    return &states[cycle->count];
}

/* What happens at the edges in the step. */
static void note_edges(rw_state *next, const rwedge_contact *before, const rwedge_contact *after,
                       rw_patch old)
{
    for (int side = 0; side < 2; side++) {
        const rw_patch ring = ring_of(old, next->patch, side);
        const bool grows = rw_patch_has(next->patch, ring.left) && ring.left != ring.right;
        const bool shrinks = rw_patch_has(old, ring.right) && ring.left != ring.right;
        for (int k = 0; k < RW_RING && grows; k++)
            next->ring[side][k] =
                slip_at(after, ring.left + (ring.right - ring.left) * rw_ring_node(k));
        if (shrinks && !grows)
            next->leave[side] = slip_at(after, ring.right) - slip_at(before, ring.right);
    }
}

/* Of the tolerance, the mean pressure and the compliance: the error of a computed slip. */
static const double SLIP_NOISE = 0.5;

/* Where a computed state sticks. */
static bool note_sticks(rw_state *next, const rwedge_contact *after)
{
    const rw_zones zones = rw_contact_zones(after);
    next->noise = SLIP_NOISE * after->tolerance * after->f * after->geometry.A * after->loads.P;
    next->sticks = malloc(RW_MOST_ZONES * sizeof *next->sticks);
    for (int i = 0; next->sticks && i < zones.count; i++)
        if (zones.zone[i].label == 0)
            next->sticks[next->stick_count++] = (rw_patch){zones.zone[i].left, zones.zone[i].right};
    return next->sticks != NULL;
}

/* Notes a state for slip, which may be computed beside the contact; `lender` as in
 * rw_record_add(), of the contact alone. */
static int32_t note(rwedge_cycle *cycle, const rwedge_contact *from, const rwedge_contact *to,
                    const rw_entry *lender)
{
    const rwedge_contact *before = from ? rw_contact_of_slip(from) : NULL,
                         *after = rw_contact_of_slip(to);
    const rw_entry *same = after == to ? lender : NULL;
    rw_state *next = next_state(cycle);
    if (!next || !rw_record_add(&cycle->on_the_way, after, same))
        return RWEDGE_ENOMEM;
    *next = (rw_state){.patch = patch_of(after), .is_computed = after->phase == RW_COMPUTED};
    cycle->count++;
    if (next->is_computed && !note_sticks(next, after))
        return RWEDGE_ENOMEM;
    if (!isnan(next->patch.left))
        cycle->rounding = fmax(cycle->rounding, ROUNDING * (next->patch.right - next->patch.left));
    next->displacement.slope = slope_of(after);
    if (!before)
        return RWEDGE_OK;
    next->stuck = stuck_between(before, after);
    const rw_patch old = patch_of(before);
    next->displacement.shift = next[-1].displacement.shift + move_of(before) +
                               shift_between(before, after, old, next->patch) - move_of(after);
    if (!isnan(next->patch.left))
        note_edges(next, before, after, old);
    return RWEDGE_OK;
}

/* ---- The way ---- */

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

/* Goes on, and notes the state. */
static int32_t go_part(rwedge_cycle *cycle, rwedge_contact *going, rw_goal to)
{
    rwedge_contact *before;
    int32_t status = rwedge_contact_copy(going, &before);
    if (status != RWEDGE_OK)
        return status;
    status = rw_contact_apply(going, to);
    if (status == RWEDGE_OK && !rw_contact_knows_slip(going))
        status = RWEDGE_EPATH;
    if (status == RWEDGE_OK)
        status = note(cycle, before, going, NULL);
    rwedge_contact_destroy(before);
    return status;
}

/* Goes along the way to a load, but not to the load itself, and notes the states. It ends where one
 * of them has no closed form: the step as a whole has one. On the way to separation the slip is
 * then not known, RWEDGE_EPATH. */
static int32_t go_parts(rwedge_cycle *cycle, rwedge_contact *going, rw_goal to)
{
    const rw_goal from = rw_goal_of(going, going->loads);
    const rw_patch old = patch_of(going), now = rw_contact_patch_under(going, to);
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
            status = go_part(cycle, going, goal_between(from, to, done));
    }
    return status == RWEDGE_OK || status == RWEDGE_ENOMEM ? status
           : to.P == 0                                    ? RWEDGE_EPATH
                                                          : RWEDGE_OK;
}

/* ---- Loads ---- */

/* The contact, a copy that goes ahead to each load in parts, and the one that goes on where the
 * contact does not know its slip: NULL where there is none. */
typedef struct {
    rwedge_contact *contact, *ahead, *follower;
    rw_stuck_zones stuck;
} walk;

/* What the whole step leaves stuck has stuck in its parts too. */
static void stick_in_parts(rwedge_cycle *cycle, size_t from, rw_patch stuck)
{
    for (size_t i = from; i < cycle->count; i++) {
        rw_patch *own = &cycle->states[i].stuck;
        if (stuck.right - stuck.left > own->right - own->left && !cycle->states[i].is_computed)
            *own = stuck;
    }
}

/* The slip of a load that the contact has gone to, or which the follower computes. */
static int32_t follow_slip(rwedge_cycle *cycle, walk *w, rw_goal to)
{
    if (!w->follower && rw_contact_knows_slip(w->contact)) {
        const rw_entry *lender = &cycle->at_loads.entries[cycle->at_loads.count - 1];
        return note(cycle, w->ahead, w->contact, lender);
    }
    if (!w->follower) {
        w->follower = w->ahead;
        w->ahead = NULL;
    }
    const int32_t status = rw_contact_follow_slip(w->follower);
    return status == RWEDGE_OK ? go_part(cycle, w->follower, to) : status;
}

/* All places slip alike, under the loads that the contact has. */
static int32_t slide_on(rwedge_cycle *cycle, const walk *w, double slid)
{
    const rwedge_contact *contact = w->follower ? w->follower : w->contact;
    if (slid == 0 || cycle->slip_status != RWEDGE_OK)
        return RWEDGE_OK;
    const int32_t status = note(cycle, contact, contact, NULL);
    if (status == RWEDGE_OK) {
        rw_state *last = &cycle->states[cycle->count - 1];
        last->displacement.shift -= slid;
        last->stuck = NOWHERE;
    }
    return status;
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

/* RWEDGE_EPATH, or another reason, of the slip is not one of the load. `slid`: by a rig besides. */
static int32_t go_to(rwedge_cycle *cycle, walk *w, rw_goal to, double slid)
{
    const double slid_first = slid_before(w->contact, slid);
    rwedge_contact *before = NULL;
    rwedge_contact_destroy(w->ahead);
    w->ahead = NULL;
    int32_t status = slide_on(cycle, w, slid_first);
    const size_t first = cycle->count;
    if (status == RWEDGE_OK)
        status = rwedge_contact_copy(w->contact, &w->ahead);
    if (status == RWEDGE_OK && rw_contact_knows_slip(w->ahead))
        status = rw_contact_follow_slip(w->ahead);
    if (status == RWEDGE_OK && cycle->slip_status == RWEDGE_OK)
        cycle->slip_status = go_parts(cycle, w->follower ? w->follower : w->ahead, to);
    if (status == RWEDGE_OK)
        status = rwedge_contact_copy(w->contact, &before);
    if (status == RWEDGE_OK)
        status = rw_contact_apply(w->contact, to);
    if (status == RWEDGE_OK && !(rw_record_add(&cycle->at_loads, w->contact, NULL) &&
                                 rw_edges_add(&cycle->edges, w->contact)))
        status = RWEDGE_ENOMEM;
    if (status == RWEDGE_OK) {
        const rw_patch stuck = stuck_between(before, w->contact);
        note_half_width(cycle, rwedge_contact_half_width(w->contact));
        if (cycle->slip_status == RWEDGE_OK)
            cycle->slip_status = follow_slip(cycle, w, to);
        stick_in_parts(cycle, first, w->follower ? (rw_patch){0, 0} : stuck);
        if (cycle->count > first)
            cycle->states[cycle->count - 1].is_load = true;
        if (!rw_stuck_go_on(&w->stuck, w->contact, slid != 0 ? NOWHERE : stuck, cycle->rounding))
            status = RWEDGE_ENOMEM;
    }
    if (status == RWEDGE_OK)
        status = slide_on(cycle, w, slid - slid_first);
    rwedge_contact_destroy(before);
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
        status = note(cycle, NULL, w->follower ? w->follower : w->contact, NULL);
    return status;
}

static int32_t go_through(rwedge_cycle *cycle)
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

/* ---- Life ---- */

static bool keep_loads(rwedge_cycle *cycle, const rw_load_history *loads)
{
    const size_t n = loads->count;
    double *all = malloc(4 * n * sizeof *all);
    if (!all)
        return false;
    memcpy(all, loads->P, n * sizeof *all);
    memcpy(all + n, loads->M, n * sizeof *all);
    memcpy(all + 2 * n, loads->Q, n * sizeof *all);
    memcpy(all + 3 * n, loads->sigma, n * sizeof *all);
    cycle->loads = (rw_load_history){n, all, all + n, all + 2 * n, all + 3 * n};
    return true;
}

/* The cycle takes the distances. */
static int32_t create(const rwedge_contact *contact, const rw_load_history *loads, bool is_guided,
                      double *slid, rwedge_cycle **cycle)
{
    rwedge_cycle *created = calloc(1, sizeof *created);
    if (!created) {
        free(slid);
        return RWEDGE_ENOMEM;
    }
    created->is_guided = is_guided;
    created->slid = slid;
    int32_t status =
        keep_loads(created, loads) ? rwedge_contact_copy(contact, &created->before) : RWEDGE_ENOMEM;
    if (status == RWEDGE_OK)
        status = go_through(created);
    if (status == RWEDGE_OK)
        *cycle = created;
    else
        rwedge_cycle_destroy(created);
    return status;
}

int32_t rwedge_cycle_create(const rwedge_contact *contact, size_t loads, const double P[],
                            const double M[], const double Q[], const double sigma[],
                            rwedge_cycle **cycle)
{
    const rw_load_history history = {loads, P, M, Q, sigma};
    if (!contact || !rw_is_load_history(&history) || !cycle)
        return RWEDGE_ENULL;
    if (loads == 0 || loads > SIZE_MAX / 4 / sizeof *P)
        return RWEDGE_ERANGE;
    return create(contact, &history, false, NULL, cycle);
}

int32_t rwedge_cycle_create_driven(const rwedge_contact *contact, size_t loads, const double P[],
                                   const double M[], const double sigma[],
                                   const double displacement[], double compliance,
                                   rwedge_cycle **cycle)
{
    if (!contact || (loads > 0 && (!P || !M || !sigma || !displacement)) || !cycle)
        return RWEDGE_ENULL;
    if (loads == 0 || loads > SIZE_MAX / 4 / sizeof *P)
        return RWEDGE_ERANGE;
    const rw_rig_history rig = {loads, P, M, sigma, displacement, compliance};
    double *Q = malloc(loads * sizeof *Q), *slid = malloc(loads * sizeof *slid);
    int32_t status = Q && slid ? rw_drive_through(contact, &rig, Q, slid) : RWEDGE_ENOMEM;
    if (status == RWEDGE_OK) {
        const rw_load_history history = {loads, P, M, Q, sigma};
        status = create(contact, &history, false, slid, cycle);
    } else
        free(slid);
    free(Q);
    return status;
}

int32_t rwedge_cycle_create_guided(const rwedge_contact *contact, size_t loads, const double P[],
                                   const double tilt[], const double Q[], const double sigma[],
                                   rwedge_cycle **cycle)
{
    if (!contact || (loads > 0 && (!P || !tilt || !Q || !sigma)) || !cycle)
        return RWEDGE_ENULL;
    if (loads == 0 || loads > SIZE_MAX / 4 / sizeof *P)
        return RWEDGE_ERANGE;
    for (size_t i = 0; i < loads; i++)
        if (!rw_can_be_guided(contact, tilt[i]))
            return RWEDGE_EDOMAIN;
    double *turn = malloc(loads * sizeof *turn);
    if (!turn)
        return RWEDGE_ENOMEM;
    for (size_t i = 0; i < loads; i++)
        turn[i] = rw_as_held(&contact->geometry, tilt[i]);
    const rw_load_history history = {loads, P, turn, Q, sigma};
    const int32_t status = create(contact, &history, true, NULL, cycle);
    free(turn);
    return status;
}

void rwedge_cycle_destroy(rwedge_cycle *cycle)
{
    if (!cycle)
        return;
    rwedge_contact_destroy(cycle->before);
    free((double *)cycle->loads.P);
    free(cycle->slid);
    rw_record_destroy(&cycle->on_the_way);
    rw_record_destroy(&cycle->at_loads);
    for (size_t i = 0; i < cycle->count; i++)
        free(cycle->states[i].sticks);
    free(cycle->states);
    free(cycle->edges.all);
    free(cycle);
}

size_t rwedge_cycle_loads(const rwedge_cycle *cycle)
{
    return cycle ? cycle->loads.count : 0;
}

int32_t rwedge_cycle_forces(const rwedge_cycle *cycle, size_t loads, double Q[])
{
    if (!cycle || (loads > 0 && !Q))
        return RWEDGE_ENULL;
    if (loads != cycle->loads.count)
        return RWEDGE_ERANGE;
    memcpy(Q, cycle->loads.Q, loads * sizeof *Q);
    return RWEDGE_OK;
}
