/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The lives of a series of tests: measured over predicted. */
#include "figure.h"

#include <math.h>

static void compute_tests(const figure_case *inputs, dataset *rows)
{
    const series_table *table = inputs->tests;
    for (size_t i = 0; i < table->count; i++) {
        const test_run *run = &table->run[i];
        if (!run->is_run || isnan(run->test.tested) || isnan(run->results.life))
            continue;
        dataset_add(rows, (data_row){.number = {(double)(i + 1), run->results.life,
                                                run->test.tested, run->test.is_run_out}});
        rows->error = fmax(rows->error, run->results.doubts.error);
    }
}

const figure figure_tests = {
    .name = "tests",
    .summary = "measured over predicted lives of a series, bands of 2 and 3",
    .has_tests = true,
    .column = (const char *const[]){"row", "life", "life_tested", "is_run_out", NULL},
    .compute = compute_tests,
    .drawn = 1 << 1,
    .nothing = "no test has a life that was measured, and one that is predicted",
    .script = tests_lines};
