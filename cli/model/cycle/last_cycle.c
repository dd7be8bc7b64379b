/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cycle.h"

#include <math.h>
#include <stdlib.h>

/* ---- The loads ---- */

/* A state before or after a load: its error and edges. */
static void note(const rwedge_contact *contact, last_cycle *cycle)
{
    double left, right;
    cycle->error = fmax(cycle->error, rwedge_contact_error(contact));
    if (rwedge_contact_edges(contact, &left, &right) != RWEDGE_OK)
        return;
    cycle->left = fmin(cycle->left, left);
    cycle->right = fmax(cycle->right, right);
}

void last_cycle_begin(const contact_case *setup, const criteria *asked,
                      const rwedge_contact *before, size_t most, last_cycle *cycle)
{
    measure_count(); /* the table of columns is made here, before any thread asks for it */
    *cycle = (last_cycle){.setup = setup, .asked = *asked, .left = NAN, .right = NAN};
    cycle->P = calloc(6 * most + 1, sizeof *cycle->P);
    if (cycle->P == NULL || rwedge_contact_copy(before, &cycle->before) != RWEDGE_OK)
        return;
    cycle->M = cycle->P + most;
    cycle->Q = cycle->M + most;
    cycle->sigma = cycle->Q + most;
    cycle->displacement = cycle->sigma + most;
    cycle->tilt = cycle->displacement + most;
    note(before, cycle);
}

void last_cycle_add(load to, const rwedge_contact *contact, last_cycle *cycle)
{
    const size_t i = cycle->loads++;
    if (cycle->before == NULL)
        return;
    cycle->is_driven = to.is_driven;
    cycle->displacement[i] = to.displacement;
    cycle->compliance = to.compliance;
    cycle->is_guided = to.is_guided;
    cycle->tilt[i] = to.tilt;
    rwedge_contact_loads(contact, &cycle->P[i], &cycle->M[i], &cycle->Q[i], &cycle->sigma[i]);
    note(contact, cycle);
}

int32_t last_cycle_end(last_cycle *last)
{
    int32_t status =
        last->before == NULL ? RWEDGE_ENOMEM
        : last->is_driven
            ? rwedge_cycle_create_driven(last->before, last->loads, last->P, last->M, last->sigma,
                                         last->displacement, last->compliance, &last->cycle)
        : last->is_guided
            ? rwedge_cycle_create_guided(last->before, last->loads, last->P, last->tilt, last->Q,
                                         last->sigma, &last->cycle)
            : rwedge_cycle_create(last->before, last->loads, last->P, last->M, last->Q, last->sigma,
                                  &last->cycle);
    if (status == RWEDGE_OK)
        status = rwedge_cycle_friction(last->cycle, 0, NULL, NULL, NULL, NULL, NULL);
    last->slip_known = status == RWEDGE_OK;
    return status == RWEDGE_EPATH ? RWEDGE_OK : status;
}

void last_cycle_free(last_cycle *cycle)
{
    rwedge_cycle_destroy(cycle->cycle);
    rwedge_contact_destroy(cycle->before);
    free(cycle->P);
}

/* ---- Measures ---- */

static void forget(measured_place *at)
{
    for (int i = 0; i < COLUMN_MAX; i++)
        at->value[i] = NAN;
    at->amplitude = 0;
}

/* Numbers of n places into the column of a library's measure, if it has one. */
static void store(int32_t number, bool is_damage, measure_part part, size_t n,
                  const double number_of[], measured_place at[])
{
    const int column = measure_column_of(number, is_damage, part);
    const bool is_angle = part == PART_ANGLE || part == PART_OUT_OF_PLANE;
    for (size_t j = 0; j < n && column >= 0; j++)
        at[j].value[column] = is_angle ? degrees(number_of[j]) : number_of[j];
}

