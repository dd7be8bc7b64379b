/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The states that a contact goes through in a cycle of loads, and what happens to a place. */
#ifndef RW_CYCLE_H
#define RW_CYCLE_H

#include "contact/contact.h"

typedef struct {
    rwedge_contact *contact;
    rw_loads loads; /* that led here */
    rw_patch patch; /* of the contact; NaN when separated */
    rw_patch stuck; /* where nothing has slipped since the state before */
    bool is_load;   /* after a load; else on the way to one, where P or M changes */
} rw_state;

/* The states of a cycle. The first one is that before it. */
typedef struct {
    rw_state *states;
    size_t count, loads;
    double rounding; /* of an edge */
    bool is_kept;    /* the contact has it, and frees it */
    bool is_counted; /* slip counts from its first state, where it was not known */
} rw_cycle;

/* Stresses need the states after the loads alone, slip those on the way too. */
typedef enum { RW_STRESS_ALONE, RW_SLIP_TOO, RW_CYCLE_USES } rw_cycle_use;

/* The states of the cycle: those that the contact keeps, if they are of the same loads, else new
 * ones. For slip, RWEDGE_EPATH where the slip of a state has no closed form. The caller destroys
 * the cycle, after an error too. */
int32_t rw_cycle_of(const rwedge_contact *contact, const rw_load_history *loads, rw_cycle_use use,
                    rw_cycle *cycle);
int32_t rw_cycle_create(const rwedge_contact *contact, const rw_load_history *loads,
                        rw_cycle_use use, rw_cycle *cycle); /* always new ones */
void rw_cycle_destroy(rw_cycle *cycle);

/* What friction does at a place of the surface. All 0 where there is no contact in the cycle. */
typedef struct {
    double slip_range, shear, energy; /* shear: the largest magnitude of q */
} rw_slip_measures;

rw_slip_measures rw_slip_measures_at(const rw_cycle *cycle, double x);

/* The stresses after each load at n places, 3 loads n numbers: those of a load one after the other,
 * sxx of all loads first, then syy and txy. */
int32_t rw_cycle_stresses(const rw_cycle *cycle, size_t n, const double x[], const double y[],
                          double stress[]);

/* The largest sxx after any load at the place i, from the stresses at n places. */
double rw_largest_stress(const rw_cycle *cycle, size_t n, const double stress[], size_t i);

#endif
