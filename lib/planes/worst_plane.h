/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plane, of all planes, on which a cycle of stresses is worst. The normal of a plane is (x, y,
 * z) = (cos(beta) sin(angle), cos(beta) cos(angle), sin(beta)). On it each load has a normal
 * stress, which counts by its maximum over the loads, and a quantity of one or two components: the
 * normal strain, or the shear stress. That counts by its amplitude: the radius of the smallest
 * circle around its path, which for one component is half of its range. */
#ifndef RW_WORST_PLANE_H
#define RW_WORST_PLANE_H

#include <stdbool.h>
#include <stddef.h>

/* Stresses of one load; zz is the stress across the plane of x and y. */
typedef struct {
    double xx, yy, xy, zz;
} rw_plane_load;

/* The value that is to be the largest: amplitude (offset + gain peak), 0 where the factor is
 * negative; or the sum amplitude + gain peak. The peak is the largest normal stress. */
typedef struct {
    bool is_strain; /* the amplitude is that of the normal strain, the value gain times the product;
                       otherwise of the shear stress */
    bool is_sum;
    double offset, gain;
    double
        shift; /* on a plane with the normal stress n, n + shift s is E/(1+nu) times the strain */
} rw_severity;

typedef struct {
    double value, amplitude, peak;
    double angle, out_of_plane; /* -pi/2 < angle <= pi/2, 0 <= out_of_plane <= pi/2 */
} rw_worst_plane;

/* A cycle of loads, each set before the search; NULL where memory lacks. */
typedef struct rw_plane_cycle rw_plane_cycle;
rw_plane_cycle *rw_plane_cycle_create(size_t loads);
void rw_plane_cycle_destroy(rw_plane_cycle *cycle);
void rw_plane_cycle_set(rw_plane_cycle *cycle, size_t i, const rw_plane_load *load,
                        const rw_severity *severity);

/* Stresses are between -1 and 1. No plane exceeds the value by more than rounding; where a whole
 * curve of planes has the largest value, by more than 1e-9 of it. */
rw_worst_plane rw_worst_plane_of(rw_plane_cycle *cycle, const rw_severity *severity);

#endif
