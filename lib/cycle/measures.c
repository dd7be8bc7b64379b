/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cycle/cycle.h"

#include <stdlib.h>

/* ---- Stresses ---- */

int32_t rw_cycle_stresses(const rw_cycle *cycle, size_t n, const double x[], const double y[],
                          double stress[])
{
    const size_t all = cycle->loads * n;
    int32_t status = RWEDGE_OK;
    for (size_t i = 0; i < cycle->count && status == RWEDGE_OK; i++) {
        if (!cycle->states[i].is_load)
            continue;
        status = rwedge_contact_stresses(cycle->states[i].contact, n, x, y, stress, stress + all,
                                         stress + 2 * all);
        stress += n;
    }
    return status;
}

double rw_largest_stress(const rw_cycle *cycle, size_t n, const double stress[], size_t i)
{
    double most = stress[i];
    for (size_t load = 1; load < cycle->loads; load++)
        most = fmax(most, stress[load * n + i]);
    return most;
}

/* ---- Friction ---- */

static int32_t slip_measures(const rw_cycle *cycle, size_t n, const double x[], double slip_range[],
                             double ruiz_f1[], double ruiz_f2[], double energy[])
{
    if (n > (SIZE_MAX / sizeof(double) - 1) / 3 / cycle->loads)
        return RWEDGE_ERANGE;
    double *surface = calloc(n + 1, sizeof *surface),
           *sxx = malloc((3 * cycle->loads * n + 1) * sizeof *sxx);
    const int32_t status =
        surface && sxx ? rw_cycle_stresses(cycle, n, x, surface, sxx) : RWEDGE_ENOMEM;
    for (size_t i = 0; i < n && status == RWEDGE_OK; i++) {
        const rw_slip_measures at = rw_slip_measures_at(cycle, x[i]);
        slip_range[i] = at.slip_range;
        ruiz_f1[i] = at.shear * at.slip_range;
        ruiz_f2[i] = fmax(rw_largest_stress(cycle, n, sxx, i), 0) * ruiz_f1[i];
        energy[i] = at.energy;
    }
    free(surface);
    free(sxx);
    return status;
}

int32_t rwedge_contact_cycle_friction(const rwedge_contact *contact, size_t loads, const double P[],
                                      const double M[], const double Q[], const double sigma[],
                                      size_t n, const double x[], double slip_range[],
                                      double ruiz_f1[], double ruiz_f2[], double energy[])
{
    const rw_load_history history = {loads, P, M, Q, sigma};
    if (!contact || !rw_is_load_history(&history) ||
        (n > 0 && (!x || !slip_range || !ruiz_f1 || !ruiz_f2 || !energy)))
        return RWEDGE_ENULL;
    rw_cycle cycle;
    int32_t status = rw_cycle_of(contact, &history, RW_SLIP_TOO, &cycle);
    if (status == RWEDGE_OK)
        status = slip_measures(&cycle, n, x, slip_range, ruiz_f1, ruiz_f2, energy);
    rw_cycle_destroy(&cycle);
    return status;
}
