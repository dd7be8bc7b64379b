/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "input.h"

void table_header_read(csv_input *in, csv_row *row)
{
    const csv_event event = csv_input_next(in);
    if (event == CSV_FAILED)
        csv_input_fail(in);
    if (event != CSV_ROW)
        failure("%s: %s; needed: a header row with the names of the columns", csv_input_name(in),
                event == CSV_END ? "empty" : "misplaced quotes in the first row");
    csv_row_keep(in, false, row);
}

void table_header_say_unused(const header *names, const bool unused[HEADER_COLUMNS],
                             const char *file)
{
    char text[600] = "";
    header_write_unused(names, unused, text, sizeof text);
    if (text[0] != '\0')
        notice("%s: %s", file, text);
}
