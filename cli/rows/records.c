/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "rows.h"

bool records_go_on(const records *rows)
{
    return rows->out->error == 0;
}

void records_nothing(records *rows)
{
    (void)rows;
}

void records_name(records *rows, const char *name)
{
    if (!rows->is_begun)
        rows->how->format->begin(rows);
    rows->is_begun = true;
    rows->how->format->name(rows, name);
}

void records_end_header(records *rows)
{
    rows->how->format->end_header(rows);
}

void records_header(records *rows, size_t count, const char *const names[])
{
    for (size_t i = 0; i < count; i++)
        records_name(rows, names[i]);
    records_end_header(rows);
}

void records_columns(records *rows, const column_kind kinds[], int count)
{
    for (int i = 0; i < count; i++)
        records_name(rows, kinds[i].name);
    records_end_header(rows);
}

void columns_describe(const column_kind kinds[], int count, int width, FILE *stream)
{
    for (int i = 0; i < count; i++)
        fprintf(stream, "  %-*s %s\n", width, kinds[i].name, kinds[i].meaning);
}

void records_value(records *rows, cell value)
{
    rows->how->format->value(rows, value);
}

void records_end_row(records *rows)
{
    rows->how->format->end_row(rows);
}

void records_row(records *rows, size_t count, const cell values[])
{
    for (size_t i = 0; i < count; i++)
        records_value(rows, values[i]);
    records_end_row(rows);
}

void records_end(records *rows)
{
    if (rows->is_begun)
        rows->how->format->end(rows);
    rows->is_begun = false;
}
