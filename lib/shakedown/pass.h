/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the material goes through while a sliding contact passes over it, by depth. */
#ifndef RW_PASS_H
#define RW_PASS_H

#include "formulas/arcs.h"
#include "planes/smallest_ball.h"
#include "unlike/sliding_patch.h"

/* A contact in full sliding. Stresses are in theta/A. */
typedef struct {
    rw_arcs arcs;
    rw_patch patch;
    double f;      /* negative where the half-plane is dragged towards -x */
    double weight; /* (1 - 2 nu)/sqrt(3) */
    rw_sliding_way slides;
} rw_pass;

/* The deviator ((syy-sxx)/2, weight (sxx+syy)/2, txy) at n places of a depth. Its length is
 * sqrt(J2). */
void rw_pass_stresses(const rw_pass *pass, double y, size_t n, const double x[], rw_point path[]);

/* The path at a depth, by a coordinate t that ends at infinity, where the path is closed: x is
 * middle + t up to |t| = turn; t ends at 2 turn. */
enum { RW_PASS_GRID = 768 };
typedef struct {
    const rw_pass *pass;
    double y, step, closest, middle, turn; /* step: see rw_pass_sample() */
    size_t n;
    double t[RW_PASS_GRID];
    rw_point path[RW_PASS_GRID];
} rw_pass_path;

/* The path without a sample. */
void rw_pass_path_at(rw_pass_path *path, const rw_pass *pass, double y);

/* Samples the path. The places are apart by `step` of the length over which the path varies, 0.05
 * to 0.5. */
void rw_pass_sample(rw_pass_path *path, const rw_pass *pass, double y, double step);

double rw_pass_place(const rw_pass_path *path, double t);

/* The distance, in t, over which the path varies there; 0 at a corner of the path. */
double rw_pass_length(const rw_pass_path *path, double t);

#endif
