/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Points at which a potential is summed over its parts (sliding_fields.c), by vector instructions:
 * the bits are those of one point alone. */
#ifndef RW_SLIDING_POINTS_H
#define RW_SLIDING_POINTS_H

#include "unlike/moments.h"

typedef double rw_lanes[RW_BATCH];

/* Points, in half-widths: z, z + 1, z - 1; V, V (z - 1)/(z + 1); X, Y. */
typedef struct {
    const rw_sliding_frame *frame;
    rw_complex turn; /* e^(-i pi a) */
    int count;       /* with those that fill the last vector */
    bool is_single, has_near, has_far;
    rw_lanes x, z, height, from_left, from_right, size_left, size_right, angle_left, angle_right;
    rw_lanes V_re, V_im, other_re, other_im, X_re, X_im, Y_re, Y_im;
    rw_lanes all;                          /* 1: the same share of a part at all points */
    rw_lanes G_re, G_im, D_re, D_im, J, W; /* so far; J and W times jump */
} rw_sliding_points;

/* 1 <= n <= RW_BATCH points. */
void rw_sliding_points_begin(rw_sliding_points *points, const rw_sliding_frame *frame, int n,
                             const double x[], const double y[]);

/* A bend, whose weight is its jump, without X J and Y (W + (z - 2 a + 1) J); or a kink, whose
 * weight is its step; each point has its share of it. */
void rw_sliding_points_add(rw_sliding_points *points, const rw_place *place, double weight,
                           bool is_kink, const double share[]);

/* The rest of bends. */
void rw_sliding_points_add_edges(rw_sliding_points *points, double J, double W, double jump,
                                 const double share[]);

/* G, and D, which is y G'. */
void rw_sliding_points_finish(rw_sliding_points *points, const rw_sliding_sums *sums);

#endif
