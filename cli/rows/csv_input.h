/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows of a CSV file (RFC 4180, UTF-8), one at a time: memory holds one row, however many there
 * are. */
#ifndef CLI_CSV_INPUT_H
#define CLI_CSV_INPUT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A longer row, or one with more cells, is no table that this tool could mean. */
enum { CSV_ROW_BYTES = 1 << 20, CSV_ROW_CELLS = 1000 };

typedef struct csv_input csv_input;

typedef enum {
    CSV_ROW,
    /* quotes are out of place: a row of the cells before that; the next line starts afresh */
    CSV_MALFORMED,
    CSV_END,
    CSV_FAILED /* it cannot be read on, and the reason has been said */
} csv_event;

/* Opens a file, or standard input where path is "-". NULL, with the reason said, where it cannot
 * be read. */
csv_input *csv_input_open(const char *path, char separator);

/* Reads the next row. Blank lines are no rows. */
csv_event csv_input_next(csv_input *in);

/* The row that was read: its cells live until the next is. */
size_t csv_input_count(const csv_input *in);
const char *csv_input_cell(const csv_input *in, size_t i);

/* The line of the file on which it starts, from 1, and the file's name in messages. */
int64_t csv_input_line(const csv_input *in);
const char *csv_input_name(const csv_input *in);

void csv_input_close(csv_input *in);

#endif
