/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The calculator: inputs, checks, results. */
#ifndef CLI_CALCULATOR_H
#define CLI_CALCULATOR_H

#include "model.h"

#include "sheet/xlsx.h"

/* Fills the sheet that has been turned to, with its working cells and its charts. */
void sheet_calculator(xlsx *book, const limit_table *table);

#endif
