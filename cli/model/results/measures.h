/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a cycle of loads does to a place, in words. */
#ifndef CLI_MEASURES_H
#define CLI_MEASURES_H

#include <stdbool.h>

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
    const char *column, *meaning, *unit;
    bool is_angle;
} measure_kind;
extern const measure_kind measure_kinds[MEASURE_COUNT];

#endif
