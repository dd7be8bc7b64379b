/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A row of a CSV file that stays while others are read. */
#ifndef CLI_CSV_ROW_H
#define CLI_CSV_ROW_H

#include "csv_input.h"

typedef struct {
    bool malformed;
    int64_t line; /* of the file, on which it starts */
    size_t count;
    const char **cell;
    const char *whole; /* as it stands in the file */
    size_t bytes;      /* that it takes */
} csv_row;

/* Keeps the row that was read last. */
void csv_row_keep(csv_input *in, bool malformed, csv_row *row);
void csv_row_free(csv_row *row);

#endif
