/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerical/energy.h"

#include "base/tuned.h"

#include "numerical/rates.h"

/* Half-way is the end where the step was taken as a whole. */
typedef struct {
    rw_work *work;
    const rw_numerical_state *from, *half, *there;
} way;

/* ---- The power, in energy per way ---- */

static rw_problem rates_at(const way *l, rw_patch contact)
{
    rw_problem rates;
    rw_step_rates(l->work, l->from->at, l->there->at, contact, &rates);
    return rates;
}

static double power_of(const way *l, rw_patch contact, const rw_zones *zones)
{
    const rw_problem rates = rates_at(l, contact);
    return rw_rates_power(&l->work->fronts, &rates, zones);
}

static double power_at_start(const way *l)
{
    const rw_numerical_state *from = l->from;
    const rw_problem rates = rates_at(l, from->contact);
    const rw_zones begun =
        rw_rates_begun(&l->work->fronts, &rates, &from->shear.zones, &l->half->shear.zones);
    return power_of(l, from->contact, &begun);
}

/* The power at a part of the way, where the zones are like those at the next moment that is
 * known. */
static double power_at(const way *l, double part)
{
    const rw_scaled_loads at = rw_part_of_line(l->from->at, l->there->at, part);
    const rw_numerical_state *next = part < 0.5 ? l->half : l->there;
    rw_patch contact;
    rw_zones zones;
    return rw_step_zones(l->work, l->from, at, &next->shear.zones, true, &contact, &zones)
               ? power_of(l, contact, &zones)
               : NAN;
}

/* ---- Its integral ---- */

typedef struct {
    double energy, doubt;
} estimate;

/* Simpson's rule over a part of the way. It is exact where slip has just begun at an edge: the
 * power rises there with the square of time. */
static double by_three(double length, const double power[])
{
    return length * (power[0] + 4 * power[1] + power[2]) / 6;
}

/* The integral over a part of the way with this power at its ends and in the middle. Where slip
 * passes the marks of earlier loads the power jumps: there the parts become shorter, as long as two
 * rules differ by more than is allowed. A jump is in one part of its length: what is allowed is for
 * each part. */
static estimate integral(const way *l, double from, double to, const double power[], double allowed,
                         int halvings)
{
    const double length = to - from, middle = from + length / 2;
    const double first[] = {power[0], power_at(l, from + length / 4), power[1]},
                 last[] = {power[1], power_at(l, to - length / 4), power[2]};
    const double three = by_three(length, power),
                 five = by_three(length / 2, first) + by_three(length / 2, last);
    if (!isfinite(five))
        return (estimate){three, three};
    if (halvings == 0 || fabs(five - three) <= allowed)
        return (estimate){five, fabs(five - three)};
    const estimate a = integral(l, from, middle, first, allowed, halvings - 1),
                   b = integral(l, middle, to, last, allowed, halvings - 1);
    return (estimate){a.energy + b.energy, a.doubt + b.doubt};
}

static estimate by_power(const way *l)
{
    const rw_numerical_state *half = l->half, *there = l->there;
    const double power[] = {power_at_start(l),
                            half == there ? power_at(l, 0.5)
                                          : power_of(l, half->contact, &half->shear.zones),
                            power_of(l, there->contact, &there->shear.zones)};
    return integral(l, 0, 1, power, RW_ENERGY_EXACT * by_three(1, power), RW_ENERGY_HALVINGS);
}

void rw_settle_energy(rw_work *w, const rw_numerical_state *from, const rw_numerical_state *half,
                      rw_numerical_state *there)
{
    const double part = half == there ? RW_ENERGY_OF_WHOLE : RW_ENERGY_OF_HALVES;
    const estimate by_slip = {there->energy - from->energy, part * there->doubt};
    if (!(by_slip.doubt > RW_ENERGY_ENOUGH * by_slip.energy))
        return;
    const int effort = w->effort; /* what steps may take does not depend on their energy */
    const estimate other = by_power(&(way){w, from, half, there});
    w->effort = effort;
    if (isless(other.doubt, by_slip.doubt))
        there->energy = from->energy + other.energy;
}
