/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge workbook: the spreadsheet that computes. */
#include "workbook.h"

#include "rows/rows.h"

static const struct poptOption options[] = {
    {"output", 'o', POPT_ARG_STRING, NULL, OPTION_OUTPUT,
     "Write to FILE, whole or not at all; - is standard output", "FILE"},
    {VALUE("digits", OPTION_DIGITS), "Significant digits of the numbers of a CSV file", "N"},
    {FLAG("decimal-comma", OPTION_DECIMAL_COMMA),
     "The CSV files have 1,5 for 1.5, and ';' between the columns", NULL},
    {HELP_OPTION},
    POPT_TABLEEND,
};

static void describe(FILE *stream)
{
    fputs("\nA workbook (XLSX) with a calculator, in plain formulas, and the tables that it\n"
          "uses: for a/b from 0.003, f from 0 to 0.8, every Poisson's ratio. Its sheet\n"
          "\"About\" says how exact it is.\n"
          "\nOr of CSV files, such as tables of this tool: a sheet for each, numbers as\n"
          "numbers.\n",
          stream);
}

static const char *const formats[] = {"xlsx", NULL};

/* The comma is that of the files; the cells of a workbook have no sign. */
static void write_sheets(const arguments *line)
{
    const bool comma = line->value[OPTION_DECIMAL_COMMA] != NULL;
    csv_files files = {line->operand, comma ? ',' : '.'};
    arguments others = *line;
    output_options how;
    others.value[OPTION_DECIMAL_COMMA] = NULL;
    output_options_read_of(&others, formats, "", &how);
    for (int i = 0; files.path[i] != NULL; i++)
        if (i >= CSV_SHEETS_MAX)
            usage_error("%s: unexpected; allowed: up to %d files", files.path[i], CSV_SHEETS_MAX);
    output_options_write(&how, csv_sheets_write, &files);
}

static void write_book(const arguments *line, const char *path)
{
    output out;
    if (line->value[OPTION_DIGITS] != NULL)
        usage_error("--digits: the workbook has its own; allowed with: CSV files");
    if (line->value[OPTION_DECIMAL_COMMA] != NULL)
        usage_error("--decimal-comma: a workbook has no sign; allowed with: CSV files");
    output_format_choose(line, formats, "");
    if (path[0] == '-' && path[1] == '\0' && stream_is_terminal(stdout))
        usage_error("--output -: a workbook is not for a terminal; allowed: the name of a file, or "
                    "a redirected -");
    if (xlsx_missing() != NULL)
        failure("%s: %s", path, xlsx_missing());
    output_open(&out, path);
    book_write(&out);
    output_finish(&out);
}

static int workbook(const arguments *line)
{
    const char *path = line->value[OPTION_OUTPUT];
    if (path == NULL || path[0] == '\0')
        usage_error(
            "--output: missing; allowed: the name of a file, such as rounded-wedge.xlsx, or -");
    if (line->operand != NULL && line->operand[0] != NULL)
        write_sheets(line);
    else
        write_book(line, path);
    return STATUS_DONE;
}

const command workbook_command = {.name = "workbook",
                                  .summary =
                                      "a spreadsheet that computes, with its tables and charts",
                                  .grammar = {options, "[FILE.csv...] -o FILE", describe},
                                  .run = workbook};
