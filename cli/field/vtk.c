/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The legacy format of VTK, version 3.0, ASCII. It has one quantity after the other. The stresses
 * are computed anew for every quantity. So a grid of any size takes no memory; and writing the
 * digits takes longer than computing. */
#include "field.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

/* Numbers are ended by spaces, lines by the last of each row of the grid. */
static void put_number(records *rows, double value, bool last)
{
    char text[NUMBER_SIZE];
    if (isfinite(value))
        output_write(rows->out, text, number_write(value, rows->digits, '.', text));
    else
        output_text(rows->out, "nan");
    output_text(rows->out, last ? "\n" : " ");
}

static void put_axis(records *rows, const char *name, const vtk_points *points, int64_t count,
                     double (*value)(const void *, int64_t))
{
    char line[80];
    snprintf(line, sizeof line, "%s_COORDINATES %" PRId64 " double\n", name, count);
    output_text(rows->out, line);
    for (int64_t i = 0; i < count && records_go_on(rows); i++)
        put_number(rows, value(points->source, i), i == count - 1);
}

static void put_grid(records *rows, const vtk_points *points)
{
    char line[160];
    snprintf(line, sizeof line, "DATASET RECTILINEAR_GRID\nDIMENSIONS %" PRId64 " %" PRId64 " 1\n",
             points->columns, points->rows);
    output_text(rows->out, line);
    put_axis(rows, "X", points, points->columns, points->x);
    put_axis(rows, "Y", points, points->rows, points->y);
    output_text(rows->out, "Z_COORDINATES 1 double\n0\n");
}

static void put_points(records *rows, const vtk_points *points)
{
    char line[80];
    snprintf(line, sizeof line, "DATASET POLYDATA\nPOINTS %" PRId64 " double\n", points->columns);
    output_text(rows->out, line);
    for (int64_t i = 0; i < points->columns && records_go_on(rows); i++) {
        put_number(rows, points->x(points->source, i), false);
        put_number(rows, points->y(points->source, i), false);
        put_number(rows, 0, true);
    }
    snprintf(line, sizeof line, "VERTICES %" PRId64 " %" PRId64 "\n", points->columns,
             2 * points->columns);
    output_text(rows->out, line);
    for (int64_t i = 0; i < points->columns && records_go_on(rows); i++) {
        snprintf(line, sizeof line, "1 %" PRId64 "\n", i);
        output_text(rows->out, line);
    }
}

enum { NUMBERS_MOST = sizeof((vtk_points *)0)->names / sizeof(char *) };

/* A number at every point, under its name. */
static void put_numbers(records *rows, const vtk_points *points)
{
    char line[120];
    double value[NUMBERS_MOST];
    for (int n = 0; n < points->count; n++) {
        snprintf(line, sizeof line, "SCALARS %s double 1\nLOOKUP_TABLE default\n",
                 points->names[n]);
        output_text(rows->out, line);
        for (int64_t j = 0; j < points->rows; j++)
            for (int64_t i = 0; i < points->columns && records_go_on(rows); i++) {
                points->numbers(points->source, i, j, value);
                put_number(rows, value[n], i == points->columns - 1);
                progress_step();
            }
    }
}

/* Three rows of three. */
static void put_tensor(records *rows, const double v[])
{
    const double component[9] = {
        v[TENSOR_SXX], v[TENSOR_TXY], 0, v[TENSOR_TXY], v[TENSOR_SYY], 0, 0, 0, v[TENSOR_SZZ]};
    for (int i = 0; i < 9; i++)
        put_number(rows, component[i], i % 3 == 2);
    progress_step();
}

static void put_tensors(records *rows, const vtk_points *points)
{
    double value[NUMBERS_MOST];
    output_text(rows->out, "TENSORS stress double\n");
    for (int64_t j = 0; j < points->rows; j++)
        for (int64_t i = 0; i < points->columns && records_go_on(rows); i++) {
            points->numbers(points->source, i, j, value);
            put_tensor(rows, value);
        }
}

void vtk_of_stresses(vtk_points *points)
{
    points->has_tensor = true;
    for (points->count = 0; points->count < TENSOR_COUNT; points->count++)
        points->names[points->count] = tensor_kinds[points->count].name;
}

void vtk_write(void *of_points, records *rows)
{
    const vtk_points *points = of_points;
    char line[80];
    const int quantities = points->count + points->has_tensor;
    progress_start(rows->show_progress, quantities * points->columns * points->rows, "values");
    output_text(rows->out, "# vtk DataFile Version 3.0\n");
    output_text(rows->out, points->title);
    output_text(rows->out, "\nASCII\n");
    if (points->is_grid)
        put_grid(rows, points);
    else
        put_points(rows, points);
    snprintf(line, sizeof line, "POINT_DATA %" PRId64 "\n", points->columns * points->rows);
    output_text(rows->out, line);
    put_numbers(rows, points);
    if (points->has_tensor)
        put_tensors(rows, points);
}
