/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grid.h"

#include "vtk.h"

#include "text/message.h"
#include "system/progress.h"

#include <math.h>

int64_t grid_size(const grid *what)
{
    /* the product may not fit an integer */
    const double size = (double)what->x.count * (double)what->y.count;
    return size < 9e18 ? (int64_t)size : INT64_MAX;
}

bool grid_compute(const grid *what, double x, double y, tensor *found)
{
    const double at_x = x * what->state.length_unit, at_y = y * what->state.length_unit;
    double sxx, syy, txy;
    *found = tensor_unknown();
    if (state_is_apex(&what->state, at_x, at_y))
        return true;
    const int32_t status =
        rwedge_contact_stresses(what->state.contact, 1, &at_x, &at_y, &sxx, &syy, &txy);
    if (status != RWEDGE_OK) {
        failure("x = %.17g, y = %.17g: %s", x, y, rwedge_strerror(status));
        return false;
    }
    *found = tensor_of(sxx, syy, txy, what->state.nu);
    return true;
}

static bool write_point(const grid *what, records *rows, double x, double y)
{
    tensor found;
    if (!grid_compute(what, x, y, &found))
        return false;
    rows->format->value(rows, "x", cell_number(x));
    rows->format->value(rows, "y", cell_number(y));
    for (int i = 0; i < TENSOR_COUNT; i++)
        rows->format->value(rows, tensor_names[i], cell_number(found.value[i]));
    rows->format->end_row(rows);
    progress_step();
    return records_go_on(rows);
}

bool grid_write_rows(void *of_grid, records *rows, bool show_progress)
{
    const grid *what = of_grid;
    bool going = true;
    progress_start(show_progress, grid_size(what), "points");
    rows->format->begin(rows);
    rows->format->name(rows, "x");
    rows->format->name(rows, "y");
    for (int i = 0; i < TENSOR_COUNT; i++)
        rows->format->name(rows, tensor_names[i]);
    rows->format->end_header(rows);
    for (int64_t j = 0; j < what->y.count && going; j++)
        for (int64_t i = 0; i < what->x.count && going; i++)
            going = write_point(what, rows, range_value(&what->x, i), range_value(&what->y, j));
    rows->format->end(rows);
    progress_erase();
    return records_are_sound(rows) && (going || rows->out->error != 0);
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

static bool stress_at(const void *of_grid, int64_t column, int64_t row, tensor *found)
{
    return grid_compute(of_grid, column_x(of_grid, column), row_y(of_grid, row), found);
}

bool grid_write_vtk(void *of_grid, records *rows, bool show_progress)
{
    const grid *what = of_grid;
    vtk_points points = {.title = "rwedge field: y is the depth below the surface",
                         .is_grid = true,
                         .columns = what->x.count,
                         .rows = what->y.count,
                         .x = column_x,
                         .y = row_y,
                         .stress = stress_at,
                         .of = what};
    return vtk_write(&points, rows, show_progress);
}
