/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The options that every command with rows of results has: how they are written, and where. */
#ifndef CLI_OUTPUT_OPTIONS_H
#define CLI_OUTPUT_OPTIONS_H

#include "options/arguments.h"
#include "system/output.h"
#include "records.h"

typedef struct {
    const char *format_name;
    const record_format *format; /* NULL for a command's own format */
    int digits;
    char decimal_sign, separator;
    const char *path; /* NULL for standard output */
    bool quiet;
    bool no_formulas; /* CSV: a ' before texts that a spreadsheet would compute */
} output_options;

/* For a command's own table, by POPT_ARG_INCLUDE_TABLE; for one that can write VTK too; and what is
 * in them beside --format, for a command that has a format of its own. */
extern struct poptOption output_option_table[], grid_output_option_table[],
    other_output_option_table[];
extern const char *const grid_formats[]; /* of the second */

#define FORMAT_OPTION(formats)                                                                     \
    "format", '\0', POPT_ARG_STRING, NULL, OPTION_FORMAT, "How results are written (default csv)", \
        formats

/* For a command whose rows have texts of a file in them. */
#define NO_FORMULAS_OPTION                                                                         \
    "no-formulas", '\0', POPT_ARG_NONE, NULL, OPTION_NO_FORMULAS,                                  \
        "In csv and tsv a ' before texts that a spreadsheet would compute: = + - @", NULL

/* Reads the options; a mistake in them ends the command. */
void output_options_read(const arguments *line, output_options *how);

/* The same for a command with formats of its own. The list ends with NULL, its first is the
 * default; the hint follows where a message lists them. */
void output_options_read_of(const arguments *line, const char *const formats[], const char *hint,
                            output_options *how);

/* Which of these formats --format asks for, or the ending of the output's name. A contradiction of
 * the two, and an ending that says nothing, are refused. */
const char *output_format_choose(const arguments *line, const char *const formats[],
                                 const char *hint);

/* Refuses an output that is the input, NULL for none. */
void output_options_spare(const output_options *how, const char *input);

/* Writes rows. */
typedef void rows_writer(void *context, records *rows);

/* Opens the output, calls the writer of the rows, and finishes the output. */
void output_options_write(const output_options *how, rows_writer *write_rows, void *context);

#endif
