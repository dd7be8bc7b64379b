/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The legacy format of VTK, version 3.0, ASCII, RECTILINEAR_GRID. It has one quantity after the
 * other. The stresses are computed anew for every quantity. So a grid of any size takes no memory;
 * and writing the digits takes longer than computing. */
#include "vtk.h"

#include "system/progress.h"

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

static void put_axis(records *rows, const char *name, const range *values)
{
    char line[80];
    snprintf(line, sizeof line, "%s_COORDINATES %" PRId64 " double\n", name, values->count);
    output_text(rows->out, line);
    for (int64_t i = 0; i < values->count && records_go_on(rows); i++)
        put_number(rows, range_value(values, i), i == values->count - 1);
}

static void put_grid(records *rows, const grid *what)
{
    char line[160];
    snprintf(line, sizeof line, "DATASET RECTILINEAR_GRID\nDIMENSIONS %" PRId64 " %" PRId64 " 1\n",
             what->x.count, what->y.count);
    output_text(
        rows->out,
        "# vtk DataFile Version 3.0\nrwedge field: y is the depth below the surface\nASCII\n");
    output_text(rows->out, line);
    put_axis(rows, "X", &what->x);
    put_axis(rows, "Y", &what->y);
    output_text(rows->out, "Z_COORDINATES 1 double\n0\n");
    snprintf(line, sizeof line, "POINT_DATA %" PRId64 "\n", grid_size(what));
    output_text(rows->out, line);
}

static bool put_quantity(records *rows, const grid *what, int which)
{
    char line[80];
    snprintf(line, sizeof line, "SCALARS %s double 1\nLOOKUP_TABLE default\n",
             grid_quantities[which]);
    output_text(rows->out, line);
    for (int64_t j = 0; j < what->y.count; j++)
        for (int64_t i = 0; i < what->x.count; i++) {
            double quantity[GRID_COUNT];
            if (!records_go_on(rows) ||
                !grid_compute(what, range_value(&what->x, i), range_value(&what->y, j), quantity))
                return false;
            put_number(rows, quantity[which], i == what->x.count - 1);
            progress_step();
        }
    return true;
}

bool vtk_write(void *of_grid, records *rows, bool show_progress)
{
    const grid *what = of_grid;
    bool going = true;
    progress_start(show_progress, GRID_COUNT * grid_size(what), "values");
    put_grid(rows, what);
    for (int i = 0; i < GRID_COUNT && going; i++)
        going = put_quantity(rows, what, i);
    progress_erase();
    return going || rows->out->error != 0;
}
