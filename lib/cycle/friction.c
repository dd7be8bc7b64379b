/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Slip, shear and energy of a place, from state to state. Slip is the displacement of the surfaces
 * against each other, counted from when the place came into contact first. Where the contact leaves
 * it and comes back, slip goes on from the displacement at the moment when they meet again. */
#include "cycle/states.h"

#include "history/gap.h"
#include "traction/transform.h"

#include <stdlib.h>

typedef struct {
    const rwedge_cycle *cycle;
    double x, inside;    /* the place; inside: moved off the edges of the states */
    double height;       /* of the profile there */
    rw_piece_sum *sums;  /* over the first pieces of the state; sums[0] is for none */
    size_t top;          /* of the present state */
    const rw_piece *own; /* those of the next state */
    bool touches;
    double slip, limit; /* of the last state in which it slipped: displacement; f |p| */
    size_t limit_at;    /* the state of that limit */
    double least, most; /* displacement while in contact */
    double moved;       /* by the shear of the present state, where it is computed */
    double shear, energy;
} place;

/* How near to an edge a place counts as the edge, in roundings of one. */
static const double MARGIN = 4;

/* The place itself or, within rounding of an edge, a place inside that edge: slip may jump at an
 * edge, and the place must be on the same side of it in all states. */
static double off_the_edges(const rwedge_cycle *cycle, double x)
{
    const double margin = MARGIN * cycle->rounding;
    double left = -HUGE_VAL, right = HUGE_VAL;
    for (size_t i = 0; i < cycle->count; i++) {
        const rw_patch patch = cycle->states[i].patch;
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

/* ---- A state ---- */

static double pressure_of(const place *at, rw_patch patch)
{
    const double x = clamped(at->x, patch);
    return fabs(x - at->x) <= at->cycle->rounding
               ? rw_pressure_of(&at->cycle->before->geometry, patch, x)
               : 0;
}

static void add_piece(place *at, size_t to, const rw_piece *piece)
{
    const rw_geometry *g = &at->cycle->before->geometry;
    const rw_patch patch = piece->patch;
    const double gap = rw_patch_gap(g, patch, at->inside);
    const rw_piece_sum *below = &at->sums[to - 1];
    at->sums[to] = (rw_piece_sum){below->displacement + piece->weight * (gap - at->height),
                                  below->shear + piece->weight * pressure_of(at, patch)};
}

static void follow(place *at, size_t state)
{
    const rw_entry *entry = &at->cycle->on_the_way.entries[state];
    for (size_t i = 0; i < entry->own; i++)
        add_piece(at, entry->kept + i + 1, &at->own[i]);
    at->own += entry->own;
    at->top = entry->kept + entry->own;
}

/* What the pressure of unlike bodies moves. */
static double pressed_by(const rwedge_contact *c, const rw_entry *entry, double x)
{
    return entry->pressed.count > 0 ? -c->beta / c->f * rw_traction_load_to(&entry->pressed, x) : 0;
}

static double displacement_at(const place *at, size_t state)
{
    const rwedge_contact *c = at->cycle->before;
    const rw_state *now = &at->cycle->states[state];
    const rw_entry *entry = &at->cycle->on_the_way.entries[state];
    const double sum = now->is_computed ? at->moved - pressed_by(c, entry, at->inside)
                                        : c->f * at->sums[at->top].displacement;
    return c->geometry.theta * sum + now->displacement.slope * at->inside + now->displacement.shift;
}

/* f |p|. */
static double limit_at(const place *at, size_t state)
{
    const rwedge_contact *c = at->cycle->before;
    const rw_patch patch = at->cycle->states[state].patch;
    const rw_traction *pressed = &at->cycle->on_the_way.entries[state].pressed;
    if (pressed->count > 0)
        return rw_unit_stress(&c->geometry) *
               fmax(0, rw_traction_at(pressed, clamped(at->x, patch)));
    return c->f * rw_unit_stress(&c->geometry) *
           fabs(rw_pressure_of(&c->geometry, patch, clamped(at->x, patch)));
}

static double shear_at(const place *at, size_t state)
{
    const rwedge_contact *c = at->cycle->before;
    const rw_state *now = &at->cycle->states[state];
    const double shear = now->is_computed
                             ? rw_traction_at(&at->cycle->on_the_way.entries[state].shear,
                                              clamped(at->x, now->patch))
                             : c->f * at->sums[at->top].shear;
    return rw_unit_stress(&c->geometry) * fabs(shear);
}

/* ---- From state to state ---- */

static void refresh_limit(place *at, size_t state)
{
    if (at->limit_at < state)
        at->limit = limit_at(at, state);
}

static void be_at(place *at, double slip)
{
    at->most = fmax(at->most, slip);
    at->least = fmin(at->least, slip);
    at->slip = slip;
}

/* Where a place slips, its shear is f |p| all the way from one state to the next; p is taken to
 * change in proportion to the slip. Next to an edge, where it is 0, it is like a root of that. */
static void slip_to(place *at, double slip, double limit)
{
    const bool has_edge = at->limit == 0 || limit == 0;
    at->energy += (at->limit + limit) * (has_edge ? 2.0 / 3 : 0.5) * fabs(slip - at->slip);
    at->limit = limit;
    be_at(at, slip);
}

/* The slip of a place since it came into contact in the step to a state: of the polynomial through
 * the nodes of its ring. */
static double slip_since_touch(const place *at, size_t state)
{
    const rw_state *states = at->cycle->states, *now = &states[state];
    const rw_patch old = state > 0 ? states[state - 1].patch : now->patch;
    const int side = at->inside < rw_ring_of(old, now->patch, 0).left ? 0 : 1;
    const rw_patch ring = rw_ring_of(old, now->patch, side);
    const double part = (at->inside - ring.left) / (ring.right - ring.left);
    double sum = 0;
    for (int i = 0; i < RW_RING; i++) {
        double weight = 1;
        for (int k = 0; k < RW_RING; k++)
            weight *= k == i ? 1 : (part - rw_ring_node(k)) / (rw_ring_node(i) - rw_ring_node(k));
        sum += weight * now->ring[side][i];
    }
    return sum;
}

/* Whether a place has stuck since it slipped last: in closed form as the step tells, in a computed
 * state where it sticks and has moved by no more than the error. */
static bool has_stuck(const place *at, const rw_state *now, double slip)
{
    bool sticks = at->inside >= now->stuck.left && at->inside <= now->stuck.right;
    for (int i = 0; i < now->stick_count && !sticks; i++)
        sticks = at->inside >= now->sticks[i].left && at->inside <= now->sticks[i].right &&
                 fabs(slip - at->slip) <= now->noise;
    return sticks;
}

/* A place that slips at the end of a step has the shear f |p|. A place that sticks has its largest
 * shear after a load. */
static void go_to(place *at, size_t to)
{
    const rw_state *now = &at->cycle->states[to];
    const bool is_new = !at->touches;
    const bool rests = !is_new && at->inside >= now->stuck.left && at->inside <= now->stuck.right;
    const double slip = rests ? at->slip : displacement_at(at, to);
    if (is_new || !has_stuck(at, now, slip)) {
        refresh_limit(at, is_new ? to : to - 1);
        if (is_new) {
            be_at(at, slip - slip_since_touch(at, to));
            at->limit = 0;
        }
        slip_to(at, slip, limit_at(at, to));
        at->shear = fmax(at->shear, now->is_load ? 0 : shear_at(at, to));
        at->limit_at = to;
    }
    at->touches = true;
    if (now->is_load)
        at->shear = fmax(at->shear, shear_at(at, to));
}

/* The place slips until the edge passes it. Its slip is interpolated: the change of slip is known
 * at the edge's new position, and 0 at its old one. */
static void leave(place *at, size_t to)
{
    const rw_state *now = &at->cycle->states[to];
    const rw_patch before = now[-1].patch, after = now->patch;
    const int side = at->inside < after.left ? 0 : 1;
    const double start = side == 0 ? before.left : before.right;
    const double end = side == 0 ? after.left : after.right;
    const bool overlaps = fmax(before.left, after.left) < fmin(before.right, after.right);
    refresh_limit(at, to - 1);
    if (overlaps)
        slip_to(at, at->slip + now->leave[side] * (at->inside - start) / (end - start), 0);
    at->touches = false;
}

/* Slip before the cycle adds nothing to the energy of the cycle. */
static void begin(place *at)
{
    if (!is_in(at->cycle->states, at->cycle->rounding, at->inside))
        return;
    at->touches = true;
    be_at(at, displacement_at(at, 0));
    at->limit = limit_at(at, 0);
    at->shear = shear_at(at, 0);
}

static size_t room_of_place(const rwedge_cycle *cycle)
{
    return cycle->on_the_way.most + 1;
}

rw_piece_sum *rw_cycle_room(const rwedge_cycle *cycle)
{
    return calloc(RW_SLIP_PLACES * room_of_place(cycle), sizeof(rw_piece_sum));
}

static place place_at(const rwedge_cycle *cycle, double x, rw_piece_sum room[])
{
    const double inside = off_the_edges(cycle, x);
    return (place){.cycle = cycle,
                   .x = x,
                   .inside = inside,
                   .height = rw_profile_height(&cycle->before->geometry, inside),
                   .sums = room,
                   .own = cycle->on_the_way.own.all,
                   .least = HUGE_VAL,
                   .most = -HUGE_VAL};
}

static void step_to(place *at, size_t state)
{
    const rwedge_cycle *cycle = at->cycle;
    follow(at, state);
    if (state == 0)
        begin(at);
    else if (is_in(&cycle->states[state], cycle->rounding, at->inside))
        go_to(at, state);
    else if (at->touches)
        leave(at, state);
}

/* Where one of the places is in contact. */
static void find_moves(const rwedge_cycle *cycle, size_t state, size_t n, place at[])
{
    const rw_state *now = &cycle->states[state];
    double x[RW_SLIP_PLACES], moved[RW_SLIP_PLACES];
    bool is_asked = false;
    for (size_t i = 0; i < n; i++) {
        x[i] = at[i].inside;
        is_asked = is_asked || is_in(now, cycle->rounding, x[i]);
    }
    if (!is_asked || !now->is_computed)
        return;
    for (size_t i = 0; i < n; i += RW_TERMS)
        rw_traction_displacements(&cycle->on_the_way.entries[state].shear,
                                  n - i < RW_TERMS ? n - i : RW_TERMS, x + i, moved + i);
    for (size_t i = 0; i < n; i++)
        at[i].moved = moved[i];
}

/* All places go from state to state together: one that is computed has much to be read. */
void rw_slip_measures_at(const rwedge_cycle *cycle, size_t n, const double x[], rw_piece_sum room[],
                         rw_slip_measures measures[])
{
    place at[RW_SLIP_PLACES];
    for (size_t i = 0; i < n; i++)
        at[i] = place_at(cycle, x[i], room + i * room_of_place(cycle));
    for (size_t state = 0; state < cycle->count; state++) {
        find_moves(cycle, state, n, at);
        for (size_t i = 0; i < n; i++)
            step_to(&at[i], state);
    }
    for (size_t i = 0; i < n; i++)
        measures[i] =
            (rw_slip_measures){fmax(at[i].most - at[i].least, 0), at[i].shear, at[i].energy};
}
