/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Layers of a contact that grows and sticks up to an edge. What comes into contact has not slipped
 * since: the pressure of any profile, less that of the contact before, is such a traction. At each
 * moment its rate at a growing edge is D times that of friction. Layer 0 is friction itself, D = 1;
 * the slope of the others is ((x - x_0)/half)^(k+1), and their D changes as the contact grows. */
#ifndef RW_LAYERS_H
#define RW_LAYERS_H

#include "formulas/patch.h"

enum { RW_LAYERS = 4 };

typedef struct {
    int count;
    double weight[RW_LAYERS];
} rw_layers;

/* Where the powers' slope is 0, and where it is 1. */
typedef struct {
    double middle, half;
} rw_power_scale;

/* Of the power k + 1 on a patch, k > 0: the pressure over sqrt((x - left)(right - x)) times the
 * half-width of the patch; load and tilt. */
double rw_power_pressure(rw_power_scale scale, rw_patch patch, int k, double x);
rw_pressing rw_power_pressing(rw_power_scale scale, rw_patch patch, int k);

#endif