/* The multiples of measures that are known. */
static void store_multiples(const criteria *asked, size_t n, measured_place at[])
{
    for (int i = 0; i < measure_count(); i++) {
        const measure_kind *kind = measure_kind_of(i);
        const int of = measure_column_of(kind->number, false, PART_VALUE);
        for (size_t j = 0; j < n && kind->part == PART_MULTIPLE; j++)
            at[j].value[i] = kind->times(asked) * at[j].value[of];
    }
}

/* The value, both angles and the cycles of damage: four lists of n numbers each, as the parts of a
 * measure. */
static int32_t criterion_at(const last_cycle *cycle, int i, size_t n, const double *stress,
                            double *work)
{
    const criteria *asked = &cycle->asked;
    const size_t loads = cycle->loads, all = loads * n;
    const double *syy = stress + all, *txy = syy + all;
    if (criterion_is_damage(i))
        return rwedge_damage_field(i - DAMAGE, asked->constants[i - DAMAGE], loads, n, stress, syy,
                                   txy, asked->nu, asked->is_plane_stress, work, work + 3 * n,
                                   work + n);
    return rwedge_criterion_field(i, asked->constants[i], loads, n, stress, syy, txy, asked->nu,
                                  asked->is_plane_stress, work, work + n, work + 2 * n);
}

static int32_t add_criterion(const last_cycle *cycle, int i, size_t n, const double *stress,
                             double *work, measured_place at[])
{
    const bool is_damage = criterion_is_damage(i);
    const int32_t status = criterion_at(cycle, i, n, stress, work);
    for (int part = PART_VALUE; part < CRITERION_PARTS && status == RWEDGE_OK; part++)
        if (part != PART_CYCLES || is_damage)
            store(is_damage ? i - DAMAGE : i, is_damage, (measure_part)part, n,
                  work + (size_t)part * n, at);
    return status;
}

/* The range of sxx, and the amplitude of sqrt(J2): Crossland's without the mean stress. */
static int32_t add_ranges(const last_cycle *cycle, size_t n, const double *stress, double *work,
                          measured_place at[])
{
    static const double no_mean[1] = {0};
    const int32_t asked[2] = {RWEDGE_MEASURE_STRESS_RANGE, RWEDGE_MEASURE_CROSSLAND};
    const size_t all = cycle->loads * n;
    int32_t status = RWEDGE_OK;
    for (int i = 0; i < 2 && status == RWEDGE_OK; i++) {
        status = rwedge_criterion_field(asked[i], no_mean, cycle->loads, n, stress, stress + all,
                                        stress + 2 * all, cycle->asked.nu,
                                        cycle->asked.is_plane_stress, work, work + n, work + 2 * n);
        if (status == RWEDGE_OK && i == 0)
            store(asked[i], false, PART_VALUE, n, work, at);
        for (size_t j = 0; j < n && status == RWEDGE_OK && i == 1; j++)
            at[j].amplitude = work[j];
    }
    return status;
}

int32_t last_cycle_criteria(const last_cycle *cycle, size_t n, const double *stress,
                            measured_place at[])
{
    double *work = malloc((4 * n + 1) * sizeof *work);
    for (size_t j = 0; j < n; j++)
        forget(&at[j]);
    int32_t status = work == NULL ? RWEDGE_ENOMEM : add_ranges(cycle, n, stress, work, at);
    for (int i = 0; i < CRITERION_COUNT && status == RWEDGE_OK; i++)
        if (cycle->asked.is_computed[i])
            status = add_criterion(cycle, i, n, stress, work, at);
    free(work);
    return status;
}

static int32_t fatigue(const last_cycle *cycle, size_t n, const double x[], const double y[],
                       measured_place at[])
{
    const size_t all = cycle->loads * n;
    double *stress = malloc((3 * all + 1) * sizeof *stress);
    int32_t status = stress == NULL ? RWEDGE_ENOMEM
                                    : rwedge_cycle_stresses(cycle->cycle, cycle->loads, n, x, y,
                                                            stress, stress + all, stress + 2 * all);
    if (status == RWEDGE_OK)
        status = last_cycle_criteria(cycle, n, stress, at);
    free(stress);
    return status;
}

