/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "computed/growing_contact.h"

#include "computed/growing_step.h"

#include <rwedge.h>

/* The part of the line under which the bodies are taken to touch. */
static const double TOUCHES = 0x1p-20;

/* How far the cells reach beyond the contact of similar bodies, over its half-width: it swings by
 * 1.2 |B Q|/P at most. */
static double margin(const rw_frame *frame, rw_scaled_loads to)
{
    return 0.2 + 1.2 * fabs(frame->B * to.shear / to.P);
}

/* The height of a profile, over theta. */
static double height(const rw_arcs *arcs, double x)
{
    double sum = 0;
    for (size_t i = 0; i < arcs->count; i++) {
        const rw_arc arc = rw_arc_at(arcs, i);
        const double middle = arc.left / 2 + arc.right / 2;
        sum += rw_arc_weight(arcs, i) * rw_wedge_height(rw_arc_half_length(arc), fabs(x - middle));
    }
    return sum;
}

/* The gap before the bodies touch. */
static void set_gap(rw_growing *w, double tilt)
{
    const rw_growth *g = w->g;
    double least = HUGE_VAL;
    for (size_t i = 0; i < g->count; i++) {
        w->gap[i] = height(&w->frame->arcs, g->x[i]) - tilt * g->x[i];
        least = fmin(least, w->gap[i]);
    }
    for (size_t i = 0; i < g->count; i++)
        w->gap[i] -= least;
}

/* The cells of a patch that is the first to touch, at least so many. false where they are not
 * inside of all. */
static bool touch(rw_growing *w, rw_patch touching)
{
    enum { LEAST = 4 };
    rw_growth *g = w->g;
    while (g->from < g->count && g->x[g->from] < touching.left)
        g->from++;
    g->to = g->from;
    while (g->to < g->count && g->x[g->to] < touching.right)
        g->to++;
    while (g->to - g->from < LEAST && g->from > 0 && g->to < g->count) {
        const double left = w->gap[g->from - 1], right = w->gap[g->to];
        g->from -= left <= right;
        g->to += right <= left;
    }
    return g->to - g->from >= LEAST;
}

static bool is_inside(const rw_growth *g)
{
    return g->from > 0 && g->to < g->count;
}

/* Cells that closed in the last step carry nothing yet. */
static void drop_empty(rw_growth *g)
{
    while (g->to > g->from && g->N[g->to - 1] == 0)
        g->to--;
    while (g->from < g->to && g->N[g->from] == 0)
        g->from++;
}

/* false where it does not reach the load, or a cell is pulled. */
static bool grow(rw_growing *w)
{
    rw_growth *g = w->g;
    while (!rw_growing_is_done(w, w->load))
        if (!is_inside(g) || !rw_growing_step(w) || !(w->d_load > 0))
            return false;
    drop_empty(g);
    for (size_t i = g->from; i < g->to; i++)
        if (!(g->N[i] > 0))
            return false;
    return true;
}

int32_t rw_growth_create(rw_growth *growth, const rw_frame *frame, rw_scaled_loads from,
                         rw_scaled_loads to, size_t cells)
{
    const rw_patch touching = rw_patch_of_loads(frame, rw_part_of_line(from, to, TOUCHES)),
                   last = rw_patch_of_loads(frame, to);
    if (isnan(touching.left) || isnan(last.left))
        return RWEDGE_ENOCONV;
    const double more = margin(frame, to), beside = more * rw_patch_half_width(last);
    const rw_patch all = {fmin(last.left, touching.left) - beside,
                          fmax(last.right, touching.right) + beside};
    const size_t count = 2 * (size_t)((double)cells / 2 * (1 + more));
    if (!rw_growth_cells(growth, frame->f, count, rw_patch_middle(touching), all))
        return RWEDGE_ENOMEM;
    rw_growing w = {
        .g = growth,
        .frame = frame,
        .rates = {1, to.turn / to.P, to.shear / to.P, (to.stretch - from.stretch) / to.P},
        .P = to.P};
    int32_t status = RWEDGE_ENOMEM;
    if (rw_growing_create(&w)) {
        set_gap(&w, frame->is_held ? to.turn : rw_arcs_pressing(&frame->arcs, touching).tilt);
        status = touch(&w, touching) && grow(&w) ? RWEDGE_OK : RWEDGE_ENOCONV;
    }
    rw_growing_destroy(&w);
    if (status != RWEDGE_OK)
        rw_growth_destroy(growth);
    return status;
}
