/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "unlike/joints.h"

#include "base/domain.h"
#include "base/root.h"

/* An arc is short where its half is this part of its distance from the edges, or less. */
static const double SHORT = 1.0 / 32;

rw_sliding_frame rw_sliding_frame_of(rw_sliding_way slides, rw_patch patch)
{
    const int first = slides.way > 0 ? 0 : 1;
    const rw_power_rule *rule = &slides.unlike->rule[first];
    return (rw_sliding_frame){.patch = patch,
                              .middle = rw_patch_middle(patch),
                              .half = rw_patch_half_width(patch),
                              .rule = rule,
                              .other = &slides.unlike->rule[1 - first],
                              .whole = rule->whole};
}

/* J is known from the left edge on. */
static rw_place place_at(const rw_sliding_frame *f, double at)
{
    const double a = f->rule->a;
    rw_place p = {at, (at - f->patch.left) / f->half, (f->patch.right - at) / f->half, f->whole, 0,
                  0};
    if (!(p.from_left > 0))
        return p;
    const double ratio = p.to_right / p.from_left;
    p.power = pow(ratio, a);
    p.W = p.from_left * p.power;
    p.J = ratio <= 1 ? p.power * rw_power_integral_below(f->rule, -ratio)
                     : f->whole - p.power / ratio * rw_power_integral_below(f->other, -1 / ratio);
    return p;
}

static void visit_short(const rw_sliding_frame *f, const rw_visitor *to, rw_arc arc, double weight)
{
    double node[RW_ARC_NODES];
    rw_short_arc part = {.end = {place_at(f, arc.left), place_at(f, arc.right)},
                         .rise = 2 * weight,
                         .middle = arc.left / 2 + arc.right / 2,
                         .half = rw_arc_half_length(arc) / f->half};
    rw_gauss(RW_ARC_NODES, node, part.weight);
    for (int i = 0; i < RW_ARC_NODES; i++)
        part.node[i] = place_at(f, arc.left + (arc.right - arc.left) * node[i]);
    to->arc(&part, to->context);
}

typedef struct {
    const rw_sliding_frame *frame;
    const rw_visitor *to;
    bool has; /* a joint that waits for the next arc */
    double at, jump;
} row;

static void flush(row *r)
{
    if (!r->has || r->at >= r->frame->patch.right || r->jump == 0)
        return;
    const rw_joint joint = {place_at(r->frame, r->at), r->jump, 0};
    r->to->joint(&joint, r->to->context);
}

/* What lies left of the edge begins there. */
static void put(row *r, double at, double jump)
{
    at = fmax(at, r->frame->patch.left);
    if (r->has && r->at == at) {
        r->jump += jump;
        return;
    }
    flush(r);
    r->has = true;
    r->at = at;
    r->jump = jump;
}

static bool is_short(const rw_sliding_frame *f, rw_arc arc)
{
    const double room = fmin(arc.left - f->patch.left, f->patch.right - arc.right);
    return rw_arc_half_length(arc) < SHORT * room;
}

/* The slope of an arc at the left edge, over its weight. */
static double slope_at(rw_arc arc, double x)
{
    return x <= arc.left    ? -1
           : x >= arc.right ? 1
                            : (x - (arc.left / 2 + arc.right / 2)) / rw_arc_half_length(arc);
}

static void visit_kink(const rw_sliding_frame *f, const rw_visitor *to, double at, double weight)
{
    const rw_joint kink = {place_at(f, at), 0, 2 * weight};
    to->joint(&kink, to->context);
}

double rw_visit_joints(const rw_arcs *arcs, const rw_sliding_frame *f, const rw_visitor *to)
{
    row r = {.frame = f, .to = to};
    double left_slope = 0;
    for (size_t i = 0; i < arcs->count; i++) {
        const rw_arc arc = rw_arc_at(arcs, i);
        const double weight = rw_arc_weight(arcs, i);
        left_slope += weight * slope_at(arc, f->patch.left);
        if (!rw_arc_is_inside(arc, f->patch))
            continue;
        if (arc.left == arc.right)
            visit_kink(f, to, arc.left, weight);
        else if (is_short(f, arc))
            visit_short(f, to, arc, weight);
        else {
            const double jump = weight / (rw_arc_half_length(arc) / f->half);
            put(&r, arc.left, jump);
            if (arc.right < f->patch.right)
                put(&r, arc.right, -jump);
        }
    }
    flush(&r);
    return left_slope;
}
