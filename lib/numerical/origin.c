/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerical/origin.h"

#include "base/tuned.h"

/* ---- The beginning ---- */

typedef struct {
    const rw_numerical_state *now;
    rw_values slip;
    const void *context;
} beginning;

static void origin_at_first(const double x[], const void *context, double origin[])
{
    const beginning *b = context;
    double slip[RW_TERMS] = {0}, w[RW_TERMS];
    if (b->slip)
        b->slip(x, b->context, slip);
    rw_displacements_of(b->now, RW_TERMS, x, w);
    for (int i = 0; i < RW_TERMS; i++)
        origin[i] = slip[i] - w[i];
}

/* The tolerance of slip, in proportion to what friction and the stretch move. */
static double slip_tolerance(const rw_frame *frame, const rw_numerical_state *s)
{
    return RW_FIT_OF_SLIP * frame->tolerance * rw_patch_half_width(s->contact) *
           fmax(rw_peak_of(frame, s), fabs(s->at.stretch));
}

bool rw_numerical_count_slip(rw_numerical *n, const rw_frame *frame, rw_values slip,
                             const void *context)
{
    double at[RW_MOST_BENDS + 2];
    const beginning b = {&n->now, slip, context};
    const size_t breaks = rw_breaks_of(frame, n->now.contact, 0, NULL, at);
    rw_traction_destroy(&n->origin);
    n->has_origin = true;
    return rw_traction_fit(&n->origin, origin_at_first, &b, breaks, at,
                           slip_tolerance(frame, &n->now), 0);
}

double rw_numerical_slip(const rw_numerical *n, double x)
{
    return rw_traction_at(&n->origin, x) + rw_displacement_of(&n->now, x);
}

/* ---- New places in contact ---- */

/* A step in two halves. */
typedef struct {
    const rw_numerical *numerical; /* before it */
    const rw_numerical_state *half, *now;
} growth;

/* The part of the way between two states at which an edge of the contact came to a place. */
static double time_of_contact(rw_patch from, rw_patch to, double x)
{
    return x > from.right ? (x - from.right) / (to.right - from.right)
                          : (x - from.left) / (to.left - from.left);
}

/* Minus the displacement of places that come into contact in the step, at the time when they do,
 * interpolated between two states. They have slip 0 then, and keep it where they stick. */
static void new_origin(const double x[], const void *context, double origin[])
{
    enum { IN_FIRST_HALF, IN_SECOND_HALF, AT_END };
    const growth *g = context;
    const rw_numerical_state *const state[] = {&g->numerical->now, g->half, g->now};
    double w[3][RW_TERMS];
    int time[RW_TERMS];
    bool is_needed[3] = {false};
    for (int i = 0; i < RW_TERMS; i++) {
        const bool sticks = rw_zones_label(&g->half->shear.zones, x[i]) == 0 &&
                            rw_zones_label(&g->now->shear.zones, x[i]) == 0;
        time[i] = sticks                                 ? AT_END
                  : rw_patch_has(g->half->contact, x[i]) ? IN_FIRST_HALF
                                                         : IN_SECOND_HALF;
        is_needed[time[i]] = true;
        is_needed[time[i] < AT_END ? time[i] + 1 : AT_END] = true;
    }
    for (int k = 0; k < 3; k++)
        if (is_needed[k])
            rw_displacements_of(state[k], RW_TERMS, x, w[k]);
    for (int i = 0; i < RW_TERMS; i++) {
        const int k = time[i];
        const double part =
            k == AT_END ? 0 : time_of_contact(state[k]->contact, state[k + 1]->contact, x[i]);
        origin[i] = k == AT_END ? -w[k][i] : -(1 - part) * w[k][i] - part * w[k + 1][i];
    }
}

/* Appends the origin of places that came into contact; the edge at half the step may be between. */
static bool append_new(rw_traction *origin, const growth *g, double from, double half, double to,
                       double tolerance)
{
    const bool is_between = half > from && half < to;
    const double at[3] = {from, is_between ? half : to, to};
    return !(from < to) ||
           rw_traction_fit(origin, new_origin, g, is_between ? 3 : 2, at, tolerance, 0);
}

/* Whether so many elements are to be fewer: from 64 on, each time that they are twice as many. */
static bool has_many(size_t before, size_t count)
{
    return count >= 64 && (before ^ count) > before;
}

/* Each step of a growing contact adds some elements. */
bool rw_origin_renew(rw_numerical *n, const rw_frame *frame, const rw_numerical_state *half,
                     const rw_numerical_state *now)
{
    const rw_patch before = n->now.contact, contact = now->contact;
    const double left = fmax(contact.left, before.left), right = fmin(contact.right, before.right);
    if (!n->has_origin || (left == contact.left && right == contact.right))
        return true;
    const double tolerance = slip_tolerance(frame, now);
    const growth g = {n, half, now};
    rw_traction origin = {0};
    const bool is_done =
        append_new(&origin, &g, contact.left, half->contact.left, left, tolerance) &&
        rw_traction_append_part(&origin, &n->origin, left, right) &&
        append_new(&origin, &g, right, half->contact.right, contact.right, tolerance);
    if (!is_done) {
        rw_traction_destroy(&origin);
        return false;
    }
    if (has_many(n->origin.count, origin.count))
        rw_traction_simplify(&origin, tolerance);
    rw_traction_destroy(&n->origin);
    n->origin = origin;
    return true;
}
