/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge report: a case on one page. */
#include "report.h"

#include "rows/rows.h"

enum { OPTION_EQUATIONS = OPTION_AFTER_CRITERIA, OPTION_NO_PICTURES };

static const struct poptOption options[] = {
    CONTACT_OPTIONS,
    {INCLUDED(criteria_option_table), "Criteria, of a cycle of loads:", NULL},
    {INCLUDED(history_option_table), "Its loads:", NULL},
    {FLAG("equations", OPTION_EQUATIONS), "Add the formulas with the numbers put in", NULL},
    {FLAG("no-pictures", OPTION_NO_PICTURES), "Leave the pictures out, which gnuplot draws", NULL},
    {VALUE("format", OPTION_FORMAT), "How it is written (default html)", "html"},
    {"output", 'o', POPT_ARG_STRING, NULL, OPTION_OUTPUT,
     "Write to FILE, whole or not at all (default: standard output)", "FILE"},
    {HELP_OPTION},
    POPT_TABLEEND,
};

static void describe(FILE *stream)
{
    fputs("\nOne page of HTML, which a browser shows and prints: pad, loads, verdicts,\n"
          "pictures, what was assumed, which errors are told. CASE.json is what --case\n"
          "reads and --save-case writes; options replace what it has. Several loads are\n"
          "a history: results are those after the last, as of \"rwedge solve\", criteria\n"
          "those of the last of --cycles (default 3), as of \"rwedge fretting\". gnuplot\n"
          "draws the pictures: it must be on PATH (package gnuplot-nox).\n",
          stream);
}

static void write_page(void *of_report, records *rows)
{
    report_write(of_report, rows->out);
}

static int run(const arguments *line)
{
    static const char *const formats[] = {"html", NULL};
    static report page; /* is large */
    output_options how;
    output_options_read_of(line, formats, "", &how);
    output_options_spare_files(line, &how);
    page.shows_equations = line->value[OPTION_EQUATIONS] != NULL;
    page.shows_pictures = line->value[OPTION_NO_PICTURES] == NULL;
    report_compute(line, &page);
    output_options_write(&how, write_page, &page);
    doubts_say(page.doubts, "");
    return STATUS_DONE;
}

const command report_command = {
    .name = "report",
    .summary = "a case on one page: results, verdicts, pictures",
    .grammar = {options, "CASE.json [OPTION...]", describe, OPTION_LOAD},
    .run = run,
    .is_of_any_case = true};
