/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A convex profile as a list of arcs. The slope is made of those of wedges that have an arc for
 * their rounding, so what a patch carries is the sum of what it carries of each, and no term
 * cancels another. In theta, half of the angle between the outermost slopes, the weights of the
 * arcs add up to 1. */
#ifndef RW_PAD_H
#define RW_PAD_H

#include "formulas/patch.h"

#include <stddef.h>

typedef struct {
    size_t count;
    bool is_symmetric;
    rw_arc *arcs; /* from left to right */
    double *weights;
} rw_pad;

rw_pressing rw_pad_pressing(const rw_pad *pad, rw_patch patch);
rw_edge_rates rw_pad_edge_rates(const rw_pad *pad, rw_patch patch);

/* What the arcs outside of a patch lift the profile at x outside, over theta. */
double rw_pad_rise(const rw_pad *pad, rw_patch patch, double x);

/* The height of a symmetric profile above its middle, x >= 0. */
double rw_pad_height(const rw_pad *pad, double x);

/* Whether x is at a kink. */
bool rw_pad_is_kink(const rw_pad *pad, double x);

/* Half of the patch of a load P > 0 in the middle of a symmetric pad. */
double rw_pad_half_width(const rw_pad *pad, double P);

/* As rw_patch_of_moment() and rw_patch_of_tilt(); P may be 0 in the middle of a symmetric pad. */
rw_patch rw_pad_patch_of_moment(const rw_pad *pad, double P, double M);
rw_patch rw_pad_patch_of_tilt(const rw_pad *pad, double P, double tilt);

#endif
