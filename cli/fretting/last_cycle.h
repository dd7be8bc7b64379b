/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The last cycle of a course of loads, and what it does to a place. */
#ifndef CLI_LAST_CYCLE_H
#define CLI_LAST_CYCLE_H

#include "history/course.h"

enum {
    MEASURE_STRESS_RANGE,
    MEASURE_SWT,
    MEASURE_SWT_ANGLE, /* in degrees, as the other angle */
    MEASURE_FATEMI_SOCIE,
    MEASURE_FS_ANGLE,
    MEASURE_SLIP_RANGE,
    MEASURE_RUIZ_F1,
    MEASURE_RUIZ_F2,
    MEASURE_ENERGY_PER_AREA,
    MEASURE_COUNT
};

typedef struct {
    const char *column, *meaning;
    bool is_angle;
} measure_kind;
extern const measure_kind measure_kinds[MEASURE_COUNT];

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
