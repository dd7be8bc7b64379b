/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The calculator: inputs, checks, results. */
#ifndef CLI_CALCULATOR_H
#define CLI_CALCULATOR_H

#include "sheet/xlsx.h"
#include "workbook/case/cells.h"

/* Fills the sheet that has been turned to; and the values of its case, which the sheet of working
 * cells needs. */
void sheet_calculator(xlsx *book, case_values *values);

#endif
