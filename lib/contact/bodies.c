/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a contact is told of its bodies, beside their compliance. */
#include "base/domain.h"
#include "contact/handle.h"

#include <stdlib.h>

int32_t rwedge_contact_set_strain(rwedge_contact *contact, double strain_per_tension)
{
    if (!contact)
        return RWEDGE_ENULL;
    if (!rw_is_magnitude(strain_per_tension) || contact->phase != RW_APART)
        return RWEDGE_EDOMAIN;
    const double strain = 4 * (strain_per_tension / contact->geometry.A);
    if (!rw_is_magnitude(strain))
        return RWEDGE_EDOMAIN;
    contact->strain = strain;
    contact->memory.corners[0].stretch = rw_contact_stretch(contact, contact->loads.sigma);
    return RWEDGE_OK;
}

double rwedge_contact_strain(const rwedge_contact *contact)
{
    return contact ? contact->strain * (contact->geometry.A / 4) : NAN;
}

bool rw_contact_make_unlike(rwedge_contact *contact)
{
    free(contact->unlike);
    contact->unlike = NULL;
    const double mu = -contact->beta * contact->f;
    if (mu == 0)
        return true;
    contact->unlike = malloc(sizeof *contact->unlike);
    if (contact->unlike)
        rw_unlike_init(contact->unlike, mu);
    return contact->unlike != NULL;
}

int32_t rwedge_contact_set_beta(rwedge_contact *contact, double beta)
{
    if (!contact)
        return RWEDGE_ENULL;
    if (!rw_is_signed(beta) || fabs(beta) > 0.5 || contact->phase != RW_APART)
        return RWEDGE_EDOMAIN;
    const double before = contact->beta;
    contact->beta = beta;
    if (rw_contact_make_unlike(contact))
        return RWEDGE_OK;
    contact->beta = before;
    return RWEDGE_ENOMEM;
}

double rwedge_contact_beta(const rwedge_contact *contact)
{
    return contact ? contact->beta : NAN;
}

/* The compliance of a contact and that of its bodies differ at most so much, relatively. */
static const double SAME_COMPLIANCE = 1e-6;

int32_t rwedge_contact_set_bodies(rwedge_contact *contact, double E1, double nu1, double E2,
                                  double nu2)
{
    if (!contact)
        return RWEDGE_ENULL;
    const double A = rwedge_compliance(E1, nu1, E2, nu2);
    if (!islessequal(fabs(A - contact->geometry.A), SAME_COMPLIANCE * A))
        return RWEDGE_EDOMAIN;
    const int32_t status = rwedge_contact_set_beta(contact, rwedge_dundurs_beta(E1, nu1, E2, nu2));
    return status == RWEDGE_OK ? rwedge_contact_set_strain(contact, (1 - nu1) * (1 + nu1) / E1)
                               : status;
}
