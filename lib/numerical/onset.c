/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerical/onset.h"

#include "base/tuned.h"

#include "numerical/rates.h"

/* An edge grows if it moves by more than this part of the half-width. */
static const double LEAST_GROWTH = 1e-6;

/* An edge that sticks at first and slips at the end. */
typedef struct {
    rw_work *work;
    const rw_numerical_state *from, *there;
    rw_zones sticking; /* the zones at the end, but this edge sticks */
    int side;
} onset;

static int label_at_edge(const rw_zones *zones, int side)
{
    return zones->zone[side ? zones->count - 1 : 0].label;
}

/* The zones, but an edge sticks. */
static rw_zones sticking_at(const rw_zones *zones, int side)
{
    rw_zones sticking = *zones;
    const rw_zone last = zones->zone[side ? zones->count - 1 : 0];
    rw_pattern_insert(&sticking, &(rw_zones){1, {{0, last.left, last.right}}}, 0);
    return sticking;
}

/* |D| at the edge at a moment of the step, less 1; > 0 where it slips already. */
static double excess_at(const onset *o, double part)
{
    const rw_scaled_loads from = o->from->at, to = o->there->at;
    const rw_scaled_loads at = rw_part_of_line(from, to, part);
    rw_patch contact;
    rw_zones zones;
    rw_problem rates;
    double D[2];
    if (!rw_step_zones(o->work, o->from, at, &o->sticking, false, &contact, &zones))
        return NAN;
    if (label_at_edge(&zones, o->side) != 0)
        return 1;
    rw_step_rates(o->work, from, to, contact, &rates);
    rw_rates_free_ratio(&o->work->fronts, &rates, &zones, D);
    return fabs(D[o->side]) - 1;
}

/* |D| - 1 at the beginning. */
static double excess_at_start(const onset *o)
{
    rw_problem rates;
    double D[2];
    rw_fronts *f = &o->work->fronts;
    rw_step_rates(o->work, o->from->at, o->there->at, o->from->contact, &rates);
    const rw_zones begun = rw_rates_begun(f, &rates, &o->from->shear.zones, &o->sticking);
    rw_rates_free_ratio(f, &rates, &begun, D);
    return fabs(D[o->side]) - 1;
}

/* By regula falsi (Illinois), whose values beyond the onset may be no more than a sign. */
static double find(const onset *o, double at_low)
{
    double low = 0, high = 1, at_high = 1;
    for (int turn = 0; turn < RW_ONSET_TURNS && high - low > RW_ONSET_EXACT; turn++) {
        const double guess = turn == 0 ? 0.5 : low + at_low / (at_low - at_high) * (high - low);
        const double part = fmax(low + 0.1 * (high - low), fmin(high - 0.1 * (high - low), guess));
        const double excess = excess_at(o, part);
        if (isnan(excess))
            return 1;
        if (excess > -RW_ONSET_CLOSE) {
            high = part;
            at_high = excess;
            at_low /= turn > 0 ? 2 : 1;
        } else {
            low = part;
            at_low = excess;
            at_high /= turn > 0 ? 2 : 1;
        }
    }
    return low;
}

/* ---- Slip that turns round ---- */

/* How wrong the zones of a moment are, over the scale (rates.h). */
static double wrong_at(rw_work *w, const rw_numerical_state *from, const rw_numerical_state *there,
                       double part)
{
    const rw_scaled_loads at = rw_part_of_line(from->at, there->at, part);
    rw_patch contact;
    rw_zones zones;
    rw_problem rates;
    if (!rw_step_zones(w, from, at, &there->shear.zones, false, &contact, &zones))
        return NAN;
    rw_step_rates(w, from->at, there->at, contact, &rates);
    return rw_rates_wrong(&w->fronts, &rates, &zones, &zones) / rw_peak_friction(w->frame, contact);
}

/* The last moment at which all slips the way it did at the start, 0 < part; 1 where it is not
 * found. */
static double end_of_slip(rw_work *w, const rw_numerical_state *from,
                          const rw_numerical_state *there, double allowed)
{
    double low = 0, high = 1;
    for (int turn = 0; turn < RW_ONSET_HALVINGS; turn++) {
        const double part = (low + high) / 2, wrong = wrong_at(w, from, there, part);
        if (isnan(wrong))
            return 1;
        if (wrong > allowed)
            high = part;
        else
            low = part;
    }
    return low;
}

/* ---- Both ---- */

static bool grows_at(const rw_numerical_state *from, const rw_numerical_state *there, int side)
{
    const double growth = side ? there->contact.right - from->contact.right
                               : from->contact.left - there->contact.left;
    return growth > LEAST_GROWTH * rw_patch_half_width(there->contact);
}

/* At an edge that grows. */
static double onset_at(rw_work *w, const rw_numerical_state *from, const rw_numerical_state *there,
                       int side)
{
    if (label_at_edge(&from->shear.zones, side) != 0 ||
        label_at_edge(&there->shear.zones, side) == 0)
        return 1;
    const onset o = {w, from, there, sticking_at(&there->shear.zones, side), side};
    const double excess = excess_at_start(&o);
    return excess < -RW_ONSET_CLOSE ? find(&o, excess) : 1;
}

double rw_onset_of_slip(rw_work *w, const rw_numerical_state *from, const rw_numerical_state *there)
{
    const double allowed = RW_ALLOWED * w->frame->tolerance;
    double first = 1;
    bool grows = false;
    for (int side = 0; side < 2; side++)
        if (grows_at(from, there, side)) {
            grows = true;
            first = fmin(first, onset_at(w, from, there, side));
        }
    if (grows && first == 1 && there->start_error <= allowed && there->end_error > allowed)
        first = end_of_slip(w, from, there, allowed);
    return first > RW_ONSET_NEAREST && first < 1 - RW_ONSET_NEAREST ? first : 1;
}
