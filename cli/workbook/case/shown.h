/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The numbers that the file shows until a spreadsheet computes: those of "rwedge solve". */
#ifndef CLI_SHOWN_H
#define CLI_SHOWN_H

#include "cells.h"

/* Of sound inputs without a load that slides; NAN where an input is not given. */
void shown_values(const double input[INPUT_CELLS], case_values *shown);

/* The same of a row without inputs: nothing. */
void shown_nothing(case_values *shown);

#endif
