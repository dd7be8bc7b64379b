/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grid.h"

#include "text/message.h"
#include "system/progress.h"

#include <math.h>

const char *const grid_quantities[GRID_COUNT] = {[GRID_SXX] = "sxx",
                                                 [GRID_SYY] = "syy",
                                                 [GRID_TXY] = "txy",
                                                 [GRID_VON_MISES] = "von_mises",
                                                 [GRID_S1] = "s1"};

int64_t grid_size(const grid *what)
{
    /* the product may not fit an integer */
    const double size = (double)what->x.count * (double)what->y.count;
    return size < 9e18 ? (int64_t)size : INT64_MAX;
}

static void derive(double nu, double quantity[GRID_COUNT])
{
    const double sxx = quantity[GRID_SXX], syy = quantity[GRID_SYY], txy = quantity[GRID_TXY];
    double s2, angle;
    quantity[GRID_VON_MISES] = rwedge_von_mises(sxx, syy, txy, nu);
    rwedge_principal_stresses(sxx, syy, txy, &quantity[GRID_S1], &s2, &angle);
}

bool grid_compute(const grid *what, double x, double y, double quantity[GRID_COUNT])
{
    const double at_x = x * what->state.length_unit, at_y = y * what->state.length_unit;
    for (int i = 0; i < GRID_COUNT; i++)
        quantity[i] = NAN;
    if (state_is_apex(&what->state, at_x, at_y))
        return true;
    const int32_t status =
        rwedge_contact_stresses(what->state.contact, 1, &at_x, &at_y, &quantity[GRID_SXX],
                                &quantity[GRID_SYY], &quantity[GRID_TXY]);
    if (status != RWEDGE_OK) {
        failure("x = %.17g, y = %.17g: %s", x, y, rwedge_strerror(status));
        return false;
    }
    derive(what->state.nu, quantity);
    return true;
}

static bool write_point(const grid *what, records *rows, double x, double y)
{
    double quantity[GRID_COUNT];
    if (!grid_compute(what, x, y, quantity))
        return false;
    rows->format->value(rows, "x", cell_number(x));
    rows->format->value(rows, "y", cell_number(y));
    for (int i = 0; i < GRID_COUNT; i++)
        rows->format->value(rows, grid_quantities[i], cell_number(quantity[i]));
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
    for (int i = 0; i < GRID_COUNT; i++)
        rows->format->name(rows, grid_quantities[i]);
    rows->format->end_header(rows);
    for (int64_t j = 0; j < what->y.count && going; j++)
        for (int64_t i = 0; i < what->x.count && going; i++)
            going = write_point(what, rows, range_value(&what->x, i), range_value(&what->y, j));
    rows->format->end(rows);
    progress_erase();
    return records_are_sound(rows) && (going || rows->out->error != 0);
}
