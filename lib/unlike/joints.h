/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The slope of a profile inside a patch as parts whose integrals have closed forms: joints, where
 * the curvature jumps; kinks; and arcs so short that the difference of their two joints would
 * cancel. Places are in half-widths from the middle of the patch. J is the integral of 1/|X| from a
 * place to the right edge, X = (z + 1)^a (z - 1)^(1 - a), and W = (1 + t)^(1 - a) (1 - t)^a. */
#ifndef RW_JOINTS_H
#define RW_JOINTS_H

#include "unlike/sliding_patch.h"

typedef struct {
    double at;                  /* as far from x = 0 as the profile has it */
    double from_left, to_right; /* half-widths */
    double J, W;
    double power; /* ((to_right)/(from_left))^a */
} rw_place;

/* The slope changes by `step` there, and its derivative by `jump`, in half-widths. */
typedef struct {
    rw_place place;
    double jump, step;
} rw_joint;

enum { RW_ARC_NODES = 4 };

/* A slope that grows by `rise` from one place to another, evenly. */
typedef struct {
    rw_place end[2], node[RW_ARC_NODES];
    double weight[RW_ARC_NODES];
    double rise, middle, half; /* half the arc, in half-widths */
} rw_short_arc;

typedef struct {
    rw_patch patch;
    double middle, half;
    const rw_power_rule *rule, *other; /* of a, of 1 - a */
    double whole;                      /* J from the left edge: pi/cos(pi lambda) */
} rw_sliding_frame;

rw_sliding_frame rw_sliding_frame_of(rw_sliding_way slides, rw_patch patch);

/* Calls back for each part, from left to right. `left_slope`: the slope at the left edge. */
typedef struct {
    void (*joint)(const rw_joint *joint, void *context);
    void (*arc)(const rw_short_arc *arc, void *context);
    void *context;
} rw_visitor;

double rw_visit_joints(const rw_arcs *arcs, const rw_sliding_frame *frame, const rw_visitor *to);

#endif
