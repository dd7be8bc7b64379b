/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cycle/cycle.h"

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

/* The patch in which a straight step slips nowhere: where the paths before and after it part. That
 * is the last corner that both have in common, or a corner beyond at which one of them leaves the
 * segment that both begin with. */
static rw_patch stuck_between(const rwedge_contact *before, const rwedge_contact *after)
{
    if (before->computed.now || after->computed.now)
        return (rw_patch){HUGE_VAL, -HUGE_VAL}; /* not known of any place */
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

/* Adds the state after a step from the last one. */
static int32_t add_state(rw_states *all, rw_loads to)
{
    const rwedge_contact *before = all->states[all->count - 1].contact;
    rw_state *next = &all->states[all->count];
    int32_t status = rwedge_contact_copy(before, &next->contact);
    if (status != RWEDGE_OK)
        return status;
    all->count++; /* to be destroyed */
    status = rwedge_contact_apply(next->contact, to.P, to.M, to.Q, to.sigma);
    if (status != RWEDGE_OK)
        return status;
    const rw_memory *path = &next->contact->memory;
    next->patch = path->count > 1 ? rw_memory_end(path)->patch : (rw_patch){NAN, NAN};
    next->stuck = stuck_between(before, next->contact);
    next->is_computed = before->phase == RW_COMPUTED || next->contact->phase == RW_COMPUTED;
    next->loads = to;
    next->is_load = false;
    return RWEDGE_OK;
}

static void drop_states(rw_states *all, size_t count)
{
    while (all->count > count)
        rwedge_contact_destroy(all->states[--all->count].contact);
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
static int32_t add_parts(rw_states *all, rw_loads to)
{
    const size_t count = all->count;
    const rw_loads from = all->states[count - 1].contact->loads;
    int32_t status = RWEDGE_OK;
    if (from.P == to.P && from.M == to.M)
        return status;
    const int parts = parts_of(&all->states[count - 1], to);
    const int end = to.P == 0 ? STATES_A_STEP : parts;
    const rw_turns turns = turns_of(&all->states[count - 1], to);
    double done = 0;
    for (int i = 1; done < 1 && status == RWEDGE_OK;) {
        const double share = i < end ? share_of(i, parts) : 1;
        done = rw_stop_before(&turns, done, share);
        i += done == share;
        if (done < 1)
            status = add_state(all, rw_loads_between(from, to, done));
    }
    if (status == RWEDGE_OK || status == RWEDGE_ENOMEM)
        return status;
    drop_states(all, count);
    return to.P == 0 ? RWEDGE_EPATH : RWEDGE_OK;
}

static int32_t go_through(const rw_load_history *loads, bool is_cut, rw_states *all)
{
    int32_t status = RWEDGE_OK;
    for (size_t i = 0; i < loads->count && status == RWEDGE_OK; i++) {
        const rw_loads to = rw_loads_at(loads, i);
        if (is_cut)
            status = add_parts(all, to);
        if (status == RWEDGE_OK)
            status = add_state(all, to);
        all->states[all->count - 1].is_load = true;
    }
    for (size_t i = 0; i < all->count && status == RWEDGE_OK && is_cut; i++)
        status = rwedge_contact_slip(all->states[i].contact, 0, NULL, NULL);
    return status;
}

/* ---- All ---- */

static const double ROUNDING = 1e-12; /* of an edge, in widths of the contact */

/* What is made so far is to be destroyed after an error too. */
static int32_t create_states(const rwedge_contact *contact, const rw_load_history *loads,
                             bool is_cut, rw_states *all)
{
    *all = (rw_states){.loads = loads->count};
    if (loads->count == 0 || loads->count > SIZE_MAX / STATES_A_STEP / sizeof *all->states - 1)
        return RWEDGE_ERANGE;
    all->states = malloc((loads->count * STATES_A_STEP + 1) * sizeof *all->states);
    if (!all->states)
        return RWEDGE_ENOMEM;
    rw_state *first = all->states;
    *first = (rw_state){.patch = {NAN, NAN}};
    int32_t status = rwedge_contact_copy(contact, &first->contact);
    if (status != RWEDGE_OK)
        return status;
    all->count = 1;
    all->is_counted = !rw_contact_knows_slip(contact);
    rwedge_contact_edges(contact, &first->patch.left, &first->patch.right);
    if (is_cut)
        status = rw_contact_follow_slip(first->contact);
    if (status == RWEDGE_OK)
        status = go_through(loads, is_cut, all);
    for (size_t i = 0; i < all->count && status == RWEDGE_OK; i++) {
        const rw_patch patch = all->states[i].patch;
        all->rounding = fmax(all->rounding, ROUNDING * (patch.right - patch.left));
    }
    return status;
}

static void destroy_states(rw_states *all)
{
    drop_states(all, 0);
    free(all->states);
}

int32_t rwedge_cycle_create(const rwedge_contact *contact, size_t loads, const double P[],
                            const double M[], const double Q[], const double sigma[],
                            rwedge_cycle **cycle)
{
    const rw_load_history history = {loads, P, M, Q, sigma};
    if (!contact || !rw_is_load_history(&history) || !cycle)
        return RWEDGE_ENULL;
    rwedge_cycle *created = calloc(1, sizeof *created);
    if (!created)
        return RWEDGE_ENOMEM;
    int32_t status = create_states(contact, &history, false, &created->at_loads);
    if (status == RWEDGE_OK) {
        created->slip_status = create_states(contact, &history, true, &created->on_the_way);
        status = created->slip_status == RWEDGE_ENOMEM ? RWEDGE_ENOMEM : RWEDGE_OK;
    }
    if (status == RWEDGE_OK)
        *cycle = created;
    else
        rwedge_cycle_destroy(created);
    return status;
}

void rwedge_cycle_destroy(rwedge_cycle *cycle)
{
    if (!cycle)
        return;
    destroy_states(&cycle->at_loads);
    destroy_states(&cycle->on_the_way);
    free(cycle);
}

size_t rwedge_cycle_loads(const rwedge_cycle *cycle)
{
    return cycle ? cycle->at_loads.loads : 0;
}
