/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The life of a cycle: of loads, of what a rig prescribes, or of a pad that is guided. */
#include "cycle/walk.h"

#include "loading/step_to.h"

#include <stdlib.h>
#include <string.h>

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

/* What a rig does in a cycle: the half-width that its displacements count from, 0 for no rig, and
 * how far the bodies slide beside each load. The cycle takes the distances. */
typedef struct {
    double b, *slid;
} rig_way;

static const rig_way NO_RIG = {0, NULL};

static int32_t create(const rwedge_contact *contact, const rw_load_history *loads, bool is_guided,
                      rig_way rig, rwedge_cycle **cycle)
{
    rwedge_cycle *created = calloc(1, sizeof *created);
    if (!created) {
        free(rig.slid);
        return RWEDGE_ENOMEM;
    }
    created->is_guided = is_guided;
    created->slid = rig.slid;
    int32_t status =
        keep_loads(created, loads) ? rwedge_contact_copy(contact, &created->before) : RWEDGE_ENOMEM;
    if (status == RWEDGE_OK && rig.b > 0)
        created->before->drive.b = rig.b;
    if (status == RWEDGE_OK)
        status = rw_go_through(created);
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
    return create(contact, &history, false, NO_RIG, cycle);
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
    double *Q = malloc(loads * sizeof *Q);
    rig_way way = {0, malloc(loads * sizeof *way.slid)};
    int32_t status =
        Q && way.slid ? rw_drive_through(contact, &rig, Q, way.slid, &way.b) : RWEDGE_ENOMEM;
    if (status == RWEDGE_OK) {
        const rw_load_history history = {loads, P, M, Q, sigma};
        status = create(contact, &history, false, way, cycle);
    } else
        free(way.slid);
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
    const int32_t status = create(contact, &history, true, NO_RIG, cycle);
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
