/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The theory of critical distances: stresses below a place of the surface, at half of a length, or
 * their means over twice the length. */
#ifndef CLI_LENGTH_H
#define CLI_LENGTH_H

#include "model/cycle/last_cycle.h"

typedef struct {
    double length, angle; /* NAN for none; from the surface's normal towards +x, deg */
    bool is_line;         /* mean over twice the length; else the point at half of it */
} distance;

/* The criteria there, of the stresses of each load. Returns the library's status, or
 * RWEDGE_ENOCONV where the means do not settle to 1e-10 of the stresses. */
int32_t length_measure(const last_cycle *cycle, const distance *below, double x, measures *at);

#endif
