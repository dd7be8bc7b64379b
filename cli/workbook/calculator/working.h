/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The hidden sheet: the calculator's working cells in a row, the table of yield, what the charts
 * draw. */
#ifndef CLI_WORKING_H
#define CLI_WORKING_H

#include "sheet/xlsx.h"
#include "workbook/case/cells.h"
#include "workbook/case/yield_table.h"

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

/* The calculator's sketch: lines, and names at single points. Its columns follow CURVES_END, x and
 * y of each part. */
enum { SKETCH_PARTS = 18, SKETCH_POINTS = 9 };
typedef struct {
    const char *name;
    int points;
    double x[SKETCH_POINTS], y[SKETCH_POINTS];
} sketch_part;
extern const sketch_part sketch[SKETCH_PARTS];

/* The names of the curves, below each other in the column after the sketch's. LibreOffice loses
 * names that are in no cell when a sheet is inserted in front. */
enum {
    LEGEND_NORMAL,
    LEGEND_DEPTH,
    LEGEND_TIP_CURVE,
    LEGEND_CASE,
    LEGEND_FRICTION_CURVE,
    LEGEND_TENSION,
    LEGEND_FAMILY, /* a/b = 1 to 0.1 */
    LEGEND_END = LEGEND_FAMILY + 10,
    LEGEND_COLUMN = CURVES_END + 2 * SKETCH_PARTS
};

/* The bar of the verdict: places in one column, heights of its parts in the next three. */
enum {
    BAR_COLUMN = LEGEND_COLUMN + 1,
    BAR_FROM_0 = 0,
    BAR_FROM_FACTOR,
    BAR_LIMIT = 3,
    BAR_MOST = 3
};

void sheet_working(xlsx *book, const yield_table *table, const case_values *values);

#endif
