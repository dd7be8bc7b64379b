/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fretting.h"

#include "field/field.h"

#include <stdlib.h>

/* The places that are written, and the columns. Of lines the same are written of each. */
typedef struct {
    const measured *all;
    size_t *shown, count, line;
    int column[COLUMN_COUNT], columns;
} source;

static const measured_place *place_at(const source *written, int64_t column, int64_t row)
{
    return &written->all->place[(size_t)row * written->line + written->shown[column]];
}

static double x_of(const void *written, int64_t column)
{
    return place_at(written, column, 0)->x;
}

/* The depth of a row of a grid, or of a point. */
static double y_of_row(const void *written, int64_t row)
{
    return place_at(written, 0, row)->y;
}

static double y_of_point(const void *written, int64_t point)
{
    return place_at(written, point, 0)->y;
}

static const char *name_of(const void *written, int number)
{
    return measure_kinds[((const source *)written)->column[number]].column;
}

static double value_of(const void *written, int64_t column, int64_t row, int number)
{
    return place_at(written, column, row)->at.value[((const source *)written)->column[number]];
}

static source source_of(const measured_columns *columns)
{
    const bool is_grid = columns->all->line > 0;
    source s = {.all = columns->all, .line = is_grid ? columns->all->line : columns->all->count};
    s.shown = memory_resized(NULL, (s.line + 1) * sizeof *s.shown);
    for (size_t i = 0; i < s.line; i++)
        if (columns->all->place[i].is_shown)
            s.shown[s.count++] = i;
    for (int i = 0; i < COLUMN_COUNT; i++)
        if (column_is_wanted(columns->asked, i))
            s.column[s.columns++] = i;
    return s;
}

void paraview_write(void *of_columns, records *rows)
{
    const measured_columns *columns = of_columns;
    source s = source_of(columns);
    const vtk_numbers numbers = {s.columns, name_of, value_of};
    const bool is_grid = columns->all->line > 0;
    vtk_points points = {.title = "rwedge fretting: y is the depth below the surface",
                         .is_grid = is_grid,
                         .columns = (int64_t)s.count,
                         .rows = is_grid ? (int64_t)(columns->all->count / s.line) : 1,
                         .x = x_of,
                         .y = is_grid ? y_of_row : y_of_point,
                         .numbers = &numbers,
                         .source = &s};
    vtk_write(&points, rows);
    free(s.shown);
}
