/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is noted of a state: its shear, its patch, where it sticks, how the displacement goes on,
 * and what happens at the edges. */
#include "cycle/states.h"

#include "base/array.h"
#include "cycle/stuck.h"

#include <stdlib.h>

rw_patch rw_ring_of(rw_patch old, rw_patch now, int side)
{
    const bool is_new = isnan(old.left) || !(fmax(old.left, now.left) < fmin(old.right, now.right));
    const double middle = rw_patch_middle(now);
    return side == 0 ? (rw_patch){is_new ? middle : old.left, now.left}
                     : (rw_patch){is_new ? middle : old.right, now.right};
}

static const double ROUNDING = 1e-12; /* of an edge, in widths of the contact */

static rw_state *next_state(rwedge_cycle *cycle)
{
    rw_state *states = rw_grown(cycle->states, cycle->count, &cycle->capacity, 1, sizeof *states);
    if (!states)
        return NULL;
    cycle->states = states;
    return &states[cycle->count];
}

/* The slip of a place that has come into contact in a step, `left` of which was left then. Where
 * the bodies begin to slide in it, that is neglected. */
static double slip_of_new(const rwedge_contact *before, const rwedge_contact *after, double x,
                          double left)
{
    if (!rw_slides_as_known(after))
        return rw_slip_at(after, x);
    return rw_slides_as_known(before)
               ? left * (rw_slip_of_slide(after, x) - rw_slip_of_slide(before, x))
               : 0;
}

/* What happens at the edges in the step. */
static void note_edges(rw_state *next, const rwedge_contact *before, const rwedge_contact *after,
                       rw_patch old)
{
    for (int side = 0; side < 2; side++) {
        const rw_patch ring = rw_ring_of(old, next->patch, side);
        const bool grows = rw_patch_has(next->patch, ring.left) && ring.left != ring.right;
        const bool shrinks = rw_patch_has(old, ring.right) && ring.left != ring.right;
        for (int k = 0; k < RW_RING && grows; k++) {
            const double node = rw_ring_node(k), x = ring.left + (ring.right - ring.left) * node;
            next->ring[side][k] = slip_of_new(before, after, x, 1 - node);
        }
        if (shrinks && !grows)
            next->leave[side] = rw_slip_at(after, ring.right) - rw_slip_at(before, ring.right);
    }
}

/* The error of a computed slip, over the tolerance, the mean pressure and the compliance. */
static const double SLIP_NOISE = 0.5;

/* Notes where a computed state sticks. */
static bool note_sticks(rw_state *next, const rwedge_contact *after)
{
    const rw_zones zones = rw_contact_zones(after);
    next->noise = SLIP_NOISE * after->tolerance * after->f * after->geometry.A * after->loads.P;
    next->sticks = malloc(RW_MOST_ZONES * sizeof *next->sticks);
    for (int i = 0; next->sticks && i < zones.count; i++)
        if (zones.zone[i].label == 0)
            next->sticks[next->stick_count++] = (rw_patch){zones.zone[i].left, zones.zone[i].right};
    return next->sticks != NULL;
}

int32_t rw_note_state(rwedge_cycle *cycle, const rwedge_contact *from, const rwedge_contact *to,
                      const rw_entry *lender)
{
    const rwedge_contact *before = from ? rw_contact_of_slip(from) : NULL,
                         *after = rw_contact_of_slip(to);
    const rw_entry *same = after == to ? lender : NULL;
    rw_state *next = next_state(cycle);
    if (!next || !rw_record_add(&cycle->on_the_way, after, same))
        return RWEDGE_ENOMEM;
    *next = (rw_state){.patch = rw_patch_of(after), .is_computed = after->phase == RW_COMPUTED};
    cycle->count++;
    if (next->is_computed && !note_sticks(next, after))
        return RWEDGE_ENOMEM;
    if (!isnan(next->patch.left))
        cycle->rounding = fmax(cycle->rounding, ROUNDING * (next->patch.right - next->patch.left));
    if (!before) {
        next->displacement = rw_first_displacement(after);
        return RWEDGE_OK;
    }
    next->stuck = rw_stuck_between(before, after);
    next->displacement = rw_next_displacement(next[-1].displacement, before, after);
    if (!isnan(next->patch.left))
        note_edges(next, before, after, rw_patch_of(before));
    return RWEDGE_OK;
}

int32_t rw_note_sliding(rwedge_cycle *cycle, const rwedge_contact *contact, double slid)
{
    const int32_t status = rw_note_state(cycle, contact, contact, NULL);
    if (status == RWEDGE_OK) {
        rw_state *last = &cycle->states[cycle->count - 1];
        last->displacement.shift -= slid;
        last->stuck = RW_NOWHERE;
    }
    return status;
}

void rw_note_stuck(rwedge_cycle *cycle, size_t first, rw_patch stuck)
{
    for (size_t i = first; i < cycle->count; i++) {
        rw_patch *own = &cycle->states[i].stuck;
        if (stuck.right - stuck.left > own->right - own->left && !cycle->states[i].is_computed)
            *own = stuck;
    }
}
