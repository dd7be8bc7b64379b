/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cycle/cycle.h"

#include <stdlib.h>
#include <string.h>

/* ---- Stresses ---- */

int32_t rw_cycle_stresses(const rwedge_cycle *cycle, size_t n, const double x[], const double y[],
                          double stress[])
{
    const size_t all = cycle->at_loads.loads * n;
    int32_t status = RWEDGE_OK;
    for (size_t i = 0; i < cycle->at_loads.count && status == RWEDGE_OK; i++) {
        if (!cycle->at_loads.states[i].is_load)
            continue;
        status = rwedge_contact_stresses(cycle->at_loads.states[i].contact, n, x, y, stress,
                                         stress + all, stress + 2 * all);
        stress += n;
    }
    return status;
}

int32_t rwedge_cycle_stresses(const rwedge_cycle *cycle, size_t loads, size_t n, const double x[],
                              const double y[], double sxx[], double syy[], double txy[])
{
    if (!cycle || (n > 0 && (!x || !y || !sxx || !syy || !txy)))
        return RWEDGE_ENULL;
    const size_t own = cycle->at_loads.loads;
    if (loads != own || n > SIZE_MAX / 3 / sizeof(double) / own)
        return RWEDGE_ERANGE;
    double *stress = malloc((3 * own * n + 1) * sizeof *stress);
    const int32_t status = stress ? rw_cycle_stresses(cycle, n, x, y, stress) : RWEDGE_ENOMEM;
    double *const component[] = {sxx, syy, txy};
    for (int i = 0; i < 3 && n > 0 && status == RWEDGE_OK; i++)
        memcpy(component[i], stress + (size_t)i * own * n, own * n * sizeof *stress);
    free(stress);
    return status;
}

double rw_largest_stress(const rwedge_cycle *cycle, size_t n, const double stress[], size_t i)
{
    double most = stress[i];
    for (size_t load = 1; load < cycle->at_loads.loads; load++)
        most = fmax(most, stress[load * n + i]);
    return most;
}

/* ---- Friction ---- */

static int32_t slip_measures(const rwedge_cycle *cycle, size_t n, const double x[],
                             double slip_range[], double ruiz_f1[], double ruiz_f2[],
                             double energy[])
{
    if (n > (SIZE_MAX / sizeof(double) - 1) / 3 / cycle->at_loads.loads)
        return RWEDGE_ERANGE;
    double *surface = calloc(n + 1, sizeof *surface),
           *sxx = malloc((3 * cycle->at_loads.loads * n + 1) * sizeof *sxx);
    const int32_t status =
        surface && sxx ? rw_cycle_stresses(cycle, n, x, surface, sxx) : RWEDGE_ENOMEM;
    for (size_t i = 0; i < n && status == RWEDGE_OK; i++) {
        const rw_slip_measures at = rw_slip_measures_at(&cycle->on_the_way, x[i]);
        slip_range[i] = at.slip_range;
        ruiz_f1[i] = at.shear * at.slip_range;
        ruiz_f2[i] = fmax(rw_largest_stress(cycle, n, sxx, i), 0) * ruiz_f1[i];
        energy[i] = at.energy;
    }
    free(surface);
    free(sxx);
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
