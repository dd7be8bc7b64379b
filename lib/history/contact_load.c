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

/* Loads that an arithmetic of squares and ratios can hold, a width that a search of the
 * half-plane can multiply, and a stress of which tensors can be summed. */
static const double SMALLEST_LOAD = 1e-148, LARGEST_LOAD = 1e148, LARGEST_WIDTH = 1e300,
                    LARGEST_STRESS = 1e300;

/* Peak pressure of the sharp wedge in theta/A, as near to its apex as is_apex() allows: (2/pi)
 * arcosh(1/DBL_MIN). */
static const double SHARP_PEAK = 452;

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

/* Whether the peak pressure is a normal number, and friction's traction under it not too large. */
static bool is_pressure_in_range(const rwedge_contact *contact, double b)
{
    const rw_geometry *g = &contact->geometry;
    const double peak = g->a > 0 ? rwedge_peak_pressure(g->a / b) : SHARP_PEAK;
    const rw_scaled pressure = rw_scaled_times(rw_unit_stress(g), rw_scaled_from(peak));
    const double traction =
        rw_scaled_value(rw_scaled_times(pressure, rw_scaled_from(fmax(1, contact->f))));
    /* it may be NaN */
    return rw_scaled_is_normal(pressure) && islessequal(traction, LARGEST_STRESS);
}

/* Whether lengths and stresses under the load stay far from the ends of the range of a double;
 * next to an a/b that underflows to 0 the apex of the sharp wedge would appear. */
static bool is_in_range(const rwedge_contact *contact, double P)
{
    const rw_geometry *g = &contact->geometry;
    const double b = rw_half_width(g, P);
    return P >= SMALLEST_LOAD && P <= LARGEST_LOAD && isnormal(b) && b <= LARGEST_WIDTH &&
           rw_patch_matters(b, g->a) && (g->a == 0 || rw_quotient_is_normal(g->a, b)) &&
           is_pressure_in_range(contact, b);
}

/* The load (pi/2) a theta/A under which the rounding is just filled, over 2^doublings. */
static double corner_load_of(const rw_geometry *g, int doublings)
{
    if (g->a == 0)
        return 0;
    const rw_scaled width = rw_scaled_times(rw_scaled_from(RW_HALF_PI), rw_scaled_from(g->a));
    rw_scaled load = rw_scaled_times(width, rw_unit_stress(g));
    load.exponent -= doublings;
    /* where all is Hertz, whatever it is */
    return load.exponent > 1000 ? 1e300 : rw_scaled_value(load);
}

/* NaN where it is too large for a double. */
static double energy_of(const rwedge_contact *contact, double P, double shear)
{
    const double largest = fmax(P, rw_memory_end(&contact->memory)->load);
    if (contact->f == 0 || largest == 0)
        return 0;
    const int doublings = ilogb(largest);
    const double in_units = rw_dissipation(&contact->memory, P, shear, rw_power_of_two(doublings),
                                           corner_load_of(&contact->geometry, doublings));
    if (!(in_units > 0))
        return 0;
    const rw_scaled f = rw_scaled_from(contact->f),
                    f_over_pi = rw_scaled_over(f, rw_scaled_from(RW_PI));
    const rw_scaled factor = rw_scaled_times(f, rw_scaled_from(contact->geometry.A));
    rw_scaled energy =
        rw_scaled_times(factor, rw_scaled_times(f_over_pi, rw_scaled_from(in_units)));
    energy.exponent += 2 * doublings;
    return rw_scaled_value(energy);
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
    if (!rw_is_nonnegative(P) || !isfinite(Q))
        return RWEDGE_EDOMAIN;
    if (P > 0 &&
        (!is_in_range(contact, P) || P < STEEPEST_FALL * rw_memory_end(&contact->memory)->load))
        return RWEDGE_ERANGE;
    double shear;
    const int32_t status = shear_of(contact, P, Q, &shear);
    if (status != RWEDGE_OK)
        return status;
    const double share = energy_of(contact, P, shear) + contact->energy_carry;
    if (!isfinite(share) || contact->energy / 2 + share / 2 > DBL_MAX / 2)
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
