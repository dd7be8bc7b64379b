/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model.h"

#include <math.h>

/* A smaller swing is rounding. */
static const double ROUNDING = 1e-9;

static double middle_of(const rwedge_contact *contact)
{
    double left = 0, right = 0;
    rwedge_contact_edges(contact, &left, &right);
    return left / 2 + right / 2;
}

/* sxx at a place of the surface. */
static double tension_at(const rwedge_contact *contact, double x)
{
    const double surface = 0;
    double sxx = NAN, syy, txy;
    rwedge_contact_stresses(contact, 1, &x, &surface, &sxx, &syy, &txy);
    return sxx;
}

/* A little beside the trailing edge of that contact which reaches farther, as rwedge_coupling() has
 * it. */
static double place_beside(const rwedge_contact *one, const rwedge_contact *other, double side)
{
    const double BESIDE = 0.06; /* of the half-width */
    double left = 0, right = 0, other_left = 0, other_right = 0;
    rwedge_contact_edges(one, &left, &right);
    rwedge_contact_edges(other, &other_left, &other_right);
    const double half = right / 2 - left / 2;
    return side > 0 ? fmin(left, other_left) - BESIDE * half
                    : fmax(right, other_right) + BESIDE * half;
}

static coupling compare(const rwedge_contact *contact, const rwedge_contact *similar,
                        bool knows_shear)
{
    const load now = loads_of(contact);
    const double side = now.Q < 0 ? -1 : 1;
    const double swing =
        (middle_of(contact) - middle_of(similar)) / rwedge_contact_half_width(contact);
    coupling of = {.swing = fabs(swing) > ROUNDING ? side * swing : 0, .tension = NAN};
    if (!knows_shear || now.Q == 0)
        return of;
    const double x = place_beside(contact, similar, side);
    const double without = tension_at(similar, x);
    if (without > 0)
        of.tension = tension_at(contact, x) / without - 1;
    return of;
}

coupling coupling_of(const contact_case *setup, const rwedge_contact *contact, bool has_history)
{
    const load now = loads_of(contact);
    load to = {.P = now.P, .M = now.M};
    contact_case alike = *setup;
    coupling of = {.swing = NAN, .tension = NAN};
    alike.is_coupled = false;
    alike.contact = NULL;
    if (!setup->is_coupled || !(rwedge_contact_half_width(contact) > 0))
        return (coupling){0};
    if (alike.is_held)
        alike.tilt = rwedge_contact_tilt(contact);
    int32_t status = case_contact(&alike, &alike.contact);
    if (status == RWEDGE_OK)
        status = loads_apply(to, alike.contact);
    to.Q = now.Q;
    to.sigma = now.sigma;
    if (status == RWEDGE_OK && !has_history)
        status = loads_apply(to, alike.contact);
    if (status == RWEDGE_OK)
        of = compare(contact, alike.contact, !has_history);
    rwedge_contact_destroy(alike.contact);
    return of;
}
