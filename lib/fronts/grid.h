/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The step on a grid of Chebyshev's angles: which zones stick and slip, to the width of an angle.
 * It always has an answer. The search for the exact fronts (fronts.h) starts from its zones. Where
 * they cannot be found, the grid's answer is taken. */
#ifndef RW_GRID_H
#define RW_GRID_H

#include "fronts/problem.h"

typedef struct {
    int n;
    double middle, half; /* of the places in contact before or after the step */
    double *x;           /* n places in the order of x; one block holds all arrays of doubles */
    double *change;      /* tau = dt half sin(angle), dt being the change of traction */
    double *upper, *lower, *strain, *move, *matrix, *factor, *right;
    int turns;         /* that the last problem took */
    double multiplier; /* lambda, the rigid move of the places that stick */
    int *label;        /* RW_GONE: no longer in contact */
} rw_grid;

enum { RW_GONE = 9 };

/* n is a multiple of RW_TERMS. */
bool rw_grid_create(rw_grid *grid, int n);
void rw_grid_destroy(rw_grid *grid);

/* Solves the step for the change of traction besides the layers. false where nothing sticks. */
bool rw_grid_solve(rw_grid *grid, const rw_problem *problem, const rw_layers *layers);

/* The zones of the contact by the labels of the places. */
void rw_grid_zones(const rw_grid *grid, const rw_problem *problem, rw_zones *zones);

/* dt and slip at any place, interpolated. */
double rw_grid_change(const rw_grid *grid, double x);
double rw_grid_slip(const rw_grid *grid, double x);

#endif
