/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The places along x at which a cycle is evaluated. The edges of contact and stick zone after each
 * load are among them, because stresses and slip have their peaks there. */
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

/* The places by default: across the contact and beyond. None where there is no contact. */
stops stops_usual(const last_cycle *cycle);

/* The given places, in any order, and the edges between them, which are not shown. */
stops stops_at(const last_cycle *cycle, size_t n, const double x[]);

#endif
