/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The last cycle of a course of loads, and what it does to a place. */
#ifndef CLI_LAST_CYCLE_H
#define CLI_LAST_CYCLE_H

#include "history/course.h"
#include "model/measures.h"

/* Of one place; NAN where there is none. */
typedef struct {
    double value[MEASURE_COUNT];
} measures;

/* A state on the way: after a load; and, where P or M changes, between two. */
typedef struct {
    rwedge_contact *contact;
    double left, right; /* edges; NAN when separated */
    bool is_load;
} cycle_state;

typedef struct {
    const contact_case *what;
    double k_over_sy; /* Fatemi and Socie's k over the yield stress in tension; NAN: not known */
    size_t loads;
    cycle_state *state; /* the first is that before the cycle */
    size_t states;
    bool slip_known; /* it has a closed form after every load */
} last_cycle;

/* Goes through the course; a step in which P or M changes is cut into so many parts. False, with
 * the reason said; free it in either case. */
enum { CYCLE_PARTS = 32 };
bool last_cycle_begin(const course *whole, double k_over_sy, int parts, last_cycle *of);
void last_cycle_free(last_cycle *of);

/* At n places. Returns the library's status, or RWEDGE_ENOMEM. Threads may call it at a time. */
int32_t last_cycle_measure(const last_cycle *of, size_t n, const double x[], const double y[],
                           measures found[]);

/* The slip at a place of the surface in a state, NAN outside the contact. */
double last_cycle_slip(const last_cycle *of, size_t state, double x);

#endif
