/* SPDX-License-Identifier: GPL-3.0-or-later */
/* "rwedge crack". */
#include "crack.h"

#include <math.h>

enum { OPTION_EACH_LOAD = OPTION_AFTER_CRACK, OPTION_VERDICT };

static const struct poptOption options[] = {
    CONTACT_OPTIONS,
    {INCLUDED(history_option_table), "Its loads:", NULL},
    {INCLUDED(crack_option_table), "The crack:", NULL},
    {FLAG("verdict", OPTION_VERDICT), "Whether it stops, in place of the rows", NULL},
    {FLAG("each-load", OPTION_EACH_LOAD), "K after each load, in place of the rows", NULL},
    {THREADS_OPTION},
    {INCLUDED(output_option_table), "Common options:", NULL},
    POPT_TABLEEND,
};

static void describe(FILE *stream)
{
    fputs("\nLOADS.csv is a cycle of loads, gone through as for \"rwedge fretting\": the last\n"
          "time counts. The crack is straight, and the contact is as if there were none. K_I\n"
          "below 0 counts as 0 in a range; in the columns closing_ faces press on each\n"
          "other, and a verdict stands on these.\n"
          "\nColumns:\n",
          stream);
    columns_describe(crack_columns, crack_column_count, 18, stream);
    fputs("\nWith --verdict, a row for each way in which K_II counts:\n", stream);
    columns_describe(verdict_columns, verdict_column_count, 18, stream);
    fputs("\nThe threshold of a short crack is dK_th sqrt(l/(l + a0)), El Haddad's, with a0 =\n"
          "(dK_th/(1.1215 ds0))^2/pi; without --ds0 it is dK_th. The constants are those of\n"
          "the stress ratio of the cycle. C gives mm a cycle.\n",
          stream);
}

typedef struct {
    contact_history history;
    last_cycle last;
    doubts doubts;
    material constants;
    crack_plan crack;
} plan;

static void read_plan(const arguments *line, plan *job, output_options *how)
{
    input_texts texts;
    output_options_read(line, how);
    if (line->value[OPTION_VERDICT] != NULL && line->value[OPTION_EACH_LOAD] != NULL)
        usage_error("--verdict: given together with --each-load; allowed: one of the two");
    job->crack.threads = threads_read(line);
    input_texts_from_options(line, &texts);
    job->constants = *material_of(line);
    crack_law_read(line, &job->constants, &job->crack.crack.law);
    contact_history_read(line, &texts, how->decimal_sign, 3, 3, &job->history);
    const criteria asked = criteria_usual(&job->history.setup);
    history_cycle(&job->history, &asked, &job->last, &job->doubts);
    crack_read(line, &job->last, &job->crack);
    if (line->value[OPTION_VERDICT] != NULL && !crack_has_threshold(&job->crack.crack.law) &&
        !crack_has_rate(&job->crack.crack.law))
        usage_error("--verdict: needs --dK-th, or --C and --m");
    if (line->value[OPTION_VERDICT] != NULL && job->crack.crack.lengths < 2)
        usage_error("--verdict: needs two lengths at least, --from and --to");
}

static int crack(const arguments *line)
{
    plan job = {.doubts = 0};
    output_options how;
    read_plan(line, &job, &how);
    output_options_write(&how,
                         line->value[OPTION_VERDICT] != NULL     ? crack_verdict_write
                         : line->value[OPTION_EACH_LOAD] != NULL ? crack_loads_write
                                                                 : crack_rows_write,
                         &job.crack);
    crack_verdict_say(&job.crack);
    crack_doubts_say(&job.crack);
    doubts_say(job.doubts, "");
    unused_say(&job.history.loads.names, job.history.loads.name);
    return STATUS_DONE;
}

const command crack_command = {
    .name = "crack",
    .summary = "a crack at the edge in a cycle of loads: K, whether it stops, its life",
    .grammar = {options, "LOADS.csv [OPTION...]", describe, OPTION_LOAD},
    .run = crack};
