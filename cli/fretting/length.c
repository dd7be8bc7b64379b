/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "length.h"

#include "text/memory.h"
#include "number/pi.h"

#include <stdlib.h>

int32_t length_measure(const last_cycle *cycle, const distance *below, double x, measures *at)
{
    const size_t n = cycle->loads;
    double *stress = memory_resized(NULL, 3 * n * sizeof *stress);
    int32_t status = rwedge_contact_cycle_below(
        cycle->before, n, cycle->P, cycle->M, cycle->Q, cycle->sigma, x, below->angle * PI / 180,
        below->length, below->is_line, stress, stress + n, stress + 2 * n);
    if (status == RWEDGE_OK)
        status = last_cycle_criteria(cycle, 1, stress, at);
    free(stress);
    return status;
}
