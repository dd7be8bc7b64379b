/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows of a CSV file (RFC 4180), one at a time: memory holds one row, however many there are. */
#ifndef CLI_CSV_INPUT_H
#define CLI_CSV_INPUT_H

#include "text/message.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A longer row, or one with more cells, does not belong to a table for this tool. */
enum { CSV_ROW_BYTES = 1 << 20, CSV_ROW_CELLS = 1000 };

typedef struct csv_input csv_input;

typedef enum {
    CSV_ROW,
    CSV_MALFORMED, /* quotes are misplaced: the cells before that; the next line starts afresh */
    CSV_END,
    CSV_FAILED /* it cannot be read on: see the problem */
} csv_event;

/* Opens a file, or standard input where path is "-". Tabs separate where the name ends in .tsv, or
 * where the first line has tabs but no separator; another separator where the first line names it,
 * as "sep=;". The encoding is that of text_input. Ends the command where it cannot be read. */
csv_input *csv_input_open(const char *path, char separator, const char *encoding);

/* The same, but where it cannot be read only the problem says so, and there is no next row. */
csv_input *csv_input_try(const char *path, char separator, const char *encoding);

/* Reads the next row. Blank lines, and rows of empty cells, are no rows. A quote that is not closed
 * ends the file: what it has taken may have been rows. */
csv_event csv_input_next(csv_input *in);

/* Whether the row has a quote over several lines. */
bool csv_input_spans_lines(csv_input *in);

/* Ends the file at this row, for the reason. */
csv_event csv_input_stop(csv_input *in, const char *why);

/* Why it cannot be read on, with the name and the line. */
const char *csv_input_problem(const csv_input *in);

/* Ends the command with this problem, or because the row that was read last is malformed. */
NO_RETURN void csv_input_fail(const csv_input *in);

/* The row that was read: its cells live until the next is. */
size_t csv_input_count(const csv_input *in);
const char *const *csv_input_cells(const csv_input *in);

/* The whole row as it stands in the file, quotes and all. */
const char *csv_input_row(csv_input *in);

/* The line of the file on which it starts, from 1, and the file's name in messages. */
int64_t csv_input_line(const csv_input *in);
const char *csv_input_name(const csv_input *in);

/* What stands between the cells: a comma, a semicolon, a tab, or what the file names. */
char csv_input_separator(csv_input *in);

/* Whether the file begins with the mark of Unicode. */
bool csv_input_has_mark(const csv_input *in);

/* The option that names the encoding, for a command's own table. It is checked by
 * text_input_check(). */
#define ENCODING_OPTION                                                                            \
    "encoding", '\0', POPT_ARG_STRING, NULL, OPTION_ENCODING,                                      \
        "Encoding of the file that is read, such as windows-1252 (default utf-8)", "NAME"

void csv_input_close(csv_input *in);

#endif
