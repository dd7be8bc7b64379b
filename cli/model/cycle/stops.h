/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which places along x a cycle is looked at: the edges of contact and stick zone after each load
 * are among them, as it is there that stresses and slip have their tops. */
#ifndef CLI_STOPS_H
#define CLI_STOPS_H

#include "last_cycle.h"

typedef struct {
    double x;
    bool is_shown;
} stop;

typedef struct {
    stop *stop; /* ascending; freed by free() */
    size_t count;
} stops;

/* By default: across the contact and beyond. None where there is no contact. */
stops stops_usual(const last_cycle *cycle);

/* At places that are given, in any order; the edges between them are not shown. */
stops stops_at(const last_cycle *cycle, size_t n, const double x[]);

#endif
