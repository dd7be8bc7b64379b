/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The options that every command with rows of results has: how they are written, and where. */
#ifndef CLI_OUTPUT_OPTIONS_H
#define CLI_OUTPUT_OPTIONS_H

#include "options/arguments.h"
#include "system/output.h"
#include "records.h"

typedef struct {
    const record_format *format; /* NULL for a command's own format */
    int digits;
    char decimal_sign, separator;
    const char *path; /* NULL for standard output */
    bool quiet;
} output_options;

/* For a command's own table, by POPT_ARG_INCLUDE_TABLE. */
extern struct poptOption output_option_table[];

/* The entries of such a table, for a command that has a format of its own. */
/* clang-format off */
#define OUTPUT_OPTIONS(formats)                                                                                        \
    {"format", '\0', POPT_ARG_STRING, NULL, OPTION_FORMAT, "How results are written (default csv)", formats},          \
    {"digits", '\0', POPT_ARG_STRING, NULL, OPTION_DIGITS,                                                             \
     "Significant digits, 1 to 17 (default 17: numbers read back to the same bits)", "N"},                             \
    {"decimal-comma", '\0', POPT_ARG_NONE, NULL, OPTION_DECIMAL_COMMA,                                                 \
     "In files 1,5 for 1.5, with ';' between the columns of csv", NULL},                                               \
    {"output", 'o', POPT_ARG_STRING, NULL, OPTION_OUTPUT,                                                              \
     "Write to FILE, whole or not at all (default: standard output)", "FILE"},                                         \
    {"quiet", 'q', POPT_ARG_NONE, NULL, OPTION_QUIET, "No progress on the terminal", NULL},                            \
    OPTION_HELP_ENTRY,                                                                                                 \
    POPT_TABLEEND
/* clang-format on */

/* STATUS_DONE, or what to leave with. */
int output_options_read(const arguments *given, output_options *how);

/* The same for a command that has a format of its own. */
int output_options_read_or(const arguments *given, const char *other_format, output_options *how);

/* Writes rows; false, with the reason said, where they cannot be computed or read. */
typedef bool rows_writer(void *context, records *rows, bool show_progress);

/* Opens the output, has the rows written, and makes them appear. Returns the exit status. */
int output_options_write(const output_options *how, rows_writer *write_rows, void *context);

#endif
