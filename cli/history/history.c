/* SPDX-License-Identifier: GPL-3.0-or-later */
/* "rwedge history". */
#include "history.h"

#include <math.h>
#include <string.h>

static struct poptOption history_output_option_table[] = {
    {FORMAT_OPTION("csv|tsv|json|xlsx|series")},
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, other_output_option_table, 0, NULL, NULL},
    POPT_TABLEEND,
};

static const struct poptOption options[] = {
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, input_option_table, 0, "The contact:", NULL},
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, strength_option_table, 0, "Its strength:", NULL},
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, history_option_table, 0, "Its loads:", NULL},
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, place_option_table, 0,
     "Stresses at points in place of a row for each load:", NULL},
    {NO_FORMULAS_OPTION},
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, history_output_option_table, 0, "Common options:", NULL},
    POPT_TABLEEND,
};

static void describe(FILE *stream)
{
    fputs("\nLOADS.csv has the columns P and Q, and M and sigma if there are any. Others\n"
          "pass through. Loads run in straight steps from row to row; --cycles goes through\n"
          "the rows again and again (default once). Beside a file, --load gives loads that\n"
          "are applied once, before it. Any consistent units.\n"
          "\nResults, a row for each load:\n",
          stream);
    for (int i = 0; i < AFTER_COUNT; i++)
        fprintf(stream, "  %-13s %s\n", after_load_kinds[i].column, after_load_kinds[i].meaning);
    fputs("\nWith points, a row for each load and point: load, x, y (the depth), sxx, syy,\n"
          "szz, txy, s1, s2, von_mises, tau_max. With -o NAME.vtk.series a file for each\n"
          "load, for ParaView: NAME_0001.vtk and so on, or NAME_b0001.vtk where the series\n"
          "that is replaced has those names. Its files are then removed.\n"
          "\nLoads that have no closed form are computed. With --exact they are an error that\n"
          "names the line; nothing is then written, unless --until is given.\n",
          stream);
}

/* The contact, its loads and the points to write. */
typedef struct {
    contact_history history;
    places at;
    doubts doubts;    /* of any load */
    double energy[2]; /* at the end, and a cycle before */
} plan;

static void write_load(plan *job, size_t step, const rwedge_contact *contact, records *rows)
{
    after_load row;
    after_load_compute(&job->history.setup, contact, step + 1, &row);
    load_history_write_unused(&job->history.loads, contact_history_row(&job->history, step),
                              row.warnings, sizeof row.warnings);
    doubts_add(&job->doubts, row.doubts);
    passed_cells(&job->history.loads, contact_history_row(&job->history, step), rows);
    records_row(rows, AFTER_COUNT, row.value);
    if ((step + 1) % job->history.loads.count == 0) {
        job->energy[0] = job->energy[1];
        job->energy[1] = row.value[AFTER_ENERGY].number;
    }
    progress_step();
}

static void write_loads(plan *job, records *rows)
{
    rwedge_contact *contact = contact_history_begin(&job->history);
    passed_names(&job->history.loads, rows);
    for (int i = 0; i < AFTER_COUNT; i++)
        records_name(rows, after_load_kinds[i].column);
    records_end_header(rows);
    for (size_t step = 0; step < job->history.steps && records_go_on(rows); step++) {
        contact_history_go_on(&job->history, step, contact);
        write_load(job, step, contact, rows);
    }
    rwedge_contact_destroy(contact);
}

static void write_rows(void *of_plan, records *rows)
{
    plan *job = of_plan;
    const point_rows points = {&job->history, &job->at};
    const size_t count = job->history.steps * (job->at.count > 0 ? job->at.count : 1);
    progress_start(rows->show_progress, (int64_t)count, "rows");
    rows->mark = job->history.loads.has_mark;
    if (job->at.count > 0)
        point_rows_write(&points, rows);
    else
        write_loads(job, rows);
}

static const char *const formats[] = {"csv", "tsv", "json", "xlsx", "series", NULL};

static void check_series(const plan *job, const output_options *how)
{
    if (how->format != NULL)
        return;
    if (how->path == NULL || strcmp(how->path, "-") == 0)
        usage_error("--format series: writes several files; allowed with: --output "
                    "NAME.vtk.series");
    if (job->at.count == 0)
        usage_error("--output %s: needs points; allowed with: --at, --points, or --x and --depth",
                    how->path);
}

static void check_names(const plan *job)
{
    const char *names[AFTER_COUNT];
    for (int i = 0; i < AFTER_COUNT; i++)
        names[i] = after_load_kinds[i].column;
    if (job->at.count > 0)
        passed_check(&job->history.loads, point_columns, POINT_COLUMNS);
    else
        passed_check(&job->history.loads, names, AFTER_COUNT);
}

static void read_plan(const arguments *line, plan *job, output_options *how)
{
    output_options_read_of(line, formats, "", how);
    places_spare_files(line, how);
    if (line->value[OPTION_X] == NULL && line->value[OPTION_DEPTH] != NULL)
        usage_error("--depth %s: needs --x", line->value[OPTION_DEPTH]);
    places_read(line, how->decimal_sign, &job->at);
    check_series(job, how);
    contact_history_read(line, how->decimal_sign, (usual_cycles){.cycles = 1}, &job->history);
    check_names(job);
}

static void say_doubts(const plan *job)
{
    char where[LOAD_PLACE_SIZE];
    snprintf(where, sizeof where, "%.250s, in some rows: ",
             job->history.loads.name != NULL ? job->history.loads.name : "--load");
    doubts all = job->doubts;
    doubts_add(&all, (doubts){.error = job->history.error}); /* with points no row says it */
    doubts_say(all, where);
    load_history_say_unused(&job->history.loads);
    const double energy = job->energy[1] - job->energy[0]; /* NAN where it is not known */
    if (job->history.cycles > 1 && job->at.count == 0 && !isnan(energy))
        notice("dissipated in the last cycle: %.6g", energy);
}

static int history(const arguments *line)
{
    plan job = {.at = {0}};
    output_options how;
    read_plan(line, &job, &how);
    const point_rows points = {&job.history, &job.at};
    if (how.format == NULL)
        series_write(&points, line, &how);
    else
        output_options_write(&how, write_rows, &job);
    say_doubts(&job);
    return STATUS_DONE;
}

static const syntax grammar = {options, "LOADS.csv [OPTION...]", describe, OPTION_LOAD};

const command history_command = {
    "history",
    "rwedge history",
    "a table of loads: what the contact is after each, or its stresses",
    &grammar,
    NULL,
    history};
