/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cycle/cycle.h"

#include "base/always.h"

#include <stdlib.h>

/* A step in which P or M changes is cut into PARTS, and where an edge of the contact turns: places
 * that it leaves and meets again slip anew. Where the step ends in separation no edge turns, and
 * its last part is halved again and again, because the contact shrinks to nothing. */
enum { PARTS = 32, HALVINGS = 10, STATES_A_STEP = PARTS + HALVINGS };

static double share_of(int part, int parts)
{
    return part < parts ? (double)part / parts : 1 - ldexp(1.0 / parts, parts - 1 - part);
}

/* Each part costs a computed shear a step. So no part changes P, or M over the half-width, by less
 * than this part of P: a measured log has such noise in every load. */
static const double LEAST_CHANGE = 0.01;

static int parts_of(const rw_state *from, rw_loads to)
{
    if (!from->contact->computed.now || to.P == 0)
        return PARTS;
    const rw_loads old = from->contact->loads;
    const double half = rw_patch_half_width(from->patch);
    const double least = LEAST_CHANGE * old.P, most = PARTS * least;
    const double change =
        fmin(fabs(to.P - old.P), most) + fmin(fabs(to.M - old.M), most * half) / half;
    return (int)fmin(PARTS, ceil(change / least));
}

/* The patch in which a straight step slips nowhere: that of the last corner which both paths have
 * in common, or of the new corner at which the step leaves a segment of the old path. */
static rw_patch stuck_between(const rwedge_contact *before, const rwedge_contact *after)
{
    if (before->computed.now || after->computed.now)
        return (rw_patch){HUGE_VAL, -HUGE_VAL}; /* not known of any place */
    const rw_memory *path = &after->memory;
    const rw_path old = rw_memory_path(&before->memory);
    const size_t common = rw_memory_common(path, &old);
    /* always: a step appends one corner at most, but where it leaves a segment two */
    const bool is_on_segment =
        common + 1 < path->count &&
        ALWAYS(common < old.count && path->corners[common].load < old.corners[common].load &&
               path->corners[common].ratio == old.corners[common].ratio);
    return path->corners[is_on_segment ? common : common - 1].patch;
}

/* Adds the state after a step from the last one. */
static int32_t add_state(rw_cycle *cycle, rw_loads to)
{
    const rwedge_contact *before = cycle->states[cycle->count - 1].contact;
    rw_state *next = &cycle->states[cycle->count];
    int32_t status = rwedge_contact_copy(before, &next->contact);
    if (status != RWEDGE_OK)
        return status;
    cycle->count++; /* to be destroyed */
    status = rwedge_contact_apply(next->contact, to.P, to.M, to.Q, to.sigma);
    if (status != RWEDGE_OK)
        return status;
    const rw_memory *path = &next->contact->memory;
    next->patch = path->count > 1 ? rw_memory_end(path)->patch : (rw_patch){NAN, NAN};
    next->stuck = stuck_between(before, next->contact);
    next->loads = to;
    next->is_load = false;
    return RWEDGE_OK;
}

static void drop_states(rw_cycle *cycle, size_t count)
{
    while (cycle->count > count)
        rwedge_contact_destroy(cycle->states[--cycle->count].contact);
}

static rw_turns turns_of(const rw_state *from, rw_loads to)
{
    const rw_arcs arcs = rw_arcs_of(&from->contact->geometry);
    const rw_patch after = rw_contact_patch_under(from->contact, to);
    return from->contact->loads.P > 0 && !isnan(after.left)
               ? rw_arcs_turns(&arcs, from->patch, after)
               : (rw_turns){{1, 1}};
}

/* Adds the states on the way to a load. Where one of them has no closed form, none is added: the
 * step as a whole has one. On the way to separation the slip is then not known, RWEDGE_EPATH. */
static int32_t add_parts(rw_cycle *cycle, rw_loads to)
{
    const size_t count = cycle->count;
    const rw_loads from = cycle->states[count - 1].contact->loads;
    int32_t status = RWEDGE_OK;
    if (from.P == to.P && from.M == to.M)
        return status;
    const int parts = parts_of(&cycle->states[count - 1], to);
    const int end = to.P == 0 ? STATES_A_STEP : parts;
    const rw_turns turns = turns_of(&cycle->states[count - 1], to);
    double done = 0;
    for (int i = 1; done < 1 && status == RWEDGE_OK;) {
        const double share = i < end ? share_of(i, parts) : 1;
        done = rw_stop_before(&turns, done, share);
        i += done == share;
        if (done < 1)
            status = add_state(cycle, rw_loads_between(from, to, done));
    }
    if (status == RWEDGE_OK || status == RWEDGE_ENOMEM)
        return status;
    drop_states(cycle, count);
    return to.P == 0 ? RWEDGE_EPATH : RWEDGE_OK;
}

static int32_t go_through(const rw_load_history *loads, rw_cycle_use use, rw_cycle *cycle)
{
    int32_t status = RWEDGE_OK;
    for (size_t i = 0; i < loads->count && status == RWEDGE_OK; i++) {
        const rw_loads to = rw_loads_at(loads, i);
        if (use == RW_SLIP_TOO)
            status = add_parts(cycle, to);
        if (status == RWEDGE_OK)
            status = add_state(cycle, to);
        cycle->states[cycle->count - 1].is_load = true;
    }
    for (size_t i = 0; i < cycle->count && status == RWEDGE_OK && use == RW_SLIP_TOO; i++)
        status = rwedge_contact_slip(cycle->states[i].contact, 0, NULL, NULL);
    return status;
}

/* ---- All ---- */

static const double ROUNDING = 1e-12; /* of an edge, in widths of the contact */

int32_t rw_cycle_create(const rwedge_contact *contact, const rw_load_history *loads,
                        rw_cycle_use use, rw_cycle *cycle)
{
    *cycle = (rw_cycle){.loads = loads->count};
    if (loads->count == 0 || loads->count > SIZE_MAX / STATES_A_STEP / sizeof *cycle->states - 1)
        return RWEDGE_ERANGE;
    cycle->states = malloc((loads->count * STATES_A_STEP + 1) * sizeof *cycle->states);
    if (!cycle->states)
        return RWEDGE_ENOMEM;
    rw_state *first = cycle->states;
    *first = (rw_state){.patch = {NAN, NAN}};
    int32_t status = rwedge_contact_copy(contact, &first->contact);
    if (status != RWEDGE_OK)
        return status;
    cycle->count = 1;
    cycle->is_counted = !rw_contact_knows_slip(contact);
    rwedge_contact_edges(contact, &first->patch.left, &first->patch.right);
    if (use == RW_SLIP_TOO)
        status = rw_contact_follow_slip(first->contact);
    if (status == RWEDGE_OK)
        status = go_through(loads, use, cycle);
    for (size_t i = 0; i < cycle->count && status == RWEDGE_OK; i++) {
        const rw_patch patch = cycle->states[i].patch;
        cycle->rounding = fmax(cycle->rounding, ROUNDING * (patch.right - patch.left));
    }
    return status;
}

void rw_cycle_destroy(rw_cycle *cycle)
{
    if (cycle->is_kept)
        return;
    drop_states(cycle, 0);
    free(cycle->states);
}
