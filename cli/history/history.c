/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "history.h"

#include "after_load.h"
#include "point_rows.h"
#include "series.h"

#include "contact/notices.h"
#include "system/progress.h"
#include "text/message.h"

#include <string.h>

static struct poptOption history_output_option_table[] = {
    {FORMAT_OPTION("csv|tsv|json|xlsx|series")},
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, other_output_option_table, 0, NULL, NULL},
    POPT_TABLEEND,
};

static const struct poptOption options[] = {
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, input_option_table, 0, "The contact:", NULL},
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, strength_option_table, 0, "Its strength:", NULL},
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, course_option_table, 0, "Its loads:", NULL},
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
          "the rows again and again (default once). Any consistent units.\n"
          "\nResults, a row for each load:\n",
          stream);
    for (int i = 0; i < AFTER_COUNT; i++)
        fprintf(stream, "  %-13s %s\n", after_load_kinds[i].column, after_load_kinds[i].meaning);
    fputs("\nWith points, a row for each load and point: load, x, y (the depth), sxx, syy,\n"
          "szz, txy, s1, s2, von_mises, tau_max. With -o NAME.vtk.series a file for each\n"
          "load, for ParaView: NAME_0001.vtk and so on.\n"
          "\nA history that leaves the closed form is an error that names the line; nothing is\n"
          "then written, unless --until is given.\n",
          stream);
}

/* What is to be written. */
typedef struct {
    course whole;
    places at;
    int32_t doubts;   /* of any load */
    double energy[2]; /* at the end, and a cycle before */
} plan;

static bool write_load(plan *what, size_t step, const rwedge_contact *contact, records *rows)
{
    after_load found;
    if (!after_load_compute(&what->whole.what, contact, step + 1, &found))
        return false;
    load_table_write_unused(&what->whole.loads, course_row(&what->whole, step), found.warnings,
                            sizeof found.warnings);
    what->doubts |= found.doubts;
    passed_cells(&what->whole.loads, course_row(&what->whole, step), rows);
    for (int i = 0; i < AFTER_COUNT; i++)
        rows->format->value(rows, after_load_kinds[i].column, found.value[i]);
    rows->format->end_row(rows);
    if ((step + 1) % what->whole.loads.count == 0) {
        what->energy[0] = what->energy[1];
        what->energy[1] = found.value[AFTER_ENERGY].number;
    }
    progress_step();
    return true;
}

static bool write_loads(plan *what, records *rows)
{
    rwedge_contact *contact = course_begin(&what->whole);
    bool going = contact != NULL;
    passed_names(&what->whole.loads, rows);
    for (int i = 0; i < AFTER_COUNT; i++)
        rows->format->name(rows, after_load_kinds[i].column);
    rows->format->end_header(rows);
    for (size_t step = 0; step < what->whole.steps && going && records_go_on(rows); step++)
        going = course_go_on(&what->whole, step, contact) && write_load(what, step, contact, rows);
    rwedge_contact_destroy(contact);
    return going;
}

static bool write_rows(void *of_plan, records *rows, bool show_progress)
{
    plan *what = of_plan;
    const point_rows points = {&what->whole, &what->at};
    const size_t count = what->whole.steps * (what->at.count > 0 ? what->at.count : 1);
    progress_start(show_progress, (int64_t)count, "rows");
    rows->mark = what->whole.loads.has_mark;
    rows->format->begin(rows);
    const bool going =
        what->at.count > 0 ? point_rows_write(&points, rows) : write_loads(what, rows);
    rows->format->end(rows);
    progress_erase();
    return going && records_are_sound(rows);
}

static const char *const formats[] = {"csv", "tsv", "json", "xlsx", "series", NULL};

static int check_series(const plan *what, const output_options *how)
{
    if (how->format != NULL)
        return STATUS_DONE;
    if (how->path == NULL || strcmp(how->path, "-") == 0)
        return usage_error("--format series: writes several files; allowed with: --output "
                           "NAME.vtk.series");
    if (what->at.count == 0)
        return usage_error("--output %s: needs points; allowed with: --at, --points, or --x and "
                           "--depth",
                           how->path);
    return STATUS_DONE;
}

static int check_names(const plan *what)
{
    const char *names[AFTER_COUNT];
    for (int i = 0; i < AFTER_COUNT; i++)
        names[i] = after_load_kinds[i].column;
    return what->at.count > 0 ? passed_check(&what->whole.loads, point_columns, POINT_COLUMNS)
                              : passed_check(&what->whole.loads, names, AFTER_COUNT);
}

static int read_plan(const arguments *given, plan *what, output_options *how)
{
    int status = output_options_read_of(given, formats, "", how);
    if (status == STATUS_DONE)
        status = places_spare_files(given, how);
    if (status == STATUS_DONE && given->value[OPTION_X] == NULL &&
        given->value[OPTION_DEPTH] != NULL)
        status = usage_error("--depth %s: needs --x", given->value[OPTION_DEPTH]);
    if (status == STATUS_DONE)
        status = places_read(given, how->decimal_sign, &what->at);
    if (status == STATUS_DONE)
        status = check_series(what, how);
    if (status == STATUS_DONE)
        status = course_read(given, how->decimal_sign, (course_usage){.cycles = 1}, &what->whole);
    return status == STATUS_DONE ? check_names(what) : status;
}

static void say_what_is_doubtful(const plan *what)
{
    char where[LOAD_PLACE_SIZE];
    snprintf(where, sizeof where, "%.250s, in some rows: ",
             what->whole.loads.name != NULL ? what->whole.loads.name : "--load");
    doubts_say(what->doubts, where);
    load_table_say_unused(&what->whole.loads);
    if (what->whole.cycles > 1 && what->at.count == 0)
        notice("dissipated in the last cycle: %.6g", what->energy[1] - what->energy[0]);
}

static int history(const arguments *given)
{
    plan what = {.at = {0}};
    output_options how;
    int status = read_plan(given, &what, &how);
    const point_rows points = {&what.whole, &what.at};
    if (status == STATUS_DONE)
        status = how.format == NULL ? series_write(&points, &how)
                                    : output_options_write(&how, write_rows, &what);
    if (status == STATUS_DONE)
        say_what_is_doubtful(&what);
    course_free(&what.whole);
    places_free(&what.at);
    return status;
}

static const syntax grammar = {options, "LOADS.csv [OPTION...]", describe, OPTION_LOAD};

const command history_command = {
    "history",
    "rwedge history",
    "a table of loads: what the contact is after each, or its stresses",
    &grammar,
    NULL,
    history};
