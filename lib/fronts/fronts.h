/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The step with exact fronts, given which zones stick and slip and which way. With the m zones that
 * stick between the fronts c_j, X(z)^2 = product of (z - c_j), the change dt of traction is
 * known where it slips, and
 *     Omega + stretch = X (1/pi) int_slip [dt/X] ds/(s - z) + p/X,
 * p a polynomial of the degree 2m - 1: from the load and the stretch at infinity, and because two
 * zones that stick do not move apart. dt is bounded where the fronts are right: then p = 0.
 * Newton's method in the angles of the fronts takes the coefficients of 1/sqrt there to 0. */
#ifndef RW_FRONTS_H
#define RW_FRONTS_H

#include "fronts/problem.h"

enum { RW_MOST_STICK = 6, RW_MOST_FRONTS = 2 * RW_MOST_STICK, RW_MOST_SEGMENTS = 96 };

/* A part of a slip zone, and where its points begin in the row of all. */
typedef struct {
    double from, to;
    int label, panels;
    size_t first, count;
} rw_segment;

typedef struct {
    const rw_problem *problem;
    int zones, fronts, sticks, unknowns;
    int label[RW_MOST_ZONES];
    bool sticks_to_edge[2];   /* left, right: of a growing contact */
    double y[RW_MOST_FRONTS]; /* angles of the fronts, then D at edges that stick */
    rw_layers layer_of[3];    /* for D = 0, and more for each D */
    /* the quadrature: places, weights, X there, changes of traction; what is known of these, and
     * the layers' */
    int order, coarse, finest; /* of a panel; how many at a front, for what is had from integrals
                                  over all that slips, and for the traction next to it */
    double node[RW_TERMS], weight[RW_TERMS];
    rw_segment segment[RW_MOST_SEGMENTS];
    int segments;
    rw_layers layers; /* for which the changes hold */
    size_t count, capacity;
    double *x, *step, *X, *change, *known, *layer;
    int budget; /* residuals that may still be computed */
} rw_fronts;

/* What sticks. */
typedef struct {
    int count;
    double end[RW_MOST_FRONTS];
    double middle, half; /* of the contact */
} rw_stuck;

rw_stuck rw_stuck_of(const rw_fronts *fronts, const rw_zones *zones);

/* X outside of what sticks, and its size inside, over half^count. */
double rw_X_at(const rw_stuck *stuck, double x);

/* The quadrature for these zones, with so many panels at the fronts. */
bool rw_fronts_collect(rw_fronts *fronts, const rw_zones *zones, const rw_layers *layers,
                       int panels);

/* Before another problem. */
void rw_fronts_forget(rw_fronts *fronts);

/* p, and the fronts in the unit of the half-width, for what is collected. */
bool rw_fronts_polynomial(const rw_fronts *fronts, const rw_stuck *stuck, double front[],
                          double p[]);

/* The coefficients of 1/sqrt there. */
void rw_fronts_singular(const rw_stuck *stuck, const double front[], const double p[], double K[]);

/* The coefficients of 1/sqrt of dt, over sqrt(half), at the fronts and then at edges that stick. */
bool rw_fronts_residual(rw_fronts *fronts, double residual[]);

/* For zones that alternate between stick and slip. false where memory is short. */
bool rw_fronts_create(rw_fronts *fronts, double tolerance);
void rw_fronts_destroy(rw_fronts *fronts);

/* Takes over the zones, and D at the edges at first, NaN where it is not known; false where they
 * are no pattern of such a problem. */
bool rw_fronts_begin(rw_fronts *fronts, const rw_problem *problem, const rw_zones *zones,
                     const double ratio[2]);

/* To the fronts where dt is bounded, from y. false where that does not succeed. */
bool rw_fronts_newton(rw_fronts *fronts, double residual);

/* Front by front, before Newton: into the zone that sticks where the traction would exceed friction
 * there, else back. */
bool rw_fronts_relax(rw_fronts *fronts);

/* The zones and layers that y stands for. */
rw_layers rw_fronts_zones(const rw_fronts *fronts, rw_zones *zones);

/* Prepares and gives the traction in the zones that stick. */
bool rw_fronts_prepare_stick(rw_fronts *fronts, const rw_zones *zones, const rw_layers *layers);
double rw_fronts_stick_traction(const rw_fronts *fronts, const rw_zones *zones, double x);

#endif
