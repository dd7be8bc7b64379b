/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "input.h"

#include <stdlib.h>
#include <string.h>

static const char *put(char **to, const char *text)
{
    const size_t length = strlen(text) + 1;
    const char *start = memcpy(*to, text, length);
    *to += length;
    return start;
}

/* One piece of memory: the places of the cells, and their texts behind them. */
void csv_row_keep(csv_input *in, bool malformed, csv_row *row)
{
    const size_t count = csv_input_count(in);
    const char *whole = csv_input_row(in), *const *cells = csv_input_cells(in);
    size_t bytes = (count + 1) * sizeof *row->cell + strlen(whole) + 1;
    for (size_t i = 0; i < count; i++)
        bytes += strlen(cells[i]) + 1;
    *row = (csv_row){.malformed = malformed,
                     .line = csv_input_line(in),
                     .count = count,
                     .cell = memory_resized(NULL, bytes),
                     .bytes = bytes};
    char *to = (char *)(row->cell + count + 1);
    for (size_t i = 0; i < count; i++)
        row->cell[i] = put(&to, cells[i]);
    row->whole = put(&to, whole);
}

void csv_row_free(csv_row *row)
{
    free(row->cell);
    row->cell = NULL;
}
