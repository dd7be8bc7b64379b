/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cycle/states.h"

#include <stdlib.h>

/* ---- Stresses ---- */

bool rw_cycle_has_stress(const rwedge_cycle *cycle, double x, double y)
{
    const rw_geometry *g = &cycle->before->geometry;
    return rw_has_stress(g, cycle->least, x, y) && rw_has_stress(g, cycle->most, x, y);
}

static int32_t stresses(const rwedge_cycle *cycle, const rw_stress_points *points)
{
    for (size_t i = 0; i < points->n; i++)
        if (!rw_cycle_has_stress(cycle, points->x[i], points->y[i]))
            return RWEDGE_EDOMAIN;
    return rw_record_stresses(&cycle->at_loads, cycle->before, points) ? RWEDGE_OK : RWEDGE_ENOMEM;
}

int32_t rw_cycle_stresses(const rwedge_cycle *cycle, size_t n, const double x[], const double y[],
                          double stress[])
{
    const size_t all = cycle->loads.count * n;
    const rw_stress_points points = {n, x, y, stress, stress + all, stress + 2 * all};
    return stresses(cycle, &points);
}

int32_t rwedge_cycle_stresses(const rwedge_cycle *cycle, size_t loads, size_t n, const double x[],
                              const double y[], double sxx[], double syy[], double txy[])
{
    if (!cycle || (n > 0 && (!x || !y || !sxx || !syy || !txy)))
        return RWEDGE_ENULL;
    const size_t own = cycle->loads.count;
    if (loads != own || n > SIZE_MAX / 3 / sizeof(double) / own)
        return RWEDGE_ERANGE;
    const rw_stress_points points = {n, x, y, sxx, syy, txy};
    return stresses(cycle, &points);
}

double rw_largest_stress(const rwedge_cycle *cycle, size_t n, const double stress[], size_t i)
{
    double most = stress[i];
    for (size_t load = 1; load < cycle->loads.count; load++)
        most = fmax(most, stress[load * n + i]);
    return most;
}

/* ---- Friction ---- */

static int32_t slip_measures(const rwedge_cycle *cycle, size_t n, const double x[],
                             double slip_range[], double ruiz_f1[], double ruiz_f2[],
                             double energy[])
{
    if (n > (SIZE_MAX / sizeof(double) - 1) / 3 / cycle->loads.count)
        return RWEDGE_ERANGE;
    double *surface = calloc(n + 1, sizeof *surface),
           *sxx = malloc((3 * cycle->loads.count * n + 1) * sizeof *sxx);
    rw_piece_sum *room = rw_cycle_room(cycle);
    const int32_t status =
        surface && sxx && room ? rw_cycle_stresses(cycle, n, x, surface, sxx) : RWEDGE_ENOMEM;
    rw_slip_measures at[RW_SLIP_PLACES];
    for (size_t i = 0; i < n && status == RWEDGE_OK; i++) {
        const size_t k = i % RW_SLIP_PLACES;
        if (k == 0)
            rw_slip_measures_at(cycle, n - i < RW_SLIP_PLACES ? n - i : RW_SLIP_PLACES, x + i, room,
                                at);
        slip_range[i] = at[k].slip_range;
        ruiz_f1[i] = at[k].shear * at[k].slip_range;
        ruiz_f2[i] = fmax(rw_largest_stress(cycle, n, sxx, i), 0) * ruiz_f1[i];
        energy[i] = at[k].energy;
    }
    free(surface);
    free(sxx);
    free(room);
    return status;
}

int32_t rwedge_cycle_friction(const rwedge_cycle *cycle, size_t n, const double x[],
                              double slip_range[], double ruiz_f1[], double ruiz_f2[],
                              double energy[])
{
    if (!cycle || (n > 0 && (!x || !slip_range || !ruiz_f1 || !ruiz_f2 || !energy)))
        return RWEDGE_ENULL;
    return cycle->slip_status == RWEDGE_OK
               ? slip_measures(cycle, n, x, slip_range, ruiz_f1, ruiz_f2, energy)
               : cycle->slip_status;
}
