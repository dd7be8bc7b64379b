/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A convex profile as a list of arcs. Its slope is a weighted sum of slopes of wedges, each with
 * one arc for its rounding. So the load of a patch, its moment and its tilt are sums over the arcs,
 * and no term cancels another. In the unit theta, half of the angle between the outermost slopes,
 * the weights add up to 1. */
#ifndef RW_ARCS_H
#define RW_ARCS_H

#include "formulas/patch.h"

#include <stddef.h>

typedef struct {
    size_t count;
    bool is_symmetric;
    rw_arc *arcs; /* from left to right */
    double *weights;
} rw_pad;

/* A pad with room for `count` arcs. NULL where memory is short. */
rw_pad *rw_pad_create(size_t count);
rw_pad *rw_pad_copy(const rw_pad *pad, bool *is_whole); /* as other parts are: memory.h */
void rw_pad_destroy(rw_pad *pad);                       /* NULL is allowed */
void rw_pad_append(rw_pad *pad, rw_arc arc, double weight);

/* The arcs of a pad, or the wedge's one. */
typedef struct {
    size_t count;
    rw_arc rounding;
    const rw_pad *pad;
} rw_arcs;

static inline rw_arc rw_arc_at(const rw_arcs *arcs, size_t i)
{
    return arcs->pad ? arcs->pad->arcs[i] : arcs->rounding;
}

static inline double rw_arc_weight(const rw_arcs *arcs, size_t i)
{
    return arcs->pad ? arcs->pad->weights[i] : 1;
}

/* Load, moment and tilt of a patch, and how fast its edges move. */
rw_pressing rw_arcs_pressing(const rw_arcs *arcs, rw_patch patch);
rw_edge_rates rw_arcs_edge_rates(const rw_arcs *arcs, rw_patch patch);

/* How much the arcs outside of a patch raise the profile at a place x outside it, over theta. */
double rw_pad_rise(const rw_pad *pad, rw_patch patch, double x);

/* The height of a symmetric profile above its middle, x >= 0. */
double rw_arcs_height(const rw_arcs *arcs, double x);

/* The height of any profile, up to a constant. */
double rw_arcs_shape(const rw_arcs *arcs, double x);

/* Whether x is at a kink. */
bool rw_arcs_have_kink(const rw_arcs *arcs, double x);

/* The half-width of the centred patch of a symmetric pad under a load P > 0. */
double rw_pad_half_width(const rw_pad *pad, double P);

/* The patch of a load P > 0 and a moment M; of a load and a tilt |delta| < 1. Edges to 1e-14 of the
 * width. -M or -delta gives the mirror image to the last bit where the profile is symmetric. NaN
 * where the tilt is 1 to rounding. */
rw_patch rw_arcs_patch_of_moment(const rw_arcs *arcs, double P, double M);
rw_patch rw_arcs_patch_of_tilt(const rw_arcs *arcs, double P, double delta);

/* The same where a patch carries something else than rw_arcs_pressing(); `wanted` is M or delta. */
typedef rw_pressing (*rw_carried)(const void *context, rw_patch patch);
rw_patch rw_carried_patch(const rw_arcs *arcs, rw_carried carried, const void *context, double P,
                          double wanted, bool by_moment);

/* A straight way of load and moment from one patch to another, each under load: at which parts of
 * it the left edge and the right one turn, and go outwards from then on. 0 where an edge goes
 * outwards all the way, 1 where it goes inwards. It turns once, because the set of loads under
 * which an edge is inside of a given place is convex. */
typedef struct {
    double at[2];
} rw_turns;

rw_turns rw_arcs_turns(const rw_arcs *arcs, rw_patch from, rw_patch to);

/* The same of a straight way of load and tilt. The edge that turns goes outwards first, and inwards
 * from then on. */
rw_turns rw_arcs_turns_of_tilt(const rw_arcs *arcs, rw_patch from, rw_patch to);

/* The next part of the way, beyond `done`, to stop at: an edge turns there, or it is `next`. */
static inline double rw_stop_before(const rw_turns *turns, double done, double next)
{
    for (int i = 0; i < 2; i++)
        if (turns->at[i] > done && turns->at[i] < next)
            next = turns->at[i];
    return next;
}

#endif
