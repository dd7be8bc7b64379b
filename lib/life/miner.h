/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Miner's sum of a block of loads on one plane, and upper bounds of it. */
#ifndef RW_MINER_H
#define RW_MINER_H

#include "life/life.h"
#include "life/rainflow.h"
#include "measures/planes.h"
#include "planes/plane_cycle.h"
#include "planes/plane_search.h"

/* A vector in a plane. */
typedef struct {
    double x, y;
} rw_vector;

/* across: the direction in the plane in which its shear is taken. */
typedef struct {
    rw_direction psi, beta, across;
} rw_sheared_plane;

typedef struct {
    rw_sheared_plane at;
    double damage, cycles;
} rw_plane_damage;

typedef struct {
    const rw_criterion *criterion;
    const rw_life_curve *curve;
    rw_life_table *table; /* of the curve */
    bool is_exact;        /* by the curve itself, where the worst plane is known */
    rw_severity severity;
    double unit; /* of its values */
    rw_plane_cycle *cycle;
    rw_vector *path;       /* the strain, or both components of the shear stress */
    double *along, *other; /* one component; the normal stress */
    rw_reversal *stack;
    rw_counted_cycle *counted;
    bool leaves_domain;
} rw_miner_sum;

/* The sum has its criterion and curve then. false where memory is short; destroyed in either
 * case. */
bool rw_miner_create(rw_miner_sum *miner, size_t loads);
void rw_miner_destroy(rw_miner_sum *miner);

/* Upper bounds of the amplitude and of the largest normal stress on a plane. */
typedef struct {
    double amplitude, peak;
} rw_plane_bound;

/* Goes through the loads on the plane. */
rw_plane_bound rw_miner_go_through(rw_miner_sum *miner, const rw_sheared_plane *plane);

/* An upper bound of the damage: as many cycles as possible, each as bad as possible. */
double rw_miner_most(rw_miner_sum *miner, rw_plane_bound bound);

/* Whether the damage by the component of the path in a direction may exceed this, by a bound that
 * is closer. */
bool rw_miner_may_exceed(rw_miner_sum *miner, rw_direction across, double peak, double damage);

/* The direction of the length of the path: from the load farthest from the first one to the load
 * farthest from that. */
rw_direction rw_miner_longest_way(const rw_miner_sum *miner);

/* The damage on the plane that has been gone through. */
rw_plane_damage rw_miner_count(rw_miner_sum *miner, const rw_sheared_plane *plane);

#endif
