/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The displacement that slip adds, after each load of a cycle. */
#include "cycle/states.h"

#include "base/domain.h"
#include "loading/apply.h"
#include "loading/beside.h"

#include <stdlib.h>
#include <string.h>

/* Goes through the loads once more. */
static int32_t displacements(const rwedge_cycle *cycle, rwedge_contact *going, double b,
                             double displacement[])
{
    int32_t status = rw_contact_follow_slip(going);
    for (size_t i = 0; i < cycle->loads.count && status == RWEDGE_OK; i++) {
        status = rw_contact_apply(going, rw_cycle_goal(cycle, going, i));
        going->drive.slid += rw_cycle_slid(cycle, i);
        if (status == RWEDGE_OK && going->phase == RW_APART)
            status = RWEDGE_EABSENT;
        displacement[i] = rwedge_contact_displacement(going, b);
        if (status == RWEDGE_OK && isnan(displacement[i]))
            status = RWEDGE_EPATH;
    }
    return status;
}

int32_t rwedge_cycle_displacement(const rwedge_cycle *cycle, size_t loads, double b,
                                  double displacement[])
{
    if (!cycle || !displacement)
        return RWEDGE_ENULL;
    if (!rw_is_positive(b))
        return RWEDGE_EDOMAIN;
    if (loads != cycle->loads.count)
        return RWEDGE_ERANGE;
    if (cycle->slip_status != RWEDGE_OK)
        return cycle->slip_status;
    rwedge_contact *going = NULL;
    double *found = malloc(loads * sizeof *found);
    int32_t status = found ? rwedge_contact_copy(cycle->before, &going) : RWEDGE_ENOMEM;
    if (status == RWEDGE_OK)
        status = displacements(cycle, going, b, found);
    if (status == RWEDGE_OK)
        memcpy(displacement, found, loads * sizeof *found);
    rwedge_contact_destroy(going);
    free(found);
    return status;
}
