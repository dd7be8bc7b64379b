/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The last cycle of a history of loads, and what it does to a place. */
#ifndef CLI_LAST_CYCLE_H
#define CLI_LAST_CYCLE_H

#include "criteria.h"
#include "history/contact_history.h"
#include "model/doubts.h"

/* Of one place; NAN where there is none. */
typedef struct {
    double value[COLUMN_COUNT];
} measures;

typedef struct {
    const contact_case *setup;
    criteria asked;
    rwedge_contact *before;    /* the contact before the cycle */
    size_t loads;              /* of the cycle */
    double *P, *M, *Q, *sigma; /* so many each */
    double *edges;             /* of contact and stick zone, in no order */
    size_t edge_count;
    double left, right; /* the outermost; NAN where there is no contact */
    bool slip_known;    /* it has a closed form after every load */
    doubts doubts;      /* of all states after loads, those before the cycle included */
} last_cycle;

/* Goes through the history. */
void last_cycle_begin(const contact_history *history, const criteria *asked, last_cycle *cycle);

/* At n places. Returns the library's status, or RWEDGE_ENOMEM. Threads may call it at a time. */
int32_t last_cycle_measure(const last_cycle *cycle, size_t n, const double x[], const double y[],
                           measures at[]);

/* The criteria, with the range, of stresses after all loads at n places: of each load one place
 * after the other, sxx of all first, then syy and txy. */
int32_t last_cycle_criteria(const last_cycle *cycle, size_t n, const double *stress, measures at[]);

typedef struct {
    double x, value; /* the value is NAN where the measure is nowhere above 0 */
} worst_place;

/* Where a measure is largest on a line along x of n places, ascending, at which it is known. */
worst_place last_cycle_worst(const last_cycle *cycle, int column, size_t n, const double x[],
                             const double value[], double y);

#endif
