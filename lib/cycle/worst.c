/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where a measure of a cycle is largest on a line, also between the places at which it is known. */
#include "base/maximum.h"
#include "cycle/states.h"
#include "measures/criterion.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
    const double *constants; /* of the criterion */
    double nu;
    int32_t plane_stress;
} material;

typedef struct {
    const rwedge_cycle *cycle;
    int32_t measure;
    material material;
    double y;
    double *stress; /* room for those of one place */
    rw_piece_sum *room;
    double least;        /* amplitude of sqrt(J2) of a place that is not passed over */
    bool *lacked_memory; /* somewhere */
} line;

/* ---- One place ---- */

static bool is_answer(const line *l, int32_t status)
{
    *l->lacked_memory = *l->lacked_memory || status == RWEDGE_ENOMEM;
    return status == RWEDGE_OK;
}

static double friction_of(const line *l, double x, const double *sxx)
{
    rw_slip_measures at;
    rw_slip_measures_at(l->cycle, 1, &x, l->room, &at);
    switch (l->measure) {
    case RWEDGE_MEASURE_SLIP_RANGE:
        return at.slip_range;
    case RWEDGE_MEASURE_ENERGY_PER_AREA:
        return at.energy;
    case RWEDGE_MEASURE_RUIZ_F1:
        return at.shear * at.slip_range;
    default:
        return at.shear * at.slip_range * fmax(rw_largest_stress(l->cycle, 1, sxx, 0), 0);
    }
}

static bool is_of_friction(int32_t measure)
{
    return measure >= RWEDGE_MEASURE_SLIP_RANGE && measure <= RWEDGE_MEASURE_ENERGY_PER_AREA;
}

static double measure_of(const line *l, double x, const double *sxx)
{
    const size_t loads = l->cycle->loads.count;
    const material *m = &l->material;
    double value = NAN, angle, out_of_plane;
    if (is_of_friction(l->measure))
        return friction_of(l, x, sxx);
    is_answer(l,
              rwedge_criterion(l->measure, m->constants, loads, sxx, sxx + loads, sxx + 2 * loads,
                               m->nu, m->plane_stress, &value, &angle, &out_of_plane));
    return value;
}

/* The amplitude of sqrt(J2): what the criteria that count a mean stress have but for it. */
static double amplitude_of(const line *l, const double *sxx)
{
    static const double no_mean[1] = {0};
    const size_t loads = l->cycle->loads.count;
    double value = 0, angle, out_of_plane;
    is_answer(l, rwedge_criterion(RWEDGE_MEASURE_CROSSLAND, no_mean, loads, sxx, sxx + loads,
                                  sxx + 2 * loads, l->material.nu, l->material.plane_stress, &value,
                                  &angle, &out_of_plane));
    return value;
}

static double amplitude_at(const line *l, double x)
{
    const int32_t status = rw_cycle_stresses(l->cycle, 1, &x, &l->y, l->stress);
    return is_answer(l, status) ? amplitude_of(l, l->stress) : 0;
}

/* The measure at one place; NaN at the apex of a sharp wedge. Among the measures of friction only
 * Ruiz' F2 needs stresses. */
static double measure_at(const line *l, double x)
{
    if (is_of_friction(l->measure) && l->measure != RWEDGE_MEASURE_RUIZ_F2)
        return rw_cycle_has_stress(l->cycle, x, l->y) ? friction_of(l, x, NULL) : NAN;
    const int32_t status = rw_cycle_stresses(l->cycle, 1, &x, &l->y, l->stress);
    if (!is_answer(l, status) || (l->least > 0 && amplitude_of(l, l->stress) < l->least))
        return NAN;
    return measure_of(l, x, l->stress);
}

static double value_at(double x, const void *of_line)
{
    return measure_at(of_line, x);
}

/* ---- Where nothing cycles ---- */

/* A place cycles if its amplitude is at least this part of the largest one. */
static const double CYCLES = 1e-3;

/* The values of the places that cycle, 0 of the others, which have no fatigue: a criterion that
 * counts a mean stress may be largest there. */
static void pass_over(line *l, size_t n, const double x[], double value[])
{
    double *amplitude = malloc(n * sizeof *amplitude);
    *l->lacked_memory = *l->lacked_memory || !amplitude;
    double largest = 0;
    for (size_t i = 0; amplitude && i < n; i++) {
        amplitude[i] = amplitude_at(l, x[i]);
        largest = fmax(largest, amplitude[i]);
    }
    l->least = CYCLES * largest;
    for (size_t i = 0; amplitude && i < n; i++)
        value[i] = amplitude[i] < l->least ? 0 : value[i];
    free(amplitude);
}

static bool is_measured(const line *l)
{
    const material *m = &l->material;
    return (is_of_friction(l->measure) || rw_has_constants(l->measure, m->constants)) &&
           rw_is_poisson(m->nu) && rw_is_switch(m->plane_stress);
}

static bool are_measured(size_t n, const double x[], const double value[])
{
    for (size_t i = 0; i < n; i++)
        if (!rw_is_signed(x[i]) || !rw_is_magnitude(value[i]))
            return false;
    return true;
}

static int32_t check(const line *l, size_t n, const double x[], const double value[])
{
    if (!is_measured(l) || !rw_is_magnitude(l->y) || !are_measured(n, x, value))
        return RWEDGE_EDOMAIN;
    if (n == 0)
        return RWEDGE_ERANGE;
    return is_of_friction(l->measure) && l->y != 0 ? RWEDGE_EDOMAIN : RWEDGE_OK;
}

/* Finds it from place to place. */
static int32_t find(line *l, size_t n, const double x[], const double value[], rw_maximum *best)
{
    double *kept = malloc(n * sizeof *kept);
    l->stress = malloc(3 * l->cycle->loads.count * sizeof *l->stress);
    l->room = rw_cycle_room(l->cycle);
    int32_t status = kept && l->stress && l->room ? RWEDGE_OK : RWEDGE_ENOMEM;
    if (status == RWEDGE_OK) {
        memcpy(kept, value, n * sizeof *kept);
        if (rw_counts_mean(l->measure))
            pass_over(l, n, x, kept);
        *best = rw_largest_around(value_at, l, n, x, kept);
        status = *l->lacked_memory ? RWEDGE_ENOMEM : RWEDGE_OK;
    }
    free(kept);
    free(l->stress);
    free(l->room);
    return status;
}

int32_t rwedge_cycle_worst(const rwedge_cycle *cycle, int32_t measure, const double constants[],
                           size_t n, const double x[], const double value[], double y, double nu,
                           int32_t plane_stress, double *worst_x, double *worst_value)
{
    bool lacked_memory = false;
    line l = {.cycle = cycle,
              .measure = measure,
              .material = {constants, nu, plane_stress},
              .y = y,
              .lacked_memory = &lacked_memory};
    if (!cycle || (n > 0 && (!x || !value)) || !worst_x || !worst_value ||
        (!constants && rwedge_criterion_constants(measure) > 0))
        return RWEDGE_ENULL;
    rw_maximum best = {0, 0};
    int32_t status = check(&l, n, x, value);
    if (status == RWEDGE_OK && is_of_friction(measure))
        status = cycle->slip_status;
    if (status == RWEDGE_OK)
        status = find(&l, n, x, value, &best);
    if (status == RWEDGE_OK) {
        *worst_x = best.x;
        *worst_value = best.value;
    }
    return status;
}
