/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The calculator's working cells: the steps of model.c as formulas, with their names. */
#ifndef CLI_WORKING_H
#define CLI_WORKING_H

#include "model.h"

#include "sheet/xlsx.h"

/* Where they begin, right of what is printed, and what the charts draw of them. */
enum {
    WORKING_STEPS = 38,
    WORKING_COLUMN = 18,
    WORKING_ROW = 5,
    TIPS_COLUMN = WORKING_COLUMN + 10,
    FRICTIONS_COLUMN = TIPS_COLUMN + 11
};

void sheet_working(xlsx *book, const limit_table *table, const workbook_inputs *in,
                   const workbook_results *out);

#endif
