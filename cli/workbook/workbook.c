/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "workbook.h"

#include "text/message.h"
#include "about.h"
#include "calculator.h"
#include "table_sheets.h"

#include <stdlib.h>
#include <unistd.h>

/* The sheets, in their order. */
enum {
    SHEET_CALCULATOR,
    SHEET_ELASTIC_LIMIT,
    SHEET_MAX_TENSION,
    SHEET_CONTACT_LAW,
    SHEET_CRITICAL_FRICTION,
    SHEET_ABOUT
};

static const struct poptOption options[] = {
    {"output", 'o', POPT_ARG_STRING, NULL, OPTION_OUTPUT,
     "Write to FILE, whole or not at all; - is standard output", "FILE"},
    OPTION_HELP_ENTRY,
    POPT_TABLEEND,
};

static void describe(FILE *stream)
{
    fputs(
        "\nA workbook (XLSX) with a calculator, in plain formulas, and the tables that it uses:\n"
        "for a/b from 0.01, f from 0 to 0.8, every Poisson's ratio. Its sheet \"About\" says how\n"
        "exact it is.\n",
        stream);
}

static bool fill(xlsx *book, const limit_table *table)
{
    static const char *const names[] = {"Calculator",  "Elastic limit",     "Maximum tension",
                                        "Contact law", "Critical friction", "About"};
    for (int i = 0; i <= SHEET_ABOUT; i++)
        xlsx_sheet(book, names[i]);
    xlsx_turn_to(book, SHEET_ELASTIC_LIMIT);
    bool done = sheet_elastic_limit(book, table);
    xlsx_turn_to(book, SHEET_MAX_TENSION);
    sheet_max_tension(book);
    xlsx_turn_to(book, SHEET_CONTACT_LAW);
    sheet_contact_law(book);
    xlsx_turn_to(book, SHEET_CRITICAL_FRICTION);
    done = sheet_critical_friction(book) && done;
    xlsx_turn_to(book, SHEET_ABOUT);
    sheet_about(book);
    xlsx_turn_to(book, SHEET_CALCULATOR);
    sheet_calculator(book, table);
    return done;
}

static bool write_workbook(const limit_table *table, output *out)
{
    xlsx *book = xlsx_begin("rwedge: contact of a rounded wedge", false);
    if (book == NULL || !fill(book, table)) {
        failure("%s: %s", out->name,
                book == NULL ? XLSX_NOT_BEGUN : "a value of the tables could not be computed");
        xlsx_discard(book);
        return false;
    }
    const char *problem = xlsx_finish(book, out);
    if (problem != NULL)
        failure("%s: %s", out->name, problem);
    return problem == NULL;
}

static int write_file(const char *path)
{
    limit_table *table = malloc(sizeof *table);
    output *out = malloc(sizeof *out);
    int status = STATUS_FAILED;
    if (table == NULL || out == NULL)
        failure("out of memory");
    else if (!limit_table_fill(table))
        failure("the elastic limit: a value could not be computed");
    else if (output_open(out, path)) {
        if (write_workbook(table, out))
            status = output_finish(out) ? STATUS_DONE : STATUS_FAILED;
        else
            output_discard(out);
    }
    free(table);
    free(out);
    return status;
}

static int write_given(const arguments *given)
{
    const int status = arguments_no_operand(given);
    const char *path = given->value[OPTION_OUTPUT];
    if (status != STATUS_DONE)
        return status;
    if (path == NULL || path[0] == '\0')
        return usage_error(
            "--output: missing; allowed: the name of a file, such as rounded-wedge.xlsx, or -");
    if (path[0] == '-' && path[1] == '\0' && isatty(STDOUT_FILENO))
        return usage_error("--output -: a workbook is not for a terminal; allowed: the name of a "
                           "file, or a redirected -");
    if (!xlsx_available())
        return failure("%s: " XLSX_MISSING, path);
    return write_file(path);
}

static const syntax grammar = {options, "-o FILE", describe, 0};

const command workbook_command = {"workbook",
                                  "rwedge workbook",
                                  "a spreadsheet that computes, with its tables and charts",
                                  &grammar,
                                  NULL,
                                  write_given};
