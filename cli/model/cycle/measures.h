/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a cycle of loads does to a place: the columns of "rwedge fretting", in words. */
#ifndef CLI_MEASURES_H
#define CLI_MEASURES_H

#include <stdbool.h>
#include <stdint.h>

/* Of fatigue; NO_CRITERION of what is none. */
enum {
    NO_CRITERION = -1,
    CRITERION_SWT,
    CRITERION_FATEMI_SOCIE,
    CRITERION_FINDLEY,
    CRITERION_MODIFIED_WOHLER,
    CRITERION_MCDIARMID,
    CRITERION_CROSSLAND,
    CRITERION_DANG_VAN,
    CRITERION_SWT_DAMAGE,
    CRITERION_FS_DAMAGE,
    CRITERION_COUNT
};

/* The columns of a criterion: its value, the angles of its plane in degrees, and of damage the
 * number of cycles. What is no criterion is a value. */
typedef enum { PART_VALUE, PART_ANGLE, PART_OUT_OF_PLANE, PART_CYCLES, PART_COUNT } measure_part;

/* Those without a name here are found by measure_column(). */
enum {
    MEASURE_STRESS_RANGE,
    MEASURE_SWT,
    MEASURE_SWT_ANGLE,
    MEASURE_SLIP_RANGE = 5,
    MEASURE_RUIZ_F1,
    MEASURE_RUIZ_F2,
    MEASURE_ENERGY_PER_AREA,
    MEASURE_COUNT, /* those that are always there; the others follow where they are asked for */
    COLUMN_WEAR = 30,
    COLUMN_COUNT
};

typedef struct {
    const char *column, *meaning, *unit;
    int criterion;
    measure_part part;
    int32_t number; /* as the library calls the measure; -1 for none */
} measure_kind;
extern const measure_kind measure_kinds[COLUMN_COUNT];

/* A part of a criterion; -1 where it has none. */
int measure_column(int criterion, measure_part part);

/* The criterion that a column has the value of; NO_CRITERION for other columns. */
int measure_criterion(int column);

#endif
