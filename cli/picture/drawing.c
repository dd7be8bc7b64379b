/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "picture.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

/* ---- The numbers behind a picture ---- */

void dataset_add(dataset *to, data_row row)
{
    to->row = memory_for_one_more(to->row, to->count, sizeof row);
    to->row[to->count++] = row;
}

size_t dataset_curve(const dataset *data, int number, size_t *first)
{
    size_t start = 0, end;
    while (start < data->count && data->row[start].curve != number)
        start++;
    for (end = start; end < data->count && data->row[end].curve == number; end++)
        continue;
    *first = start;
    return end - start;
}

int dataset_curves(const dataset *data)
{
    return data->count > 0 ? data->row[data->count - 1].curve + 1 : 0;
}

double dataset_largest(const dataset *data, int column, double sign)
{
    double most = 0;
    for (size_t i = 0; i < data->count; i++)
        if (isfinite(data->row[i].number[column]))
            most = fmax(most, sign * data->row[i].number[column]);
    return most;
}

void dataset_write(void *of_dataset, records *rows)
{
    const dataset *data = of_dataset;
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

/* ---- The picture ---- */

curve *drawing_curve(drawing *plot, const dataset *from, int number, int x, int y)
{
    curve *next = &plot->curve[plot->curve_count];
    *next = (curve){.from = from, .x = x, .y = y, .width = 1};
    next->count = dataset_curve(from, number, &next->first);
    if (plot->curve_count < DRAWING_CURVES_MAX - 1)
        plot->curve_count++;
    return next;
}

curve *drawing_bar(drawing *plot, double from, double to, double top, double bottom)
{
    const double x[] = {from, to, to, from, from}, y[] = {top, top, bottom, bottom, top};
    const int number = dataset_curves(&plot->outlines);
    for (int i = 0; i < 5; i++)
        dataset_add(&plot->outlines, (data_row){.curve = number, .number = {x[i], y[i]}});
    return drawing_curve(plot, &plot->outlines, number, 0, 1);
}

label *drawing_label(drawing *plot, double x, double y, const char *format, ...)
{
    label *next = &plot->label[plot->label_count];
    *next = (label){.x = x, .y = y};
    va_list values;
    va_start(values, format);
    vsnprintf(next->text, sizeof next->text, format, values);
    va_end(values);
    if (plot->label_count < DRAWING_LABELS_MAX - 1)
        plot->label_count++;
    return next;
}

double drawing_tic(double span)
{
    static const double MOST = 6.5;
    const double decade = pow(10, floor(log10(span / MOST))), times = span / MOST / decade;
    return decade * (times <= 1 ? 1 : times <= 2 ? 2 : times <= 5 ? 5 : 10);
}

axis drawing_axis(double largest, const char *text)
{
    axis from_0 = {.tic = drawing_tic(largest > 0 ? largest : 1)};
    const double half = 0.5 * from_0.tic;
    from_0.to = largest > 0 ? half * ceil(largest / half - 1e-9) : 1;
    snprintf(from_0.text, sizeof from_0.text, "%s", text);
    return from_0;
}

void drawing_number(double value, int digits, char text[NUMBER_SIZE])
{
    static const char *const sixths[] = {"0", "1/6", "1/3", "1/2", "2/3", "5/6", "1"};
    const double nearest = floor(6 * value + 0.5);
    if (nearest >= 1 && nearest <= 5 && nearest != 3 && fabs(6 * value - nearest) < 1e-9)
        snprintf(text, NUMBER_SIZE, "%s", sixths[(int)nearest]);
    else
        number_write(value, digits, '.', text);
}
