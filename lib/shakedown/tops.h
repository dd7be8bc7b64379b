/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The places of a path that are farthest from a centre. */
#ifndef RW_TOPS_H
#define RW_TOPS_H

#include "shakedown/pass.h"

/* A local maximum of the square of the distance. */
typedef struct {
    double t;
    rw_point point;
    double square;
} rw_top;

static inline double rw_square_from(const double centre[2], const rw_point *p)
{
    const double x = p->x[0] - centre[0], y = p->x[1] - centre[1];
    return x * x + y * y + p->x[2] * p->x[2];
}

/* Finds the tops that may exceed a given square, at most RW_TOPS, with squares to 1e-12. */
enum { RW_TOPS = 10 };
int rw_tops(const rw_pass_path *path, const double centre[2], double square, rw_top tops[]);

#endif
