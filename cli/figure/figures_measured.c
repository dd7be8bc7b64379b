/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A loop as a rig measured it, and as it is fitted. */
#include "figure.h"

static void compute_measured(const figure_case *inputs, dataset *rows)
{
    const load_history *log = &inputs->history.loads;
    for (size_t i = 0; i < log->count; i++)
        dataset_add(rows, (data_row){.number = {log->load[i].displacement, log->load[i].Q,
                                                inputs->fit.Q[i]}});
}

static void prepare_measured(const figure_case *inputs, const dataset *rows, FILE *script)
{
    const double *value = inputs->fit.value;
    (void)rows;
    script_number(script, "f", value[LOOP_F]);
    script_number(script, "compliance", value[LOOP_COMPLIANCE]);
}

const figure figure_measured = {
    .name = "measured",
    .summary = "a loop as it was measured and as fitted, --history LOG.csv",
    .has_loop = true,
    .column = (const char *const[]){"displacement", "Q", "Q_fitted", NULL},
    .compute = compute_measured,
    .prepare = prepare_measured,
    .script = measured_lines};
