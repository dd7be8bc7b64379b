/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerical/energy.h"

#include "numerical/rates.h"

/* What the energy by slip errs by at most, over its doubt (outcome.h), as measured where the doubt
 * is less than the energy: of a step as a whole, and of one extrapolated from its halves. */
static const double OF_WHOLE = 0.2, OF_HALVES = 0.04;

/* The relative error that is looked for. */
static const double ENOUGH = 0.03;

/* The way is halved so many times at most, to look at the power in more moments. */
enum { DEPTH = 3 };

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
    const rw_friction *friction = rw_step_friction(l->work, contact);
    return friction ? rw_rates_power(&l->work->fronts, &rates, friction, zones) : NAN;
}

static double power_at_start(const way *l)
{
    const rw_numerical_state *from = l->from;
    const rw_problem rates = rates_at(l, from->contact);
    const rw_zones begun =
        rw_rates_begun(&l->work->fronts, &rates, &from->shear.zones, &l->half->shear.zones);
    return power_of(l, from->contact, &begun);
}

/* At a part of the way, where the zones are like those at the next moment that is known. */
static double power_at(const way *l, double part)
{
    const rw_scaled_loads at = rw_part_of_line(l->from->at, l->there->at, part);
    const rw_numerical_state *next = part < 0.5 ? l->half : l->there;
    rw_patch contact;
    rw_zones zones;
    return rw_step_zones(l->work, l->from, at, &next->shear.zones, &contact, &zones)
               ? power_of(l, contact, &zones)
               : NAN;
}

/* ---- Its integral ---- */

typedef struct {
    double energy, doubt;
} estimate;

/* The mean of a power between two moments, if its root is linear: so it is where slip has just
 * begun at an edge. */
static double by_ends(double first, double last)
{
    return (first + last + sqrt(first * last)) / 3;
}

/* By Simpson's rule, which is exact then too. Both rules differ by the doubt. */
static estimate by_three(double length, const double power[])
{
    const double mean = (power[0] + 4 * power[1] + power[2]) / 6;
    const double other = by_ends(power[0], power[1]) / 2 + by_ends(power[1], power[2]) / 2;
    return (estimate){length * mean, length * fabs(mean - other)};
}

/* Over a part of the way with this power at its ends and in the middle. In more moments, as long as
 * the doubt is larger than allowed. Three moments of all the way are too few: where slip passes the
 * marks of earlier loads the power jumps, and both rules may agree by chance. */
static estimate integral(const way *l, double from, double to, const double power[], double allowed,
                         int depth)
{
    const double length = to - from, middle = from + length / 2;
    const estimate three = by_three(length, power);
    if (depth == 0 || (depth < DEPTH && !(three.doubt > allowed)))
        return three;
    const double first[] = {power[0], power_at(l, from + length / 4), power[1]},
                 last[] = {power[1], power_at(l, to - length / 4), power[2]};
    const estimate a = integral(l, from, middle, first, allowed / 2, depth - 1),
                   b = integral(l, middle, to, last, allowed / 2, depth - 1);
    const estimate both = {a.energy + b.energy, a.doubt + b.doubt};
    return isfinite(both.energy) ? both : three;
}

static estimate by_power(const way *l)
{
    const rw_numerical_state *half = l->half, *there = l->there;
    const double power[] = {power_at_start(l),
                            half == there ? power_at(l, 0.5)
                                          : power_of(l, half->contact, &half->shear.zones),
                            power_of(l, there->contact, &there->shear.zones)};
    return integral(l, 0, 1, power, ENOUGH * by_three(1, power).energy, DEPTH);
}

void rw_settle_energy(rw_work *w, const rw_numerical_state *from, const rw_numerical_state *half,
                      rw_numerical_state *there)
{
    const double part = half == there ? OF_WHOLE : OF_HALVES;
    const estimate by_slip = {there->energy - from->energy, part * there->doubt};
    if (!(by_slip.doubt > ENOUGH * by_slip.energy))
        return;
    const estimate other = by_power(&(way){w, from, half, there});
    if (isless(other.doubt, by_slip.doubt))
        there->energy = from->energy + other.energy;
}
