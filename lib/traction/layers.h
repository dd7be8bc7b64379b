/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Layers: the tractions of a contact that grows and sticks up to an edge. The places that come into
 * contact have not slipped. f times the pressure of any profile on the new patch, less that on the
 * old patch, is a traction without slip there. At each moment it grows at the edge D times as fast
 * as friction. Layer 0 is friction itself, D = 1. The profile of layer k > 0 has the slope ((x -
 * middle)/half)^(k+1), and its D changes as the contact grows. */
#ifndef RW_LAYERS_H
#define RW_LAYERS_H

#include "formulas/patch.h"

enum { RW_LAYERS = 4 };

typedef struct {
    int count;
    double weight[RW_LAYERS];
} rw_layers;

/* The slope of layer k is 0 at the middle, and 1 at the distance half from it. */
typedef struct {
    double middle, half;
} rw_power_scale;

/* Layer k > 0 on a patch: its pressure over the root of (x - left)(right - x), times the half-width
 * of the patch; its load and tilt. */
double rw_power_pressure(rw_power_scale scale, rw_patch patch, int k, double x);
rw_pressing rw_power_pressing(rw_power_scale scale, rw_patch patch, int k);

#endif
