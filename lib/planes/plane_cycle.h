/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The loads of a cycle as the search for the worst plane needs them, and directions. On a plane
 * with the normal (cos(beta) sin(psi/2), cos(beta) cos(psi/2), sin(beta)) a load has the normal
 * stress
 *     n = szz - cos^2(beta) lift,   lift = szz - s - (d cos(psi) + t sin(psi)),
 * and the shear stresses (cos(beta) (t cos(psi) - d sin(psi)), sin(beta) cos(beta) lift). */
#ifndef RW_PLANE_CYCLE_H
#define RW_PLANE_CYCLE_H

#include "base/select.h"
#include "planes/plane_search.h"
#include "planes/smallest_ball.h"
#include "planes/worst_plane.h"

#include <math.h>

/* One component at the centre of a cell, its rates of change, and bounds of what they leave out. */
typedef struct {
    double x, y;
} rw_vector;

typedef struct {
    rw_vector at, by_chi, by_beta;
    double peak, peak_by_chi, peak_by_beta;
    double rest, peak_rest;
    double farthest, highest; /* in the cell: the square of the distance; the peak, with its rest */
} rw_local;

/* Stresses by the pole of the sphere of normals and two directions across it, side and base, of
 * which one is z: `base` along the last; the others' less that; the shear stress between the pole
 * and the side, and between the side and the base; the size of the part that varies around the
 * pole. */
typedef struct {
    double base, pole, side, shear, twist, ring;
} rw_tensor;

/* A load: sxx, syy, d, t, szz, szz - s, and the length of (d, t); the same less the middle of all
 * loads, on which no amplitude depends. The strain's amplitude is that of level - cos^2(beta)
 * lift. */
typedef struct {
    double xx, yy, d, t, z, lift, size;
    double deviation_d, deviation_t, deviation_lift, level, deviation_size;
    rw_tensor all, deviation; /* the base of the second is that of the strain's amplitude */
} rw_item;

struct rw_plane_cycle {
    size_t loads;
    rw_item *item;
    rw_local *local;
    rw_point *point;
    rw_wave *wave;
};

static inline double rw_severity_of(const rw_severity *v, double amplitude, double peak)
{
    if (v->is_sum)
        return amplitude + v->gain * peak;
    return rw_larger(0, v->offset + v->gain * peak) * amplitude;
}

/* What counts as rounding of the severity. */
double rw_plane_cycle_noise(const rw_plane_cycle *cycle, const rw_severity *severity);

/* Subtracts the middle of all loads from the components of amplitudes. */
void rw_plane_cycle_centre(rw_plane_cycle *cycle);

/* Chooses the pole of the sphere and sets `all` and `deviation`. From then on psi counts from
 * pole.psi: d and t are turned. */
typedef struct {
    rw_direction psi;
    bool is_z;
} rw_pole;
rw_pole rw_plane_cycle_turn(rw_plane_cycle *cycle);

#endif
