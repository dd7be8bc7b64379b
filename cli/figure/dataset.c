/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "figure.h"

#include <math.h>

void dataset_add(dataset *to, data_row row)
{
    to->row = memory_for_one_more(to->row, to->count, sizeof row);
    to->row[to->count++] = row;
}

double dataset_largest(const dataset *data, int column)
{
    double most = 0;
    for (size_t i = 0; i < data->count; i++)
        if (isfinite(data->row[i].number[column]))
            most = fmax(most, data->row[i].number[column]);
    return most;
}

void dataset_write(const dataset *data, records *rows)
{
    for (int i = 0; data->column[i] != NULL; i++)
        records_name(rows, data->column[i]);
    if (data->text_column != NULL)
        records_name(rows, data->text_column);
    records_end_header(rows);
    for (size_t n = 0; n < data->count && records_go_on(rows); n++) {
        for (int i = 0; data->column[i] != NULL; i++)
            records_value(rows, cell_number(data->row[n].number[i]));
        if (data->text_column != NULL)
            records_value(rows, cell_text(data->row[n].text));
        records_end_row(rows);
    }
}
