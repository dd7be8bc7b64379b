/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A crack in a cycle of loads: its place and angle, for any length. */
#ifndef RW_CYCLE_CRACK_H
#define RW_CYCLE_CRACK_H

#include "crack/faces.h"
#include "cycle/states.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct {
    const rwedge_cycle *cycle;
    double x, angle;
    size_t m;      /* places */
    double *place; /* m of them, then the rows of weights: K_I, K_II, openings */
    double *row;
    double *column; /* the rows again, as sums are made of them (cycle_crack.c) */
    size_t *used;
    size_t openings; /* their number; each stands for a share of the line */
    double *share;
    bool presses; /* its faces press on each other; else they pass through each other */
    rw_faces faces;
} rw_crack;

/* rw_crack_destroy() frees it, after an error too. RWEDGE_ENOMEM, RWEDGE_ENOCONV. */
int32_t rw_crack_create(const rwedge_cycle *cycle, double x, double angle, bool presses,
                        rw_crack *crack);
void rw_crack_destroy(rw_crack *crack);

/* Whether each of n numbers can be the length of a crack. */
bool rw_are_crack_lengths(size_t n, const double length[]);

size_t rw_crack_loads(const rw_crack *crack);

/* The lengths of which K is asked in one call, to the best. */
enum { RW_CRACK_LENGTHS = 16 };

/* K after each load: that of load i, length j at [i stride + j]. Both of the last may be NULL. */
typedef struct {
    size_t stride;
    double *I, *II;
    double *share;   /* of the line where faces overlap, or touch */
    double *passing; /* K_II where K_I becomes 0, or more, before the next load; else NaN */
} rw_crack_K;

/* K of at most RW_CRACK_LENGTHS cracks. Passings are known where faces press. */
int32_t rw_crack_intensities(rw_crack *crack, size_t n, const double length[], const rw_crack_K *K);

#endif
