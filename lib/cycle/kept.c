/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The states of a cycle that a contact keeps until its next load, for calls with the same loads.
 * There is one list for stresses and one for slip, because a load that is cut into parts ends in
 * other bits. */
#include "cycle/cycle.h"

#include <stdlib.h>
#include <string.h>

enum { LISTS = 4 };

typedef struct {
    size_t count;
    double *loads; /* all P, then M, Q and sigma */
    rw_cycle cycle[RW_CYCLE_USES];
    int32_t status[RW_CYCLE_USES];
} kept_cycle;

static void destroy(void *of_contact)
{
    kept_cycle *kept = of_contact;
    for (int use = 0; use < RW_CYCLE_USES; use++)
        rw_cycle_destroy(&kept->cycle[use]);
    free(kept->loads);
    free(kept);
}

static bool is_same(const kept_cycle *kept, const rw_load_history *loads)
{
    const double *const list[LISTS] = {loads->P, loads->M, loads->Q, loads->sigma};
    bool same = kept->count == loads->count;
    for (int i = 0; i < LISTS && same; i++)
        same = memcmp(kept->loads + (size_t)i * kept->count, list[i],
                      kept->count * sizeof *kept->loads) == 0;
    return same;
}

const rw_cycle *rw_kept_cycle(const rwedge_contact *contact, const rw_load_history *loads,
                              rw_cycle_use use, int32_t *status)
{
    const kept_cycle *kept = contact->kept;
    if (!kept || !is_same(kept, loads))
        return NULL;
    *status = kept->status[use];
    return &kept->cycle[use];
}

static kept_cycle *create(const rw_load_history *loads)
{
    kept_cycle *kept = calloc(1, sizeof *kept);
    double *copy = malloc(LISTS * loads->count * sizeof *copy);
    if (!kept || !copy) {
        free(kept);
        free(copy);
        return NULL;
    }
    const double *const list[LISTS] = {loads->P, loads->M, loads->Q, loads->sigma};
    for (int i = 0; i < LISTS; i++)
        memcpy(copy + (size_t)i * loads->count, list[i], loads->count * sizeof *copy);
    kept->count = loads->count;
    kept->loads = copy;
    return kept;
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
    if (loads == 0 || loads > SIZE_MAX / LISTS / sizeof *P)
        return RWEDGE_ERANGE;
    int32_t status;
    if (rw_kept_cycle(contact, &history, RW_STRESS_ALONE, &status))
        return status;
    kept_cycle *kept = create(&history);
    status = kept ? go_through(contact, &history, kept) : RWEDGE_ENOMEM;
    if (status == RWEDGE_OK) {
        rw_contact_drop_kept(contact);
        contact->kept = kept;
        contact->destroy_kept = destroy;
    } else if (kept) {
        destroy(kept);
    }
    return status;
}
