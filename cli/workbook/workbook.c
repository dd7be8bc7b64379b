/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge workbook: CSV files as one spreadsheet. */
#include "workbook.h"

#include "rows/rows.h"

static const struct poptOption options[] = {
    {"output", 'o', POPT_ARG_STRING, NULL, OPTION_OUTPUT,
     "Write to FILE, whole or not at all; - is standard output", "FILE"},
    {VALUE("digits", OPTION_DIGITS), "Significant digits of the numbers", "N"},
    {FLAG("decimal-comma", OPTION_DECIMAL_COMMA),
     "The CSV files have 1,5 for 1.5, and ';' between the columns", NULL},
    {HELP_OPTION},
    POPT_TABLEEND,
};

static void describe(FILE *stream)
{
    fputs("\nA spreadsheet (XLSX) of CSV files, such as tables of this tool: a sheet for\n"
          "each, numbers as numbers. The spreadsheet that computes is a file of its own,\n"
          "rounded-wedge.xlsx.\n",
          stream);
}

static const char *const formats[] = {"xlsx", NULL};

/* The comma is that of the files; the cells of a spreadsheet have no sign. */
static int workbook(const arguments *line)
{
    const bool comma = line->value[OPTION_DECIMAL_COMMA] != NULL;
    const char *path = line->value[OPTION_OUTPUT];
    csv_files files = {line->operand, comma ? ',' : '.'};
    arguments others = *line;
    output_options how;
    if (path == NULL || path[0] == '\0')
        usage_error("--output: missing; allowed: the name of a file, such as tables.xlsx, or -");
    if (files.path == NULL || files.path[0] == NULL)
        usage_error("FILE.csv: missing; allowed: up to %d CSV files. The spreadsheet that computes "
                    "is a file of its own, rounded-wedge.xlsx",
                    CSV_SHEETS_MAX);
    others.value[OPTION_DECIMAL_COMMA] = NULL;
    output_options_read_of(&others, formats, "", &how);
    for (int i = 0; files.path[i] != NULL; i++)
        if (i >= CSV_SHEETS_MAX)
            usage_error("%s: unexpected; allowed: up to %d files", files.path[i], CSV_SHEETS_MAX);
    output_options_write(&how, csv_sheets_write, &files);
    return STATUS_DONE;
}

const command workbook_command = {.name = "workbook",
                                  .summary = "CSV files as the sheets of one spreadsheet",
                                  .grammar = {options, "FILE.csv... -o FILE", describe},
                                  .run = workbook};
