/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The states of a cycle that a contact keeps until its next load, for calls with the same loads.
 * There is one list for stresses and one for slip, because a load that is cut into parts ends in
 * other bits. */
#include "cycle/cycle.h"

#include <stdlib.h>

typedef struct {
    rw_cycle cycle[RW_CYCLE_USES];
    int32_t status[RW_CYCLE_USES];
} kept_cycle;

static void destroy(void *of_contact)
{
    kept_cycle *kept = of_contact;
    for (int use = 0; use < RW_CYCLE_USES; use++)
        rw_cycle_destroy(&kept->cycle[use]);
    free(kept);
}

/* What the contact keeps of these loads; NULL where it keeps nothing. The list for stresses has one
 * state for each load. */
static const kept_cycle *kept_of(const rwedge_contact *contact, const rw_load_history *loads)
{
    const kept_cycle *kept = contact->kept;
    bool same = kept && kept->cycle[RW_STRESS_ALONE].loads == loads->count;
    for (size_t i = 0; same && i < loads->count; i++) {
        const rw_loads to = rw_loads_at(loads, i),
                       other = kept->cycle[RW_STRESS_ALONE].states[i + 1].loads;
        same = to.P == other.P && to.M == other.M && to.Q == other.Q && to.sigma == other.sigma;
    }
    return same ? kept : NULL;
}

int32_t rw_cycle_of(const rwedge_contact *contact, const rw_load_history *loads, rw_cycle_use use,
                    rw_cycle *cycle)
{
    const kept_cycle *kept = kept_of(contact, loads);
    if (!kept)
        return rw_cycle_create(contact, loads, use, cycle);
    *cycle = kept->cycle[use];
    cycle->is_kept = true;
    return kept->status[use];
}

/* RWEDGE_EPATH for the slip is kept as a result too. */
static int32_t go_through(const rwedge_contact *contact, const rw_load_history *loads,
                          kept_cycle *kept)
{
    int32_t status = RWEDGE_OK;
    for (int i = 0; i < RW_CYCLE_USES && status == RWEDGE_OK; i++) {
        status = rw_cycle_create(contact, loads, (rw_cycle_use)i, &kept->cycle[i]);
        kept->status[i] = status;
    }
    return status == RWEDGE_ENOMEM ? status : kept->status[RW_STRESS_ALONE];
}

int32_t rwedge_contact_keep_cycle(rwedge_contact *contact, size_t loads, const double P[],
                                  const double M[], const double Q[], const double sigma[])
{
    const rw_load_history history = {loads, P, M, Q, sigma};
    if (!contact || !rw_is_load_history(&history))
        return RWEDGE_ENULL;
    if (kept_of(contact, &history))
        return RWEDGE_OK;
    kept_cycle *kept = calloc(1, sizeof *kept);
    if (!kept)
        return RWEDGE_ENOMEM;
    const int32_t status = go_through(contact, &history, kept);
    if (status == RWEDGE_OK) {
        rw_contact_drop_kept(contact);
        contact->kept = kept;
        contact->destroy_kept = destroy;
    } else {
        destroy(kept);
    }
    return status;
}
