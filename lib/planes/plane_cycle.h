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

/* A plane by longitude and latitude, and what counts there. */
typedef struct {
    rw_direction chi, beta;
    double amplitude, peak;
} rw_plane;

/* A rectangle of longitude and latitude, its widths in rad; above the severity everywhere in it. */
enum { RW_CORNERS = 4 };
typedef struct {
    rw_plane corner[RW_CORNERS];
    double chi, beta, bound;
} rw_cell;

/* The search goes on with so many cells at most, and halves them. */
enum { RW_CELLS = 1024 };

/* A load: sxx, syy, d, t, szz, szz - s, and the length of (d, t); the same less the middle of all
 * loads, on which no amplitude depends. The strain's amplitude is that of level - cos^2(beta)
 * lift. */
typedef struct {
    double xx, yy, d, t, z, lift, size;
    double deviation_d, deviation_t, deviation_lift, level, deviation_size;
} rw_item;

struct rw_plane_cycle {
    size_t loads;
    rw_item *item;
    rw_point *point;
    rw_wave *wave;
    rw_cell *cell; /* room for 2 RW_CELLS */
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

#endif
