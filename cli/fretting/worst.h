/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The places where each measure of a cycle is largest, also between those that are looked at. */
#ifndef CLI_WORST_H
#define CLI_WORST_H

#include "last_cycle.h"

typedef struct {
    double x, y;
    measures found;
    bool is_shown; /* among the rows that are written */
} measured_place;

/* Lines along x, one after the other, each of so many places with one y and ascending x. */
typedef struct {
    measured_place *place;
    size_t count, line; /* line: places of each; 0 where they are no lines */
} measured;

typedef struct {
    double x, y, value; /* the value is NAN where the measure is nowhere above 0 */
} worst_place;

/* Of one measure: the largest of the places, and on its line of what is between them. */
worst_place worst_of(const last_cycle *of, const measured *all, int measure);

#endif
