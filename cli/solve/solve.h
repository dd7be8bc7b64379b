/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_SOLVE_H
#define CLI_SOLVE_H

#include "model/results/results.h"
#include "rows/rows.h"

/* "rwedge solve --input": a file of contacts, a row each, with the results beside them. The
 * constants are for the columns that the file does not have; the edges are wanted too where a
 * column needs them. Returns the exit status: that of a failure where there are rows and every one
 * has an error. */
int batch_run(const arguments *line, const char *path, const input_texts *constants,
              results_wanted wanted, const output_options *how);

/* Says what a fit of the pad leaves within the contact, and how p0 changes with another number of
 * arcs; nothing of other pads. */
void fit_say(const contact_case *setup);

#endif
