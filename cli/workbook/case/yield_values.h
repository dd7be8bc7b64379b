/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The values of a case that tell when it yields and where, from the table. */
#ifndef CLI_YIELD_VALUES_H
#define CLI_YIELD_VALUES_H

#include "cells.h"
#include "yield_table.h"

/* Fills the working cells. The contact is solved. */
void yield_solve(const yield_table *table, double v[CELL_COUNT]);

/* Fills the results, of a case with inputs. */
void yield_answer(const yield_table *table, case_values *out);

/* The values of limit_at_tip and limit_at_friction for a node, counted from 0. */
double workbook_limit_at_tip(const yield_table *table, const case_values *values, int node);
double workbook_limit_at_friction(const yield_table *table, const case_values *values, int node);

#endif
