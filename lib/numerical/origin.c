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
    double slip[RW_TERMS] = {0};
    if (b->slip)
        b->slip(x, b->context, slip);
    for (int i = 0; i < RW_TERMS; i++)
        origin[i] = slip[i] - rw_displacement_of(b->now, x[i]);
}

/* Over what friction and what the stretch moves. */
static double slip_tolerance(const rw_frame *frame, const rw_numerical_state *s)
{
    return RW_FIT_OF_SLIP * frame->tolerance * rw_patch_half_width(s->contact) *
           fmax(rw_peak_friction(frame, s->contact), fabs(s->at.stretch));
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

/* Minus the displacement at the time when an edge of the contact came to a place, interpolated
 * between two states. */
static double origin_between(const rw_numerical_state *from, const rw_numerical_state *to, double x)
{
    const double part = x > from->contact.right
                            ? (x - from->contact.right) / (to->contact.right - from->contact.right)
                            : (x - from->contact.left) / (to->contact.left - from->contact.left);
    return -(1 - part) * rw_displacement_of(from, x) - part * rw_displacement_of(to, x);
}

/* Of a place that comes into contact in the step. It has slip 0 then, and keeps it where it
 * sticks. */
static void new_origin(const double x[], const void *context, double origin[])
{
    const growth *g = context;
    for (int i = 0; i < RW_TERMS; i++) {
        const bool sticks = rw_zones_label(&g->half->shear.zones, x[i]) == 0 &&
                            rw_zones_label(&g->now->shear.zones, x[i]) == 0;
        origin[i] = sticks ? -rw_displacement_of(g->now, x[i])
                    : rw_patch_has(g->half->contact, x[i])
                        ? origin_between(&g->numerical->now, g->half, x[i])
                        : origin_between(g->half, g->now, x[i]);
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
