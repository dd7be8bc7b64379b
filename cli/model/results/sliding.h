/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The strength of a pad in full sliding where it has no formulas: from its contact. */
#ifndef CLI_SLIDING_H
#define CLI_SLIDING_H

#include "results.h"

/* Adds the results for full sliding to those of the present state. Returns the library's status. */
int32_t results_of_sliding(const contact_case *setup, cell row[]);

/* The value of P, f or the radius with which first yield, in full sliding, is at `safety` times the
 * load of the case; the case has 1 for this input. NAN where there is none within the known part of
 * the pad. */
double sliding_find(const contact_case *setup, int input, double safety);

#endif
