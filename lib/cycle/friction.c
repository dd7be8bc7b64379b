/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Slip, shear and energy of a place, from state to state. Slip is counted from when the place came
 * into contact. A place that the contact leaves and meets again has several stays in the cycle. The
 * last stay continues as the first one of the next cycle. Any other stay begins with the slip at
 * the end of the stay before it: so a place beside an edge slips as much as a place that the edge
 * does not pass. */
#include "cycle/cycle.h"

typedef struct {
    const rw_states *all;
    double x, inside; /* the place; inside: moved off the edges of the states */
    bool touches;
    double slip, limit;     /* of the last state in which it slipped: slip; f |p| */
    size_t limit_at;        /* the state of that limit */
    double least, most;     /* slip of the present stay */
    double offset;          /* the slip that the stay begins with */
    double lowest, highest; /* of all stays that have ended */
    double shear, energy;
} place;

/* In roundings of an edge. */
static const double MARGIN = 4;

/* The place itself or, within rounding of an edge, a place inside that edge: slip may jump at an
 * edge, and the place must be on the same side of it in all states. */
static double off_the_edges(const rw_states *all, double x)
{
    const double margin = MARGIN * all->rounding;
    double left = -HUGE_VAL, right = HUGE_VAL;
    for (size_t i = 0; i < all->count; i++) {
        const rw_patch patch = all->states[i].patch;
        if (islessequal(fabs(patch.left - x), margin))
            left = fmax(left, patch.left);
        if (islessequal(fabs(patch.right - x), margin))
            right = fmin(right, patch.right);
    }
    return left > -HUGE_VAL ? left + margin : right < HUGE_VAL ? right - margin : x;
}

static bool is_in(const rw_state *state, double rounding, double x)
{
    return isgreaterequal(x, state->patch.left - rounding) &&
           islessequal(x, state->patch.right + rounding);
}

static double clamped(double x, rw_patch patch)
{
    return fmin(fmax(x, patch.left), patch.right);
}

/* NaN outside the contact. */
static double slip_at(const rw_states *all, size_t state, double x)
{
    const rw_state *now = &all->states[state];
    double slip = NAN;
    if (is_in(now, all->rounding, x)) {
        const double inside = clamped(x, now->patch);
        rwedge_contact_slip(now->contact, 1, &inside, &slip);
    }
    return slip;
}

/* f |p|. */
static double limit_at(const place *at, size_t state)
{
    const rw_state *now = &at->all->states[state];
    return now->contact->f * fabs(rw_contact_pressure(now->contact, clamped(at->x, now->patch)));
}

static double shear_at(const place *at, const rw_state *now)
{
    const double x = clamped(at->x, now->patch);
    double p, q = 0;
    rwedge_contact_tractions(now->contact, 1, &x, &p, &q);
    return fabs(q);
}

/* Where a place slips, its shear is f |p| all the way from one state to the next; p is taken to
 * change in proportion to the slip. */
static void slip_to(place *at, double slip, double limit)
{
    at->energy += (at->limit + limit) / 2 * fabs(slip - at->slip);
    at->most = fmax(at->most, slip);
    at->least = fmin(at->least, slip);
    at->slip = slip;
    at->limit = limit;
}

/* ---- Stays ---- */

static void touch(place *at, size_t state)
{
    at->touches = true;
    at->slip = at->limit = at->least = at->most = 0;
    at->limit_at = state;
}

static void end_stay(place *at)
{
    at->lowest = fmin(at->lowest, at->offset + at->least);
    at->highest = fmax(at->highest, at->offset + at->most);
    at->offset += at->slip;
    at->touches = false;
}

static void refresh_limit(place *at, size_t state)
{
    if (at->limit_at < state)
        at->limit = limit_at(at, state);
}

/* The place slips until the edge passes it. Its slip is interpolated: the change of slip is known
 * at the edge's new position, and 0 at its old one. The change is interpolated, not the slip
 * itself, which jumps at the border of the places that the contact has never left. */
static void leave(place *at, size_t to)
{
    const rw_states *all = at->all;
    const rw_patch before = all->states[to - 1].patch, after = all->states[to].patch;
    const bool is_left = at->inside < after.left;
    const double start = is_left ? before.left : before.right;
    const double end = is_left ? after.left : after.right;
    const double margin = MARGIN * all->rounding, near = is_left ? end + margin : end - margin;
    const double change = slip_at(all, to, near) - slip_at(all, to - 1, near);
    refresh_limit(at, to - 1);
    if (!isnan(change)) /* part of the contact is where some of it was */
        slip_to(at, at->slip + change * (at->inside - start) / (end - start), 0);
    end_stay(at);
}

/* ---- From state to state ---- */

/* A place that slips at the end of a step has the shear f |p|. A place that sticks has its largest
 * shear after a load. */
static void go_to(place *at, size_t to)
{
    const rw_state *now = &at->all->states[to];
    const bool is_new = !at->touches;
    if (is_new)
        touch(at, to);
    if (is_new || at->inside < now->stuck.left || at->inside > now->stuck.right) {
        refresh_limit(at, to - 1);
        slip_to(at, slip_at(at->all, to, at->inside), limit_at(at, to));
        at->limit_at = to;
        at->shear = fmax(at->shear, now->is_load ? 0 : shear_at(at, now));
    }
    if (now->is_load)
        at->shear = fmax(at->shear, shear_at(at, now));
}

/* Slip before the cycle adds nothing to the energy of the cycle. */
static void begin(place *at, double before)
{
    const rw_state *first = at->all->states;
    if (!is_in(first, at->all->rounding, at->inside))
        return;
    touch(at, 0);
    at->offset = before;
    at->slip = at->least = at->most = slip_at(at->all, 0, at->inside);
    at->limit = limit_at(at, 0);
    at->shear = shear_at(at, first);
}

/* Goes through the cycle. `before` is the slip of the present stay that the cycle does not know. */
static place go_through(const rw_states *all, double x, double before)
{
    place at = {.all = all, .x = x, .lowest = HUGE_VAL, .highest = -HUGE_VAL};
    at.inside = off_the_edges(all, x);
    begin(&at, before);
    const bool began = at.touches;
    for (size_t i = 1; i < all->count; i++)
        if (is_in(&all->states[i], all->rounding, at.inside))
            go_to(&at, i);
        else if (at.touches)
            leave(&at, i);
    if (at.touches) {
        at.offset = began ? 0 : at.offset;
        end_stay(&at);
    }
    return at;
}

rw_slip_measures rw_slip_measures_at(const rw_states *all, double x)
{
    place at = go_through(all, x, 0);
    if (all->is_counted) /* it is taken for the slip that the last stay ends with */
        at = go_through(all, x, at.slip);
    return (rw_slip_measures){fmax(at.highest - at.lowest, 0), at.shear, at.energy};
}
