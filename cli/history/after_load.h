/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a contact is after a load: the row that "rwedge history" writes of it. */
#ifndef CLI_AFTER_LOAD_H
#define CLI_AFTER_LOAD_H

#include "model/doubts.h"
#include "rows/records.h"

enum {
    AFTER_LOAD,
    AFTER_P,
    AFTER_M,
    AFTER_Q,
    AFTER_SIGMA,
    AFTER_LEFT,
    AFTER_RIGHT,
    AFTER_STICK_LEFT,
    AFTER_STICK_RIGHT,
    AFTER_TILT,
    AFTER_PEAK_PRESSURE,
    AFTER_TENSION_LEFT,
    AFTER_TENSION_RIGHT,
    AFTER_LARGEST_SLIP,
    AFTER_ENERGY,
    AFTER_YIELD_FACTOR,
    AFTER_YIELD_X,
    AFTER_YIELD_Y,
    AFTER_WARNINGS,
    AFTER_ERROR,
    AFTER_COUNT
};

typedef struct {
    const char *column, *meaning;
} after_load_kind;
extern const after_load_kind after_load_kinds[AFTER_COUNT];

typedef struct {
    cell value[AFTER_COUNT];
    char warnings[512]; /* the text of their cell */
    doubts doubts;
} after_load;

/* Of the load with that number. */
void after_load_compute(const contact_case *setup, const rwedge_contact *contact, size_t number,
                        after_load *row);

#endif