/* Whether the place is on the surface and in contact in the cycle. */
static bool is_rubbed(const last_cycle *cycle, double x, double y)
{
    const double rounding = 1e-12 * (cycle->right - cycle->left);
    return y == 0 && x >= cycle->left - rounding && x <= cycle->right + rounding;
}

/* Measures friction at places in contact; `work` has room for five lists of n numbers. */
static int32_t friction_of(const last_cycle *cycle, size_t n, const double x[], double *work,
                           measured_place at[])
{
    static const int32_t measures[] = {RWEDGE_MEASURE_SLIP_RANGE, RWEDGE_MEASURE_RUIZ_F1,
                                       RWEDGE_MEASURE_RUIZ_F2, RWEDGE_MEASURE_ENERGY_PER_AREA};
    const int32_t status =
        rwedge_cycle_friction(cycle->cycle, n, x, work, work + n, work + 2 * n, work + 3 * n);
    for (size_t i = 0; i < 4 && status == RWEDGE_OK; i++)
        store(measures[i], false, PART_VALUE, n, work + i * n, at);
    return status;
}

/* Measures friction at the places in contact, and hands it back to all. */
static int32_t friction(const last_cycle *cycle, size_t n, const double x[], const double y[],
                        measured_place at[])
{
    size_t count = 0;
    measured_place *rubbed = malloc((n + 1) * sizeof *rubbed);
    double *work = malloc((5 * n + 1) * sizeof *work);
    int32_t status = rubbed == NULL || work == NULL ? RWEDGE_ENOMEM : RWEDGE_OK;
    for (size_t i = 0; i < n && status == RWEDGE_OK; i++)
        if (is_rubbed(cycle, x[i], y[i])) {
            work[4 * n + count] = x[i];
            rubbed[count++] = at[i];
        }
    if (status == RWEDGE_OK && cycle->slip_known && count > 0)
        status = friction_of(cycle, count, work + 4 * n, work, rubbed);
    for (size_t i = 0, k = 0; i < n && status == RWEDGE_OK; i++)
        if (is_rubbed(cycle, x[i], y[i]))
            at[i] = rubbed[k++];
    free(rubbed);
    free(work);
    return status;
}

/* Stresses are infinite at a sharp edge: another point is computed in its place, and forgotten. */
int32_t last_cycle_measure(const last_cycle *cycle, size_t n, measured_place at[])
{
    double *x = malloc((2 * n + 1) * sizeof *x), *depth = x + n;
    if (x == NULL)
        return RWEDGE_ENOMEM;
    for (size_t i = 0; i < n; i++) {
        x[i] = at[i].x;
        depth[i] = at[i].y == 0 && pad_is_kink(&cycle->setup->shape, x[i]) ? 1 : at[i].y;
    }
    int32_t status = fatigue(cycle, n, x, depth, at);
    if (status == RWEDGE_OK)
        status = friction(cycle, n, x, depth, at);
    if (status == RWEDGE_OK)
        store_multiples(&cycle->asked, n, at);
    for (size_t i = 0; i < n; i++)
        if (depth[i] != at[i].y)
            forget(&at[i]);
    free(x);
    return status;
}

/* ---- The worst ---- */

int32_t last_cycle_worst(const last_cycle *cycle, int column, size_t n, const measured_place line[],
                         double *worst_x, double *worst_value)
{
    const criteria *asked = &cycle->asked;
    double *x = malloc((2 * n + 1) * sizeof *x), *value = x + n;
    if (x == NULL)
        return RWEDGE_ENOMEM;
    for (size_t i = 0; i < n; i++) {
        x[i] = line[i].x;
        value[i] = fmax(line[i].value[column], 0); /* 0 where it is not known */
    }
    const int32_t number = measure_kind_of(column)->number;
    const int32_t status =
        rwedge_cycle_worst(cycle->cycle, number, asked->constants[number], n, x, value, line[0].y,
                           asked->nu, asked->is_plane_stress, worst_x, worst_value);
    free(x);
    return status;
}
