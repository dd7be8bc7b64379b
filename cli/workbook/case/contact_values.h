/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The values of a case but for yield: its inputs, the contact and its stick zone. */
#ifndef CLI_CONTACT_VALUES_H
#define CLI_CONTACT_VALUES_H

#include "cells.h"

/* Fills the inputs and the working cells. */
void contact_solve(const double input[INPUT_CELLS], double v[CELL_COUNT]);

/* Fills the results, of a case with inputs. */
void contact_answer(double v[CELL_COUNT]);

#endif
