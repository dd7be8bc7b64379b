/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The step on a grid of Chebyshev's angles: which zones stick and slip, to the width of an angle.
 * It always has an answer. The search for the exact fronts (fronts.h) starts from its zones. Where
 * they cannot be found, the grid's answer is taken. */
#ifndef RW_GRID_H
#define RW_GRID_H

#include "fronts/problem.h"

enum { RW_MOST_ANGLES = 192 };

typedef struct {
    int n;                         /* 0: there is none yet */
    double middle, half;           /* of the places in contact before or after the step */
    double x[RW_MOST_ANGLES];      /* n places in the order of x */
    int label[RW_MOST_ANGLES];     /* RW_GONE: no longer in contact */
    double change[RW_MOST_ANGLES]; /* tau = dt half sin(angle), dt being the change of traction */
    double upper[RW_MOST_ANGLES], lower[RW_MOST_ANGLES]; /* its bounds */
    double strain[RW_MOST_ANGLES], move[RW_MOST_ANGLES];
    double *matrix, *factor; /* n^2 numbers each, in one block */
    int turns;               /* that the last problem took */
    double multiplier;       /* lambda, the rigid move of the places that stick */
} rw_grid;

enum { RW_GONE = 9 };

/* Makes a grid of n <= RW_MOST_ANGLES angles, a multiple of RW_TERMS. false where memory is short;
 * then there is nothing to destroy. */
bool rw_grid_init(rw_grid *grid, int n);
void rw_grid_destroy(rw_grid *grid);

/* Solves the step for the change of traction besides the layers. false where nothing sticks. */
bool rw_grid_solve(rw_grid *grid, const rw_problem *problem, const rw_layers *layers);

/* The zones of the contact by the labels of the places. */
void rw_grid_zones(const rw_grid *grid, const rw_problem *problem, rw_zones *zones);

/* Zones that slip from place to place alone, so that the traction meets friction at their fronts
 * and does not jump. */
void rw_grid_zones_met(const rw_grid *grid, const rw_problem *problem, rw_zones *zones);

/* dt and slip at any place, interpolated. */
double rw_grid_change(const rw_grid *grid, double x);
double rw_grid_slip(const rw_grid *grid, double x);

#endif
