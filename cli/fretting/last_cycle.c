/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "last_cycle.h"

#include "model/doubts.h"
#include "model/tensor.h"
#include "text/message.h"

#include <math.h>
#include <stdlib.h>

/* ---- The loads ---- */

static void *room_for(size_t count)
{
    void *room = calloc(count, sizeof(double));
    if (room == NULL)
        failure("out of memory");
    return room;
}

/* A state after a load: its edges. */
static void note_edges(const rwedge_contact *contact, last_cycle *cycle)
{
    double *edge = cycle->edges + cycle->edge_count;
    if (rwedge_contact_edges(contact, &edge[0], &edge[1]) != RWEDGE_OK)
        return;
    cycle->left = fmin(cycle->left, edge[0]);
    cycle->right = fmax(cycle->right, edge[1]);
    cycle->edge_count += 2;
    if (rwedge_contact_stick_zone(contact, &edge[2], &edge[3]) == RWEDGE_OK)
        cycle->edge_count += 2;
}

static void note_load(const rwedge_contact *contact, size_t i, last_cycle *cycle)
{
    rwedge_contact_loads(contact, &cycle->P[i], &cycle->M[i], &cycle->Q[i], &cycle->sigma[i]);
    note_edges(contact, cycle);
    cycle->doubts |= doubts_of_state(cycle->setup, contact);
}

static void keep(const rwedge_contact *contact, last_cycle *cycle)
{
    if (rwedge_contact_copy(contact, &cycle->before) != RWEDGE_OK)
        failure("out of memory");
    note_edges(contact, cycle);
}

/* Loads before the first cycle that the contact may yield under. */
static void look_before(const course *whole, last_cycle *cycle)
{
    char complaint[COMPLAINT_SIZE];
    rwedge_contact *contact;
    if (case_contact(&whole->what, &contact) != RWEDGE_OK)
        return;
    for (size_t i = 0; i < whole->before.count; i++)
        if (load_table_apply(&whole->before, i, whole->what.f, contact, complaint))
            cycle->doubts |= doubts_of_state(cycle->setup, contact);
    rwedge_contact_destroy(contact);
}

void last_cycle_begin(const course *whole, double k_over_sy, last_cycle *cycle)
{
    const size_t loads = whole->steps < whole->loads.count ? whole->steps : whole->loads.count;
    *cycle = (last_cycle){.setup = &whole->what,
                          .k_over_sy = k_over_sy,
                          .loads = loads,
                          .P = room_for(4 * loads),
                          .edges = room_for(4 * (loads + 1)),
                          .left = NAN,
                          .right = NAN};
    cycle->M = cycle->P + loads;
    cycle->Q = cycle->M + loads;
    cycle->sigma = cycle->Q + loads;
    look_before(whole, cycle);
    rwedge_contact *contact = course_begin(whole);
    for (size_t step = 0, first = whole->steps - loads; step < whole->steps; step++) {
        if (step == first)
            keep(contact, cycle);
        course_go_on(whole, step, contact);
        if (step >= first)
            note_load(contact, step - first, cycle);
    }
    rwedge_contact_destroy(contact);
    cycle->slip_known =
        rwedge_contact_cycle_friction(cycle->before, loads, cycle->P, cycle->M, cycle->Q,
                                      cycle->sigma, 0, NULL, NULL, NULL, NULL, NULL) == RWEDGE_OK;
}

/* ---- Measures ---- */

static void forget(measures *at)
{
    for (int m = 0; m < MEASURE_COUNT; m++)
        at->value[m] = NAN;
}

static int32_t fatigue(const last_cycle *cycle, size_t n, const double x[], const double y[],
                       double *room, measures at[])
{
    const bool strength = !isnan(cycle->k_over_sy);
    const int32_t status = rwedge_contact_cycle_fatigue(
        cycle->before, cycle->loads, cycle->P, cycle->M, cycle->Q, cycle->sigma, n, x, y,
        cycle->setup->E1, cycle->setup->nu1, strength ? cycle->k_over_sy : 0, room, room + n,
        room + 2 * n, room + 3 * n, room + 4 * n);
    for (size_t i = 0; i < n && status == RWEDGE_OK; i++) {
        at[i].value[MEASURE_STRESS_RANGE] = room[i];
        at[i].value[MEASURE_SWT] = room[n + i];
        at[i].value[MEASURE_SWT_ANGLE] = degrees(room[2 * n + i]);
        at[i].value[MEASURE_FATEMI_SOCIE] = strength ? room[3 * n + i] : NAN;
        at[i].value[MEASURE_FS_ANGLE] = strength ? degrees(room[4 * n + i]) : NAN;
    }
    return status;
}

