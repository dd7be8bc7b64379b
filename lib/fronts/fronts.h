/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The step with exact fronts (ends of slip zones), given which zones stick and slip and which way.
 * Let c_j be the ends of the m zones that stick, and X(z)^2 = product of (z - c_j). The change dt
 * of traction is known where it slips, and
 *     Omega + stretch = X (1/pi) int_slip [dt/X] ds/(s - z) + p/X,
 * p is a polynomial of the degree 2m - 1. It follows from the load and the stretch at infinity, and
 * because two zones that stick do not move apart. Where the fronts are right dt is bounded, so p
 * vanishes. For other fronts dt is like K/sqrt(distance) next to them. Newton's method in the
 * angles of the fronts brings all K to 0: they are the residual. */
#ifndef RW_FRONTS_H
#define RW_FRONTS_H

#include "fronts/problem.h"

enum { RW_MOST_STICK = 6, RW_MOST_FRONTS = 2 * RW_MOST_STICK };

/* Slip zones and places that the contact has left, cut at kinks, bends and the edges before. */
enum { RW_MOST_SEGMENTS = RW_MOST_STICK + 1 + 2 + RW_MOST_KINKS + RW_MOST_BENDS + 2 };

/* Panels of half a segment towards a front that another one is near: at most. */
enum { RW_MOST_PANELS = 12 };

/* Points are taken by eights; a panel has 8 or 16. */
enum { RW_FRONT_LANES = 8 };

/* A part of a slip zone, and where its points begin in the row of all. */
typedef struct {
    double from, to;
    int label, panels[2]; /* towards its left, right end */
    size_t first, count;
} rw_segment;

typedef struct {
    const rw_problem *problem;
    int zones, fronts, sticks, unknowns;
    int label[RW_MOST_ZONES];
    bool sticks_to_edge[2];   /* whether a growing contact sticks up to its left, right edge */
    double y[RW_MOST_FRONTS]; /* the unknowns: angles of the fronts, then D at edges that stick */
    rw_layers layer_of[3];    /* for D = 0, and what each D adds */
    /* the quadrature: places x, weights step, X and dt (change) there; dt is `known` less the
     * layers, `layer` the change by each layer */
    int order;          /* points of a panel */
    int coarse, finest; /* panels at a front: for integrals over all slip zones, and for the
                           traction next to the front */
    double node[RW_TERMS], weight[RW_TERMS]; /* for 0 to 1 */
    double integral[RW_TERMS + 1][RW_TERMS]; /* weights from 0 to each node, and to 1 */
    rw_segment segment[RW_MOST_SEGMENTS];
    int segments;
    rw_layers layers;       /* for which the changes hold */
    size_t count, capacity; /* of the points; there is room for as many as were needed so far */
    double *x, *step, *X, *change, *known,
        *layer[RW_LAYERS]; /* in one block, which begins with x */
    bool is_short;         /* memory was short: points are missing */
    int budget;            /* residuals that may still be computed */
} rw_fronts;

/* The zones that stick, by their ends, and the polynomial p by its coefficients. */
typedef struct {
    int count;
    double end[RW_MOST_FRONTS];
    double middle, half;                             /* of the contact: its middle and half-width */
    double front[RW_MOST_FRONTS], p[RW_MOST_FRONTS]; /* the ends, from the middle, over the half */
} rw_stuck;

rw_stuck rw_stuck_of(const rw_fronts *fronts, const rw_zones *zones);

/* X outside of what sticks, over half^count; inside, X over i: at n places, at one. */
void rw_X_values(const rw_stuck *stuck, size_t n, const double x[], double X[]);
double rw_X_at(const rw_stuck *stuck, double x);

/* Sets up the quadrature over all places where dt is known, with this number of panels at a
 * front. */
void rw_fronts_collect(rw_fronts *fronts, const rw_zones *zones, const rw_layers *layers,
                       int panels);

/* All places between two others where dt is not smooth, in order, and these two. */
enum { RW_MOST_BREAKS = RW_MOST_KINKS + RW_MOST_BENDS + 6 };
int rw_breaks_between(const rw_problem *p, double from, double to, double at[]);

/* Forgets the quadrature of the last problem. */
void rw_fronts_forget(rw_fronts *fronts);

/* Sets the polynomial p, from the quadrature. */
bool rw_fronts_polynomial(const rw_fronts *fronts, rw_stuck *stuck);

/* p at a place, from the middle over the half-width. */
double rw_polynomial_at(const rw_stuck *stuck, double place);

/* The coefficients K of 1/sqrt(distance) at the fronts. */
void rw_fronts_singular(const rw_stuck *stuck, double K[]);

/* The residual: K over sqrt(half), at the fronts and then at edges of the contact that stick. */
bool rw_fronts_residual(rw_fronts *fronts, double residual[]);

/* The zones may be any that alternate between stick and slip, the problems any of this
 * tolerance. */
void rw_fronts_init(rw_fronts *fronts, double tolerance);
void rw_fronts_destroy(rw_fronts *fronts);

/* Starts from these zones, with D at the edges that stick at the beginning of the step, NaN where
 * it is not known. false where such zones are not possible in this problem. */
bool rw_fronts_begin(rw_fronts *fronts, const rw_problem *problem, const rw_zones *zones,
                     const double ratio[2]);

/* Newton's method from y, until the residual is below the given one. false where it does not
 * succeed. */
bool rw_fronts_newton(rw_fronts *fronts, double residual);

/* Moves front by front to where its own K is 0, as a start for Newton's method: into the zone that
 * sticks where the traction would exceed friction there, else back. false where a zone vanishes. */
bool rw_fronts_relax(rw_fronts *fronts);

/* The zones and layers for the present y. */
rw_layers rw_fronts_zones(const rw_fronts *fronts, rw_zones *zones);

/* Prepares the following functions, after which the changes at the points are no longer dt. */
void rw_fronts_prepare(rw_fronts *fronts);

/* (1/pi) int_slip [dt/X] ds/(s - x), where dt is 0 at x. */
double rw_fronts_transform(const rw_fronts *fronts, double x);

/* At n <= RW_TERMS places: what that sum over points lacks of the integral where x sticks next to a
 * front: the points there are apart by more than x is from the front. */
void rw_fronts_lack(const rw_fronts *fronts, const rw_stuck *stuck, size_t n, const double x[],
                    double lack[]);

/* The traction after the step where one zone sticks, and w' less the part of the layers where it
 * slips, for p = 0: at n <= RW_TERMS places of it. */
void rw_fronts_stick_traction(const rw_fronts *fronts, const rw_stuck *stuck, size_t n,
                              const double x[], double t[]);
void rw_fronts_slope(const rw_fronts *fronts, const rw_stuck *stuck, int label, size_t n,
                     const double x[], double slope[]);

#endif
