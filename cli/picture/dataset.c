/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dataset.h"

#include "text/memory.h"

void dataset_add(dataset *to, data_row row)
{
    if (to->count == to->room) {
        to->room = 2 * to->room + 256;
        to->row = memory_resized(to->row, to->room * sizeof row);
    }
    to->row[to->count++] = row;
}

size_t dataset_curve(const dataset *of, int curve, size_t *first)
{
    size_t start = 0, end;
    while (start < of->count && of->row[start].curve != curve)
        start++;
    for (end = start; end < of->count && of->row[end].curve == curve; end++)
        continue;
    *first = start;
    return end - start;
}

int dataset_curves(const dataset *of)
{
    return of->count > 0 ? of->row[of->count - 1].curve + 1 : 0;
}

bool dataset_write(void *of_dataset, records *rows, bool show_progress)
{
    (void)show_progress; /* all is computed already */
    const dataset *what = of_dataset;
    rows->format->begin(rows);
    for (int i = 0; what->column[i] != NULL; i++)
        rows->format->name(rows, what->column[i]);
    if (what->text_column != NULL)
        rows->format->name(rows, what->text_column);
    rows->format->end_header(rows);
    for (size_t n = 0; n < what->count && records_go_on(rows); n++) {
        for (int i = 0; what->column[i] != NULL; i++)
            rows->format->value(rows, what->column[i], cell_number(what->row[n].number[i]));
        if (what->text_column != NULL)
            rows->format->value(rows, what->text_column, cell_text(what->row[n].text));
        rows->format->end_row(rows);
    }
    rows->format->end(rows);
    return records_are_sound(rows);
}
