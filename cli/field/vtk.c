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

/* A number at every point, under its name. */
static void put_numbers(records *rows, const vtk_points *points, const void *source,
                        const vtk_numbers *numbers)
{
    char line[120];
    for (int n = 0; n < numbers->count; n++) {
        snprintf(line, sizeof line, "SCALARS %s double 1\nLOOKUP_TABLE default\n",
                 numbers->name(source, n));
        output_text(rows->out, line);
        for (int64_t j = 0; j < points->rows; j++)
            for (int64_t i = 0; i < points->columns && records_go_on(rows); i++) {
                put_number(rows, numbers->value(source, i, j, n), i == points->columns - 1);
                progress_step();
            }
    }
}

/* ---- Stresses ---- */

static const char *stress_name(const void *of_points, int n)
{
    (void)of_points;
    return tensor_kinds[n].column;
}

static double stress_value(const void *of_points, int64_t column, int64_t row, int n)
{
    const vtk_points *points = of_points;
    return points->stress(points->source, column, row).value[n];
}

/* Three rows of three. */
static void put_tensor(records *rows, tensor at)
{
    const double sxx = at.value[TENSOR_SXX], syy = at.value[TENSOR_SYY], szz = at.value[TENSOR_SZZ],
                 txy = at.value[TENSOR_TXY];
    const double component[9] = {sxx, txy, 0, txy, syy, 0, 0, 0, szz};
    for (int i = 0; i < 9; i++)
        put_number(rows, component[i], i % 3 == 2);
}

static void put_stresses(records *rows, const vtk_points *points)
{
    const vtk_numbers numbers = {TENSOR_COUNT, stress_name, stress_value};
    put_numbers(rows, points, points, &numbers);
    output_text(rows->out, "TENSORS stress double\n");
    for (int64_t j = 0; j < points->rows; j++)
        for (int64_t i = 0; i < points->columns && records_go_on(rows); i++) {
            put_tensor(rows, points->stress(points->source, i, j));
            progress_step();
        }
}

void vtk_write(void *of_points, records *rows)
{
    const vtk_points *points = of_points;
    char line[80];
    const int quantities = points->numbers != NULL ? points->numbers->count : TENSOR_COUNT + 1;
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
    if (points->numbers != NULL)
        put_numbers(rows, points, points->source, points->numbers);
    else
        put_stresses(rows, points);
}
