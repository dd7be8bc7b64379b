/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerical/passing.h"

#include "base/root.h"
#include "base/tuned.h"

/* NEAREST: how exactly the moment is found, over the step. BEFORE: the edge stops short of the kink
 * by this part of its path, because from the kink on it moves so little at first that moments
 * cannot be told apart. */
static const double NEAREST = 1e-10, BEFORE = 1e-8;

/* An edge on its way to a place, in a step. */
typedef struct {
    const rw_frame *frame;
    rw_scaled_loads from, to;
    int side;
    double place;
} edge_path;

static double beyond_place(double part, const void *context)
{
    const edge_path *path = context;
    const rw_patch contact =
        rw_patch_of_loads(path->frame, rw_part_of_line(path->from, path->to, part));
    return (path->side ? 1 : -1) * (rw_patch_edge(contact, path->side) - path->place);
}

/* Whether an edge slips the same way all the time: then its traction is that of friction. */
static bool slips_on(const rw_zones *before, const rw_zones *after, int side)
{
    const int old = rw_zones_at_edge(before, side).label, now = rw_zones_at_edge(after, side).label;
    return now != 0 && old == now;
}

/* The first part at which an edge comes to a kink; 1 where there is none, or one of the ends of the
 * step is near. */
static double first_kink(edge_path *path, double old, double new)
{
    double first = 1, bend[RW_MOST_BENDS];
    const int n = rw_bends_between(path->frame, fmin(old, new), fmax(old, new), bend);
    for (int i = 0; i < n; i++) {
        path->place = bend[i] - BEFORE * (bend[i] - old);
        if (!rw_arcs_have_kink(&path->frame->arcs, bend[i]))
            continue;
        const double part = rw_root(beyond_place, path, 0, 1, NEAREST);
        if (isgreater(part, RW_ONSET_NEAREST) && part < 1 - RW_ONSET_NEAREST)
            first = fmin(first, part);
    }
    return first;
}

double rw_passing_of_kink(const rw_work *work, const rw_numerical_state *from,
                          const rw_numerical_state *there)
{
    double first = 1;
    for (int side = 0; side < 2; side++) {
        edge_path path = {.frame = work->frame, .from = from->at, .to = there->at, .side = side};
        if (rw_edge_grows(from, there, side) &&
            !slips_on(&from->shear.zones, &there->shear.zones, side))
            first = fmin(first, first_kink(&path, rw_patch_edge(from->contact, side),
                                           rw_patch_edge(there->contact, side)));
    }
    return first;
}
