/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What never slips in a straight cycle between two loads. */
#include "contact/contact.h"

/* A contact like another, in closed form from touching on. The first tension acts before the bodies
 * touch, and so moves nothing. */
static int32_t load_once(const rwedge_contact *like, rw_loads to, rwedge_contact **contact)
{
    int32_t status = rwedge_contact_copy(like, contact);
    if (status == RWEDGE_OK) {
        rw_contact_drop_computed(*contact);
        rw_contact_drop_beside(*contact);
        (*contact)->tolerance = 0;
        (*contact)->energy = (rw_dissipated){.is_known = true};
        status = rwedge_contact_apply(*contact, 0, 0, 0, to.sigma);
    }
    if (status == RWEDGE_OK)
        status = rwedge_contact_apply(*contact, to.P, to.M, 0, to.sigma);
    return status == RWEDGE_OK ? rwedge_contact_apply(*contact, to.P, to.M, to.Q, to.sigma)
                               : status;
}

/* Whether both edges move outwards on the whole way from the smaller contact to the larger. */
static bool keeps(const rwedge_contact *smaller, const rwedge_contact *larger)
{
    static const double SLACK = 1e-12;
    const rw_patch patch = rw_memory_end(&smaller->memory)->patch;
    if (smaller->is_held)
        return true;
    const double P = larger->loads.P - smaller->loads.P, M = larger->loads.M - smaller->loads.M;
    return fabs(M - rw_patch_middle(patch) * P) <= (0.5 + SLACK) * rw_patch_half_width(patch) * P;
}

/* The patch that sticks has the load and tilt N* = (N_1 + N_2 - |T_2 - T_1|)/2 (lib/README.md,
 * "Moment and bulk tension"): the ways to both loads slip as far. The stretch has the sign of the
 * shear. Where N* is more than the smaller contact, all of that contact sticks: the ring that opens
 * and closes carries the change of shear. */
static int32_t permanent(const rwedge_contact *first, const rwedge_contact *second, double sign,
                         rw_patch *stuck)
{
    const bool rises = first->loads.P < second->loads.P;
    const rwedge_contact *smaller = rises ? first : second, *larger = rises ? second : first;
    const rw_corner *less = rw_memory_end(&smaller->memory), *more = rw_memory_end(&larger->memory);
    const double shear = sign * (second->loads.Q - first->loads.Q) / first->f;
    const double stretch =
        sign * rw_contact_stretch(first, second->loads.sigma - first->loads.sigma);
    const double load = (less->load + more->load - shear) / 2;
    const double tilt = (less->tilt + more->tilt - stretch) / 2;
    if (load <= rw_memory_tolerance(more->load) || less->load == 0)
        return RWEDGE_EABSENT;
    *stuck = rw_patch_under_tilt(&first->geometry, load, tilt);
    if (!rw_patch_is_nested(*stuck, more->patch, tilt))
        return RWEDGE_EPATH;
    if (rw_patch_is_nested(*stuck, less->patch, tilt))
        return RWEDGE_OK;
    if (!rw_patch_is_nested(less->patch, *stuck, tilt) || !keeps(smaller, larger))
        return RWEDGE_EPATH;
    *stuck = less->patch;
    return RWEDGE_OK;
}

int32_t rwedge_contact_permanent_stick(const rwedge_contact *contact, double P1, double M1,
                                       double Q1, double sigma1, double P2, double M2, double Q2,
                                       double sigma2, double *left, double *right)
{
    if (!contact || !left || !right)
        return RWEDGE_ENULL;
    if (contact->unlike)
        return RWEDGE_EPATH;
    rwedge_contact *first = NULL, *second = NULL;
    rw_patch stuck = {0, 0};
    int32_t status = load_once(contact, (rw_loads){P1, M1, Q1, sigma1}, &first);
    if (status == RWEDGE_OK)
        status = load_once(contact, (rw_loads){P2, M2, Q2, sigma2}, &second);
    if (status == RWEDGE_OK)
        status =
            contact->f == 0 ? RWEDGE_EABSENT : permanent(first, second, Q2 < Q1 ? -1 : 1, &stuck);
    if (status == RWEDGE_OK) {
        *left = stuck.left;
        *right = stuck.right;
    }
    rwedge_contact_destroy(first);
    rwedge_contact_destroy(second);
    return status;
}
