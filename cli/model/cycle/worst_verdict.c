/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cycle.h"

#include <math.h>
#include <stdlib.h>

/* The stresses of each load at a place, or below one of the surface. */
static int32_t stresses_of(const last_cycle *cycle, const distance *below, bool is_below, double x,
                           double y, double *stress)
{
    const size_t n = cycle->loads;
    if (!is_below)
        return rwedge_cycle_stresses(cycle->cycle, n, 1, &x, &y, stress, stress + n,
                                     stress + 2 * n);
    return rwedge_cycle_below(cycle->cycle, n, x, below->angle * PI / 180, below->length,
                              below->is_line, stress, stress + n, stress + 2 * n);
}

/* The factor is there where the criterion has a value that it must not exceed. Damage has none: it
 * is no measure of a stress. */
static double factor_of(const last_cycle *cycle, int criterion, double allowable,
                        const double *stress)
{
    const criteria *asked = &cycle->asked;
    const size_t n = cycle->loads;
    double factor;
    if (criterion_is_damage(criterion) || isnan(allowable))
        return NAN;
    return rwedge_criterion_factor(criterion, asked->constants[criterion], allowable, n, stress,
                                   stress + n, stress + 2 * n, asked->nu, asked->is_plane_stress,
                                   &factor) == RWEDGE_OK
               ? factor
               : NAN;
}

int32_t worst_verdict_of(const last_cycle *cycle, const distance *below, const worst_row *row,
                         int criterion, worst_verdict *to)
{
    double *stress = memory_zeroed(3 * cycle->loads, sizeof *stress);
    *to = (worst_verdict){.is_below = !isnan(below->length) && row->y == 0,
                          .at = {.x = row->x, .y = row->y}};
    int32_t status = stresses_of(cycle, below, to->is_below, row->x, row->y, stress);
    if (status == RWEDGE_OK)
        status = last_cycle_criteria(cycle, 1, stress, &to->at);
    if (status == RWEDGE_OK) {
        to->judged = criterion_verdict_at(&cycle->asked, &to->at, criterion);
        to->load_factor = factor_of(cycle, criterion, to->judged.allowable, stress);
    }
    free(stress);
    return status;
}
