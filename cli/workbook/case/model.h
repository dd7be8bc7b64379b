/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the workbook computes for a case, in C: the value of every cell of cells.h. The file shows
 * these values until the spreadsheet recalculates them, by the formulas in cells.c. */
#ifndef CLI_MODEL_H
#define CLI_MODEL_H

#include "cells.h"
#include "yield_table.h"

/* Of inputs that are sound, within the tables, and where |Q| is not above f P; NAN where an input
 * is not given. Or of no inputs at all: all of them NAN. */
void workbook_compute(const yield_table *table, const double input[INPUT_CELLS], case_values *out);

#endif
