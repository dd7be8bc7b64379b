/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The places at which a cycle is looked at, and its measures there. */
#ifndef CLI_SURFACE_H
#define CLI_SURFACE_H

#include "history/places.h"
#include "model/cycle/last_cycle.h"

typedef struct {
    double x, y;
    measures at;
    bool is_shown; /* among the rows that are written */
} measured_place;

/* Lines along x, one after the other, each of so many places with one y and ascending x. There is
 * room for a worst place of each measure. */
typedef struct {
    measured_place *place;
    size_t count, line; /* line: places of each; 0 where they are no lines */
} measured;

/* The places of --x or, where it is not given, from one side of the contact to the other, at each
 * of the depths; of --at or --points as they are. */
void surface_places(const arguments *line, char decimal_sign, const last_cycle *cycle,
                    measured *all);

/* The places by default, on the surface. False where there are none. */
bool surface_usual(const last_cycle *cycle, measured *all);

/* The measures of all places at a time. Returns the library's status, or RWEDGE_ENOMEM. */
int32_t surface_measure(const last_cycle *cycle, measured *all);

#endif
