/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A crack in a cycle of loads: its place and angle, for any length. */
#ifndef RW_CYCLE_CRACK_H
#define RW_CYCLE_CRACK_H

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
} rw_crack;

/* rw_crack_destroy() frees it, after an error too. RWEDGE_ENOMEM, RWEDGE_ENOCONV. */
int32_t rw_crack_create(const rwedge_cycle *cycle, double x, double angle, rw_crack *crack);
void rw_crack_destroy(rw_crack *crack);

size_t rw_crack_loads(const rw_crack *crack);

/* The lengths of which K is asked in one call, to the best. */
enum { RW_CRACK_LENGTHS = 16 };

/* K of at most RW_CRACK_LENGTHS cracks after each load: load i, length j at [i stride + j]; overlap
 * may be NULL. */
int32_t rw_crack_intensities(const rw_crack *crack, size_t n, const double length[], size_t stride,
                             double K_I[], double K_II[], double overlap[]);

#endif
