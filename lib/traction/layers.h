/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Layers: the tractions of a contact that grows and sticks up to an edge. The places that come into
 * contact have not slipped. f times the pressure of any profile on the new patch, less that on the
 * old patch, is a traction without slip there. At each moment it grows at the edge D times as fast
 * as friction. The profile of layer k has the slope of the contact's own times u^k, u = (x -
 * middle)/half, so that D is about u^k. Layer 0 is friction itself. The transform of u^k p is u^k
 * times that of p, and a polynomial. So the layer has the pressure u^k p, and that of a profile
 * whose slope is the polynomial: the rest. */
#ifndef RW_LAYERS_H
#define RW_LAYERS_H

#include "formulas/patch.h"

enum { RW_LAYERS = 4 };

typedef struct {
    int count;
    double weight[RW_LAYERS];
} rw_layers;

typedef struct {
    double middle, half;
} rw_power_scale;

/* u^k. */
static inline double rw_power(rw_power_scale scale, int k, double x)
{
    const double u = (x - scale.middle) / scale.half;
    return k == 0 ? 1 : k == 1 ? u : k == 2 ? u * u : u * u * u;
}

/* A polynomial slope, in powers of the distance from the middle of a patch over its half-width. */
typedef struct {
    rw_patch patch;
    double c[RW_LAYERS];
} rw_layer_rest;

/* The rest of layer k on a patch with the tilt; moment[j] is the integral of u^j p, j < k. */
rw_layer_rest rw_layer_rest_of(rw_power_scale scale, rw_patch patch, double tilt,
                               const double moment[], int k);

/* Its pressure over the root of (x - left)(right - x), times the half-width of the patch; its load
 * and tilt. */
double rw_layer_rest_pressure(const rw_layer_rest *rest, double x);
rw_pressing rw_layer_rest_pressing(const rw_layer_rest *rest);

#endif
