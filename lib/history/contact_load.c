/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The next load of a contact: whether it is allowed, and what it does. */
#include "history/contact.h"
#include "history/dissipation.h"

#include <float.h>

/* How far Q may exceed f P: Q, f and P are each rounded, and so is their product; where a caller
 * interpolates between two loads, they are rounded like the larger. */
static const double SLIDING_ROUNDING = 8 * DBL_EPSILON;

/* Of the load in one step: beyond, the rounding of the last load would be seen in what Q/(fP)
 * is, 2e-7 of it here. */
static const double STEEPEST_FALL = 1e-8;

/* Q/f, at friction's limit exactly. */
static int32_t shear_of(const rwedge_contact *contact, double P, double Q, double *shear)
{
    const double limit = contact->f * P, magnitude = fabs(Q);
    const double last = rw_memory_end(&contact->memory)->load;
    const double rounding = P > 0 ? SLIDING_ROUNDING * contact->f * fmax(P, last) : 0;
    if (magnitude > limit + rounding)
        return RWEDGE_ESLIDING;
    if (magnitude >= limit - rounding)
        *shear = Q > 0 ? P : Q < 0 ? -P : 0;
    else
        *shear = Q / limit * P;
    return RWEDGE_OK;
}

/* Whether lengths and pressures stay in the domain. */
static bool is_in_range(const rw_geometry *g, double P)
{
    const double b = rw_half_width(g, P);
    if (!rw_is_contact_size(g, b))
        return false;
    return g->a == 0 || rw_is_positive(rw_unit_stress(g) * rwedge_peak_pressure(g->a / b));
}

/* The energy of the step to the load, never negative. */
static double energy_of(const rwedge_contact *contact, double P, double shear)
{
    const rw_geometry *g = &contact->geometry;
    const double corner_load = RW_HALF_PI * g->a * rw_unit_stress(g);
    const double f_over_pi = contact->f / RW_PI;
    const double integral = rw_dissipation(&contact->memory, P, shear, corner_load);
    return contact->f * g->A * (f_over_pi * fmax(0, integral));
}

static void measure_new_corners(rwedge_contact *contact)
{
    rw_memory *memory = &contact->memory;
    for (size_t i = memory->count; i-- > 1 && isnan(memory->corners[i].half_width);)
        memory->corners[i].half_width = rw_half_width(&contact->geometry, memory->corners[i].load);
}

int32_t rwedge_contact_load(rwedge_contact *contact, double P, double Q)
{
    if (!contact)
        return RWEDGE_ENULL;
    if (!rw_is_magnitude(P) || !rw_is_signed(Q))
        return RWEDGE_EDOMAIN;
    if (P > 0 && (!is_in_range(&contact->geometry, P) ||
                  P < STEEPEST_FALL * rw_memory_end(&contact->memory)->load))
        return RWEDGE_ERANGE;
    double shear;
    const int32_t status = shear_of(contact, P, Q, &shear);
    if (status != RWEDGE_OK)
        return status;
    const double share = energy_of(contact, P, shear) + contact->energy_carry;
    if (contact->energy + share > RW_LARGEST)
        return RWEDGE_ERANGE;
    /* the carry may be negative */
    const double energy = fmax(contact->energy, contact->energy + share);
    const rw_departure departure = rw_memory_departure(&contact->memory, P, shear);
    if (!rw_memory_reserve(&contact->memory, 2) ||
        !rw_slip_origins_advance(&contact->origins, &contact->memory, departure.slip != 0, P,
                                 shear))
        return RWEDGE_ENOMEM;
    rw_memory_advance(&contact->memory, &departure, P, shear);
    measure_new_corners(contact);
    contact->energy_carry = share - (energy - contact->energy);
    contact->energy = energy;
    return RWEDGE_OK;
}
