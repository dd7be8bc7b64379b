/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The legacy format of VTK, version 3.0, ASCII. It has one quantity after the other. */
#include "field.h"

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

static void put_axis(records *rows, const char *name, size_t count, const double value[],
                     size_t stride)
{
    char line[80];
    snprintf(line, sizeof line, "%s_COORDINATES %zu double\n", name, count);
    output_text(rows->out, line);
    for (size_t i = 0; i < count && records_go_on(rows); i++)
        put_number(rows, value[i * stride], i == count - 1);
}

static void put_grid(records *rows, const vtk_points *points)
{
    char line[160];
    const size_t columns = points->columns, depths = points->count / columns;
    snprintf(line, sizeof line, "DATASET RECTILINEAR_GRID\nDIMENSIONS %zu %zu 1\n", columns,
             depths);
    output_text(rows->out, line);
    put_axis(rows, "X", columns, points->x, 1);
    put_axis(rows, "Y", depths, points->y, columns);
    output_text(rows->out, "Z_COORDINATES 1 double\n0\n");
}

static void put_points(records *rows, const vtk_points *points)
{
    char line[80];
    snprintf(line, sizeof line, "DATASET POLYDATA\nPOINTS %zu double\n", points->count);
    output_text(rows->out, line);
    for (size_t i = 0; i < points->count && records_go_on(rows); i++) {
        put_number(rows, points->x[i], false);
        put_number(rows, points->y[i], false);
        put_number(rows, 0, true);
    }
    snprintf(line, sizeof line, "VERTICES %zu %zu\n", points->count, 2 * points->count);
    output_text(rows->out, line);
    for (size_t i = 0; i < points->count && records_go_on(rows); i++) {
        snprintf(line, sizeof line, "1 %zu\n", i);
        output_text(rows->out, line);
    }
}

static const double *numbers_of(const vtk_points *points, size_t i)
{
    return points->value + i * (size_t)points->numbers;
}

/* A number at every point, under its name. */
static void put_numbers(records *rows, const vtk_points *points)
{
    char line[120];
    const size_t columns = points->columns > 0 ? points->columns : points->count;
    for (int n = 0; n < points->numbers; n++) {
        snprintf(line, sizeof line, "SCALARS %s double 1\nLOOKUP_TABLE default\n",
                 points->names[n]);
        output_text(rows->out, line);
        for (size_t i = 0; i < points->count && records_go_on(rows); i++) {
            put_number(rows, numbers_of(points, i)[n], (i + 1) % columns == 0);
            progress_step();
        }
    }
}

/* Three rows of three for each point. */
static void put_tensors(records *rows, const vtk_points *points)
{
    output_text(rows->out, "TENSORS stress double\n");
    for (size_t i = 0; i < points->count && records_go_on(rows); i++) {
        const double *v = numbers_of(points, i);
        const double component[9] = {
            v[TENSOR_SXX], v[TENSOR_TXY], 0, v[TENSOR_TXY], v[TENSOR_SYY], 0, 0, 0, v[TENSOR_SZZ]};
        for (int k = 0; k < 9; k++)
            put_number(rows, component[k], k % 3 == 2);
        progress_step();
    }
}

void vtk_of_stresses(vtk_points *points)
{
    points->has_tensor = true;
    for (points->numbers = 0; points->numbers < TENSOR_COUNT; points->numbers++)
        points->names[points->numbers] = tensor_kinds[points->numbers].name;
}

void vtk_write(void *of_points, records *rows)
{
    const vtk_points *points = of_points;
    char line[80];
    const size_t quantities = (size_t)points->numbers + points->has_tensor;
    progress_start(rows->show_progress, (int64_t)(quantities * points->count), "values");
    output_text(rows->out, "# vtk DataFile Version 3.0\n");
    output_text(rows->out, points->title);
    output_text(rows->out, "\nASCII\n");
    if (points->columns > 0)
        put_grid(rows, points);
    else
        put_points(rows, points);
    snprintf(line, sizeof line, "POINT_DATA %zu\n", points->count);
    output_text(rows->out, line);
    put_numbers(rows, points);
    if (points->has_tensor)
        put_tensors(rows, points);
}
