/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The states that a contact goes through in a cycle of loads, and what happens to a place. */
#ifndef RW_CYCLE_H
#define RW_CYCLE_H

#include "contact/contact.h"

typedef struct {
    rwedge_contact *contact;
    rw_loads loads;   /* that led here */
    rw_patch patch;   /* of the contact; NaN when separated */
    rw_patch stuck;   /* where nothing has slipped since the state before; none if computed */
    bool is_load;     /* after a load; else on the way to one, where P or M changes */
    bool is_computed; /* this state or the one before it */
} rw_state;

/* The states of a cycle. The first one is that before it. */
typedef struct {
    rw_state *states;
    size_t count, loads;
    double rounding; /* of an edge */
    bool is_counted; /* slip counts from its first state, where it was not known */
} rw_states;

/* Stresses are of the states after the loads alone, slip is of those on the way too: a load that is
 * cut into parts ends in other bits. */
struct rwedge_cycle {
    rw_states at_loads, on_the_way;
    int32_t slip_status; /* RWEDGE_EPATH where the slip of a state has no closed form */
};

/* What friction does at a place of the surface. All 0 where there is no contact in the cycle. */
typedef struct {
    double slip_range, shear, energy; /* shear: the largest magnitude of q */
} rw_slip_measures;

rw_slip_measures rw_slip_measures_at(const rw_states *all, double x);

/* The stresses after each load at n places, 3 loads n numbers: those of a load one after the other,
 * sxx of all loads first, then syy and txy. */
int32_t rw_cycle_stresses(const rwedge_cycle *cycle, size_t n, const double x[], const double y[],
                          double stress[]);

/* The largest sxx after any load at the place i, from the stresses at n places. */
double rw_largest_stress(const rwedge_cycle *cycle, size_t n, const double stress[], size_t i);

#endif
