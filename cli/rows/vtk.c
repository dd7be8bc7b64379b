/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The legacy format of VTK, version 3.0, ASCII, for ParaView. It has one quantity after the other,
 * and so the rows are kept to the end. The first two columns are the places; the others are
 * scalars, and where all of a plane stress are among them, a tensor too. */
#include "rows.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void keep_name(records *rows, const char *name)
{
    rows->name = memory_for_one_more(rows->name, rows->names, sizeof *rows->name);
    rows->name[rows->names++] = name;
}

static void keep_value(records *rows, cell value)
{
    rows->kept = memory_for_one_more(rows->kept, rows->kept_count, sizeof *rows->kept);
    rows->kept[rows->kept_count++] = value.number;
}

/* ---- The file ---- */

static double number_at(const records *rows, size_t row, size_t column)
{
    return rows->kept[row * rows->names + column];
}

static size_t count_of(const records *rows)
{
    return rows->kept_count / rows->names;
}

/* Numbers are ended by spaces, lines by the last of each row of the grid. */
static void put_number(records *rows, double value, bool last)
{
    char text[NUMBER_SIZE];
    if (isfinite(value))
        output_write(rows->out, text, number_write(value, rows->how->digits, '.', text));
    else
        output_text(rows->out, "nan");
    output_text(rows->out, last ? "\n" : " ");
}

static void put_axis(records *rows, char axis, size_t count, size_t column, size_t stride)
{
    output_print(rows->out, "%c_COORDINATES %zu double\n", axis, count);
    for (size_t i = 0; i < count && records_go_on(rows); i++)
        put_number(rows, number_at(rows, i * stride, column), i == count - 1);
}

static void put_grid(records *rows)
{
    const size_t depths = count_of(rows) / rows->across;
    output_print(rows->out, "DATASET RECTILINEAR_GRID\nDIMENSIONS %zu %zu 1\n", rows->across,
                 depths);
    put_axis(rows, 'X', rows->across, 0, 1);
    put_axis(rows, 'Y', depths, 1, rows->across);
    output_text(rows->out, "Z_COORDINATES 1 double\n0\n");
}

static void put_points(records *rows)
{
    const size_t count = count_of(rows);
    output_print(rows->out, "DATASET POLYDATA\nPOINTS %zu double\n", count);
    for (size_t i = 0; i < count && records_go_on(rows); i++) {
        put_number(rows, number_at(rows, i, 0), false);
        put_number(rows, number_at(rows, i, 1), false);
        put_number(rows, 0, true);
    }
    output_print(rows->out, "VERTICES %zu %zu\n", count, 2 * count);
    for (size_t i = 0; i < count && records_go_on(rows); i++)
        output_print(rows->out, "1 %zu\n", i);
}

/* Three rows of three for each point; NULL is 0. */
static void put_tensors(records *rows)
{
    static const char *const component[9] = {"sxx", "txy", NULL, "txy", "syy",
                                             NULL,  NULL,  NULL, "szz"};
    size_t column[9];
    for (int k = 0; k < 9; k++) {
        column[k] = 0;
        while (component[k] != NULL && column[k] < rows->names &&
               strcmp(rows->name[column[k]], component[k]) != 0)
            column[k]++;
        if (column[k] == rows->names)
            return;
    }
    output_text(rows->out, "TENSORS stress double\n");
    for (size_t i = 0; i < count_of(rows) && records_go_on(rows); i++)
        for (int k = 0; k < 9; k++)
            put_number(rows, component[k] != NULL ? number_at(rows, i, column[k]) : 0, k % 3 == 2);
}

/* Scalars are numbers at every point, under their name. */
static void write_file(records *rows)
{
    const size_t count = count_of(rows), across = rows->across > 0 ? rows->across : count;
    output_print(rows->out, "# vtk DataFile Version 3.0\n%s\nASCII\n", rows->title);
    (rows->across > 0 ? put_grid : put_points)(rows);
    output_print(rows->out, "POINT_DATA %zu\n", count);
    for (size_t column = 2; column < rows->names; column++) {
        output_print(rows->out, "SCALARS %s double 1\nLOOKUP_TABLE default\n", rows->name[column]);
        for (size_t i = 0; i < count && records_go_on(rows); i++)
            put_number(rows, number_at(rows, i, column), (i + 1) % across == 0);
    }
    put_tensors(rows);
    free(rows->kept);
    free(rows->name);
}

const record_format vtk_format = {records_nothing, keep_name,       records_nothing,
                                  keep_value,      records_nothing, write_file};
