/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "field.h"

#include <math.h>

int64_t grid_size(const grid *points)
{
    /* the product may not fit an integer */
    const double size = (double)points->x.count * (double)points->y.count;
    return size < 9e18 ? (int64_t)size : INT64_MAX;
}

/* The stress at the point (x, y); NAN where it is infinite. */
static tensor stress(const grid *points, double x, double y)
{
    const double at_x = x * points->loaded.length_unit, at_y = y * points->loaded.length_unit;
    double sxx, syy, txy;
    if (loaded_contact_is_kink(&points->loaded, at_x, at_y))
        return tensor_unknown();
    const int32_t status =
        rwedge_contact_stresses(points->loaded.contact, 1, &at_x, &at_y, &sxx, &syy, &txy);
    if (status != RWEDGE_OK)
        failure("x = %.17g, y = %.17g: %s", x, y, rwedge_strerror(status));
    return tensor_of(sxx, syy, txy, points->loaded.nu);
}

static void write_point(const grid *points, records *rows, double x, double y)
{
    const tensor point = stress(points, x, y);
    records_value(rows, cell_number(x));
    records_value(rows, cell_number(y));
    for (int i = 0; i < TENSOR_COUNT; i++)
        records_value(rows, cell_number(point.value[i]));
    records_end_row(rows);
    progress_step();
}

void grid_write_rows(void *of_grid, records *rows)
{
    const grid *points = of_grid;
    progress_start(rows->show_progress, grid_size(points), "points");
    records_name(rows, "x");
    records_name(rows, "y");
    for (int i = 0; i < TENSOR_COUNT; i++)
        records_name(rows, tensor_kinds[i].column);
    records_end_header(rows);
    for (int64_t j = 0; j < points->y.count; j++)
        for (int64_t i = 0; i < points->x.count && records_go_on(rows); i++)
            write_point(points, rows, range_value(&points->x, i), range_value(&points->y, j));
}

/* ---- For ParaView ---- */

static double column_x(const void *of_grid, int64_t column)
{
    return range_value(&((const grid *)of_grid)->x, column);
}

static double row_y(const void *of_grid, int64_t row)
{
    return range_value(&((const grid *)of_grid)->y, row);
}

static tensor stress_at(const void *of_grid, int64_t column, int64_t row)
{
    return stress(of_grid, column_x(of_grid, column), row_y(of_grid, row));
}

void grid_write_vtk(void *of_grid, records *rows)
{
    const grid *points = of_grid;
    vtk_points file = {.title = "rwedge field: y is the depth below the surface",
                       .is_grid = true,
                       .columns = points->x.count,
                       .rows = points->y.count,
                       .x = column_x,
                       .y = row_y,
                       .stress = stress_at,
                       .source = points};
    vtk_write(&file, rows);
}
