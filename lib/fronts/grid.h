/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The step on a grid of Chebyshev's angles: where it sticks and slips, to an angle. It always has
 * an answer. The exact fronts begin from it (fronts.h); where they cannot be found, it stands. */
#ifndef RW_GRID_H
#define RW_GRID_H

#include "fronts/problem.h"

typedef struct {
    int n;
    double middle, half; /* of what is in contact before or after */
    double *x;           /* n places in the order of x; all that follows in one row */
    double *change;      /* of the traction, times sin(angle) half */
    double *upper, *lower, *strain, *move, *matrix, *factor, *right;
    double multiplier; /* the rigid move of what sticks */
    int *label;        /* RW_GONE: no longer in contact */
} rw_grid;

enum { RW_GONE = 9 };

bool rw_grid_create(rw_grid *grid, int n);
void rw_grid_destroy(rw_grid *grid);

/* Solves the step, with layers of it already taken. false where the sets do not settle, or nothing
 * sticks. */
bool rw_grid_solve(rw_grid *grid, const rw_problem *problem, const rw_layers *layers);

/* The zones of the contact that the labels make. false where they are too many. */
bool rw_grid_zones(const rw_grid *grid, const rw_problem *problem, rw_zones *zones);

/* The change of traction between the places. */
double rw_grid_change(const rw_grid *grid, double x);

#endif