/* Of the surface in contact. */
static bool is_rubbed(const last_cycle *cycle, double x, double y)
{
    const double rounding = 1e-12 * (cycle->right - cycle->left);
    return y == 0 && x >= cycle->left - rounding && x <= cycle->right + rounding;
}

static int32_t friction(const last_cycle *cycle, size_t n, const double x[], const double y[],
                        double *room, measures at[])
{
    size_t count = 0;
    for (size_t i = 0; i < n; i++)
        if (is_rubbed(cycle, x[i], y[i]))
            room[4 * n + count++] = x[i];
    if (!cycle->slip_known || count == 0)
        return RWEDGE_OK;
    const int32_t status = rwedge_contact_cycle_friction(
        cycle->before, cycle->loads, cycle->P, cycle->M, cycle->Q, cycle->sigma, count,
        room + 4 * n, room, room + n, room + 2 * n, room + 3 * n);
    for (size_t i = 0, k = 0; i < n && status == RWEDGE_OK; i++)
        if (is_rubbed(cycle, x[i], y[i])) {
            at[i].value[MEASURE_SLIP_RANGE] = room[k];
            at[i].value[MEASURE_RUIZ_F1] = room[n + k];
            at[i].value[MEASURE_RUIZ_F2] = room[2 * n + k];
            at[i].value[MEASURE_ENERGY_PER_AREA] = room[3 * n + k++];
        }
    return status;
}

/* Infinite at the apex of the sharp wedge: another point stands for it. */
int32_t last_cycle_measure(const last_cycle *cycle, size_t n, const double x[], const double y[],
                           measures at[])
{
    double *room = malloc((6 * n + 1) * sizeof *room);
    if (room == NULL)
        return RWEDGE_ENOMEM;
    double *depth = room + 5 * n;
    for (size_t i = 0; i < n; i++) {
        depth[i] = cycle->setup->a == 0 && x[i] == 0 && y[i] == 0 ? 1 : y[i];
        forget(&at[i]);
    }
    int32_t status = fatigue(cycle, n, x, depth, room, at);
    if (status == RWEDGE_OK)
        status = friction(cycle, n, x, depth, room, at);
    for (size_t i = 0; i < n; i++)
        if (depth[i] != y[i])
            forget(&at[i]);
    free(room);
    return status;
}

/* ---- The worst ---- */

/* As the library calls them. */
static const int32_t library_measures[MEASURE_COUNT] = {
    [MEASURE_STRESS_RANGE] = RWEDGE_MEASURE_STRESS_RANGE,
    [MEASURE_SWT] = RWEDGE_MEASURE_SWT,
    [MEASURE_SWT_ANGLE] = -1,
    [MEASURE_FATEMI_SOCIE] = RWEDGE_MEASURE_FATEMI_SOCIE,
    [MEASURE_FS_ANGLE] = -1,
    [MEASURE_SLIP_RANGE] = RWEDGE_MEASURE_SLIP_RANGE,
    [MEASURE_RUIZ_F1] = RWEDGE_MEASURE_RUIZ_F1,
    [MEASURE_RUIZ_F2] = RWEDGE_MEASURE_RUIZ_F2,
    [MEASURE_ENERGY_PER_AREA] = RWEDGE_MEASURE_ENERGY_PER_AREA,
};

worst_place last_cycle_worst(const last_cycle *cycle, int measure, size_t n, const double x[],
                             const double value[], double y)
{
    worst_place worst = {x[0], NAN};
    const int32_t status = rwedge_contact_cycle_worst(
        cycle->before, library_measures[measure], cycle->loads, cycle->P, cycle->M, cycle->Q,
        cycle->sigma, n, x, value, y, cycle->setup->E1, cycle->setup->nu1,
        isnan(cycle->k_over_sy) ? 0 : cycle->k_over_sy, &worst.x, &worst.value);
    if (status != RWEDGE_OK)
        failure("%s", rwedge_strerror(status));
    return worst;
}
