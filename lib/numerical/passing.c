/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerical/passing.h"

#include "base/root.h"
#include "base/tuned.h"

/* The moment is found to this part of the step. The edge is before the kink then, by this part of
 * its way: from the kink on it moves so little at first that moments cannot be told apart. */
static const double NEAREST = 1e-10, BEFORE = 1e-8;

/* An edge on its way to a place, in a step. */
typedef struct {
    const rw_frame *frame;
    rw_scaled_loads from, to;
    int side;
    double place;
} way;

static double edge_of(rw_patch contact, int side)
{
    return side ? contact.right : contact.left;
}

static double beyond_place(double part, const void *context)
{
    const way *w = context;
    const rw_patch contact = rw_patch_of_loads(w->frame, rw_part_of_line(w->from, w->to, part));
    return (w->side ? 1 : -1) * (edge_of(contact, w->side) - w->place);
}

/* Whether an edge slips the same way all the time: then its traction is that of friction. */
static bool slips_on(const rw_zones *before, const rw_zones *after, int side)
{
    const int old = before->zone[side ? before->count - 1 : 0].label,
              now = after->zone[side ? after->count - 1 : 0].label;
    return now != 0 && old == now;
}

static bool grows(const rw_numerical_state *from, const rw_numerical_state *there, int side)
{
    return side ? there->contact.right > from->contact.right
                : there->contact.left < from->contact.left;
}

/* The first part at which an edge comes to a kink; 1 where there is none, or one of the ends of the
 * step is near. */
static double first_kink(way *w, double old, double new)
{
    double first = 1, bend[RW_MOST_BENDS];
    const int n = rw_bends_between(w->frame, fmin(old, new), fmax(old, new), bend);
    for (int i = 0; i < n; i++) {
        w->place = bend[i] - BEFORE * (bend[i] - old);
        if (!rw_arcs_have_kink(&w->frame->arcs, bend[i]))
            continue;
        const double part = rw_root(beyond_place, w, 0, 1, NEAREST);
        if (part > RW_ONSET_NEAREST && part < 1 - RW_ONSET_NEAREST)
            first = fmin(first, part);
    }
    return first;
}

double rw_passing_of_kink(const rw_work *work, const rw_numerical_state *from,
                          const rw_numerical_state *there)
{
    double first = 1;
    for (int side = 0; side < 2; side++) {
        way w = {.frame = work->frame, .from = from->at, .to = there->at, .side = side};
        if (grows(from, there, side) && !slips_on(&from->shear.zones, &there->shear.zones, side))
            first = fmin(
                first, first_kink(&w, edge_of(from->contact, side), edge_of(there->contact, side)));
    }
    return first;
}
