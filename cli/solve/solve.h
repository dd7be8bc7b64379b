/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_SOLVE_H
#define CLI_SOLVE_H

#include "model/results/results.h"
#include "rows/rows.h"

/* "rwedge solve --input": a file of contacts, a row each, with the results beside them. */

typedef struct {
    const char *path, *encoding; /* NULL for UTF-8 */
    input_texts constants; /* of the command line: for the columns that the file does not have */
    results_wanted wanted; /* the edges too where a column needs them */
    bool takes_hull;       /* of profiles that the file names */
    int threads;           /* that compute; the rows do not depend on it */
} batch;

/* Returns the exit status: that of a failure where there are rows and every one has an error. */
int batch_run(const batch *many, const output_options *how);

#endif
