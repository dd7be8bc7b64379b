/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The last cycle of a history of loads, and what it does to a place. */
#ifndef CLI_LAST_CYCLE_H
#define CLI_LAST_CYCLE_H

#include "criteria.h"

/* The measures at one place; NAN where a measure has no value. */
typedef struct {
    double value[COLUMN_COUNT];
} measures;

typedef struct {
    const contact_case *setup;
    criteria asked;
    rwedge_contact *before;    /* the contact before the cycle */
    size_t loads;              /* of the cycle */
    double *P, *M, *Q, *sigma; /* `loads` numbers each */
    double *edges;             /* of contact and stick zone, in no order */
    size_t edge_count;
    double left, right; /* the outermost; NAN where there is no contact */
    bool slip_known;    /* it has a closed form after every load */
} last_cycle;

/* Begins a cycle: copies the contact before it, and makes room for so many loads. */
void last_cycle_begin(const contact_case *setup, const criteria *asked,
                      const rwedge_contact *before, size_t room, last_cycle *cycle);

/* Adds a load, which the contact is under. */
void last_cycle_add(const rwedge_contact *contact, last_cycle *cycle);

/* To be called after the last load, before the measures. */
void last_cycle_end(last_cycle *cycle);

void last_cycle_free(last_cycle *cycle);

/* The measures at n places. Returns the library's status, or RWEDGE_ENOMEM. Several threads may
 * call it at a time. */
int32_t last_cycle_measure(const last_cycle *cycle, size_t n, const double x[], const double y[],
                           measures at[]);

/* The criteria, with the range, of stresses after all loads at n places: of each load one place
 * after the other, sxx of all first, then syy and txy. */
int32_t last_cycle_criteria(const last_cycle *cycle, size_t n, const double *stress, measures at[]);

/* Where a measure is largest on a line along x of n ascending places. `value` has the measure at
 * the places, 0 where it is not known. Returns the library's status. */
int32_t last_cycle_worst(const last_cycle *cycle, int column, size_t n, const double x[],
                         const double value[], double y, double *worst_x, double *worst_value);

#endif
