/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerical/onset.h"

#include "base/tuned.h"

#include "numerical/rates.h"

/* Edges that stick at first, until slip begins at one of them. */
typedef struct {
    rw_work *work;
    const rw_numerical_state *from, *there;
    rw_zones sticking; /* the zones at the end, but these edges stick */
    rw_zones at_first; /* the zones at the beginning, but these edges stick */
    bool begins[2];    /* at the left, right edge */
    double beyond[2];  /* |D| - 1 there at the start */
} onset;

/* The zones, but an edge sticks. */
static rw_zones sticking_at(const rw_zones *zones, int side)
{
    rw_zones sticking = *zones;
    const rw_zone last = rw_zones_at_edge(zones, side);
    rw_pattern_insert(&sticking, &(rw_zones){1, {{0, last.left, last.right}}}, 0);
    return sticking;
}

/* The largest |D| of these edges at a moment of the step, less 1; > 0 where one slips already. */
static double beyond_at(const onset *o, double part)
{
    const rw_scaled_loads from = o->from->at, to = o->there->at;
    const rw_scaled_loads at = rw_part_of_line(from, to, part);
    rw_patch contact;
    rw_zones zones;
    rw_problem rates;
    double D[2], most = -1;
    if (!rw_step_zones(o->work, o->from, at, &o->sticking, false, &contact, &zones) &&
        !rw_step_zones(o->work, o->from, at, &o->at_first, false, &contact, &zones))
        return NAN;
    rw_step_rates(o->work, from, to, contact, &rates);
    rw_rates_free_ratio(&o->work->fronts, &rates, &zones, D);
    for (int side = 0; side < 2; side++)
        if (o->begins[side] && isnan(D[side]))
            return rw_zones_at_edge(&zones, side).label != 0 ? 1 : NAN;
        else if (o->begins[side])
            most = fmax(most, fabs(D[side]) - 1);
    return most;
}

/* |D| - 1 of an edge at the beginning, and at the end, if it sticks. */
static double beyond_at_start(const onset *o, int side)
{
    rw_problem rates;
    double D[2];
    rw_fronts *f = &o->work->fronts;
    const rw_zones sticking = sticking_at(&o->there->shear.zones, side);
    rw_step_rates(o->work, o->from->at, o->there->at, o->from->contact, &rates);
    const rw_zones begun = rw_rates_begun(f, &rates, &o->from->shear.zones, &sticking);
    rw_rates_free_ratio(f, &rates, &begun, D);
    return fabs(D[side]) - 1;
}

static double beyond_at_end(const onset *o, int side)
{
    rw_problem rates;
    double D[2];
    rw_step_rates(o->work, o->from->at, o->there->at, o->there->contact, &rates);
    rw_rates_free_ratio(&o->work->fronts, &rates, &o->there->shear.zones, D);
    return fabs(D[side]) - 1;
}

/* Finds the onset by regula falsi (Illinois), whose values beyond it may be no more than a sign. */
static double find(const onset *o)
{
    double low = 0, high = 1, at_high = 1;
    double at_low = fmax(o->begins[0] ? o->beyond[0] : -1, o->begins[1] ? o->beyond[1] : -1);
    for (int turn = 0; turn < RW_ONSET_TURNS && high - low > RW_ONSET_EXACT; turn++) {
        const double guess = turn == 0 ? 0.5 : low + at_low / (at_low - at_high) * (high - low);
        const double part = fmax(low + 0.1 * (high - low), fmin(high - 0.1 * (high - low), guess));
        const double beyond = beyond_at(o, part);
        if (isnan(beyond))
            return 1;
        if (beyond > -RW_ONSET_CLOSE) {
            high = part;
            at_high = beyond;
            at_low /= turn > 0 ? 2 : 1;
        } else {
            low = part;
            at_low = beyond;
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

/* Notes an edge at which slip begins within the step: it slips at the end, in another way than
 * before, or it should. */
static void look_at_edge(onset *o, int side)
{
    const int before = rw_zones_at_edge(&o->from->shear.zones, side).label,
              after = rw_zones_at_edge(&o->there->shear.zones, side).label;
    const bool grows = rw_edge_grows(o->from, o->there, side);
    const bool slips =
        grows && (after != 0 ? after != before : isgreater(beyond_at_end(o, side), 0));
    o->beyond[side] = slips ? beyond_at_start(o, side) : NAN;
    o->begins[side] = isless(o->beyond[side], -RW_ONSET_CLOSE);
}

/* The first onset at the edges that are noted; 1 where there is none, or none is found. */
static double first_of(onset *o)
{
    o->sticking = o->there->shear.zones;
    o->at_first = o->from->shear.zones;
    for (int side = 0; side < 2; side++)
        if (o->begins[side]) {
            o->sticking = sticking_at(&o->sticking, side);
            o->at_first = sticking_at(&o->at_first, side);
        }
    return o->begins[0] || o->begins[1] ? find(o) : 1;
}

double rw_onset_of_slip(rw_work *w, const rw_numerical_state *from, const rw_numerical_state *there)
{
    const double allowed = RW_ALLOWED * w->frame->tolerance;
    const bool grows = rw_edge_grows(from, there, 0) || rw_edge_grows(from, there, 1);
    onset o = {.work = w, .from = from, .there = there};
    for (int side = 0; side < 2 && grows; side++)
        look_at_edge(&o, side);
    double first = first_of(&o);
    if (first <= RW_ONSET_NEAREST && o.begins[0] && o.begins[1]) {
        /* slip begins at once at the edge that is nearer to it: the other edge alone */
        o.begins[o.beyond[0] < o.beyond[1]] = false;
        first = first_of(&o);
    }
    if (grows && first == 1 && there->start_error <= allowed && there->end_error > allowed)
        first = end_of_slip(w, from, there, allowed);
    return first > RW_ONSET_NEAREST && first < 1 - RW_ONSET_NEAREST ? first : 1;
}
