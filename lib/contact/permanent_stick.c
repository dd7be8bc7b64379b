/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What never slips in a straight cycle between two loads. */
#include "contact/contact.h"

static int32_t load_once(double theta, double a, double A, double f, rw_loads to,
                         rwedge_contact **contact)
{
    const int32_t status = rwedge_contact_create(theta, a, A, f, contact);
    return status == RWEDGE_OK ? rwedge_contact_apply(*contact, to.P, to.M, 0, 0) : status;
}

/* The load and the tilt of what sticks are (N_1 + N_2 - |T_2 - T_1|)/2, which loses as much on the
 * way to either load; the stretch has the sign of the shear. */
static int32_t permanent(const rwedge_contact *one, const rwedge_contact *two, rw_loads from,
                         rw_loads to, double *left, double *right)
{
    const rw_geometry *g = &one->geometry;
    const rw_corner *first = rw_memory_end(&one->memory), *second = rw_memory_end(&two->memory);
    if (one->f == 0 || fabs(from.Q) > one->f * from.P || fabs(to.Q) > one->f * to.P)
        return one->f == 0 && from.Q == 0 && to.Q == 0 ? RWEDGE_EABSENT : RWEDGE_ESLIDING;
    const double sign = to.Q < from.Q ? -1 : 1, shear = (to.Q - from.Q) / one->f;
    const double stretch = -(g->A / g->theta) * (to.sigma - from.sigma) / (4 * one->f);
    const double load = (first->load + second->load - sign * shear) / 2;
    const double tilt = (first->tilt + second->tilt - sign * stretch) / 2;
    if (!(load > 0))
        return RWEDGE_EABSENT;
    const rw_patch patch = rw_patch_under_tilt(g, load, tilt);
    if (!rw_patch_is_nested(patch, first->patch, tilt) ||
        !rw_patch_is_nested(patch, second->patch, tilt))
        return RWEDGE_EPATH;
    *left = patch.left;
    *right = patch.right;
    return RWEDGE_OK;
}

int32_t rwedge_permanent_stick(double theta, double a, double A, double f, double P1, double M1,
                               double Q1, double sigma1, double P2, double M2, double Q2,
                               double sigma2, double *left, double *right)
{
    if (!left || !right)
        return RWEDGE_ENULL;
    const rw_loads from = {P1, M1, Q1, sigma1}, to = {P2, M2, Q2, sigma2};
    if (!rw_is_signed(Q1) || !rw_is_signed(Q2) || !rw_is_signed(sigma1) || !rw_is_signed(sigma2))
        return RWEDGE_EDOMAIN;
    rwedge_contact *one = NULL, *two = NULL;
    int32_t status = load_once(theta, a, A, f, from, &one);
    if (status == RWEDGE_OK)
        status = load_once(theta, a, A, f, to, &two);
    if (status == RWEDGE_OK)
        status = permanent(one, two, from, to, left, right);
    rwedge_contact_destroy(one);
    rwedge_contact_destroy(two);
    return status;
}
