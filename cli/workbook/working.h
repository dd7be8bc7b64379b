/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The hidden sheet: the calculator's working cells in a row, the table of yield, what the charts
 * draw. */
#ifndef CLI_WORKING_H
#define CLI_WORKING_H

#include "model.h"

#include "sheet/xlsx.h"

/* Where the charts find their curves and marks: columns of the rows from CURVE_ROW on. */
enum {
    CURVE_ROW = 10,
    CURVE_TIP = 8,
    CURVE_TIP_LIMIT,
    CURVE_FRICTION,
    CURVE_FRICTION_LIMIT,
    CURVE_MARK_TIP,
    CURVE_MARK_FRICTION,
    CURVE_MARK_LIMIT,
    CURVE_MARK_TENSION,
    CURVES_END
};
#define WORKING_SHEET "Working"

void sheet_working(xlsx *book, const yield_table *table, const case_values *values);

#endif
