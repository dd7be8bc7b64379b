/* SPDX-License-Identifier: GPL-3.0-or-later */
/* First yield of unlike bodies in full sliding, in natural units. */
#include "rwedge.h"

#include "base/domain.h"

/* A contact of the half-width 1 with theta/A = 1, which slides under the load P. */
static int32_t slide(double alpha, double beta_f, double f, int32_t held, double P,
                     rwedge_contact **contact)
{
    static const double THETA = 0.01;
    int32_t status = rwedge_contact_create(THETA, alpha, THETA, f, contact);
    if (status == RWEDGE_OK)
        status = rwedge_contact_set_beta(*contact, f > 0 ? beta_f / f : 0);
    if (status == RWEDGE_OK)
        status = rwedge_contact_set_rotation(*contact, held);
    return status == RWEDGE_OK ? rwedge_contact_apply(*contact, P, 0, f * P, 0) : status;
}

int32_t rwedge_sliding_limit(double alpha, double beta_f, double f, double nu, int32_t held,
                             double *limit, double *x, double *y)
{
    if (!limit || !x || !y)
        return RWEDGE_ENULL;
    if (!rw_is_friction(f) || !rw_is_signed(beta_f) || fabs(beta_f) > f / 2)
        return RWEDGE_EDOMAIN;
    double P, middle, tilt, tension, factor;
    int32_t status = rwedge_sliding_law(alpha, beta_f, held, &P, &middle, &tilt, &tension);
    if (status != RWEDGE_OK)
        return status;
    rwedge_contact *contact = NULL;
    status = slide(alpha, beta_f, f, held, P, &contact);
    if (status == RWEDGE_OK)
        status = rwedge_contact_yield_factor(contact, nu, 1, &factor, x, y);
    if (status == RWEDGE_OK)
        *limit = P * factor;
    rwedge_contact_destroy(contact);
    return status;
}
