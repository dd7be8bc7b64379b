/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "layout.h"

#include "system/ahead.h"
#include "text/list.h"
#include "text/message.h"
#include "system/progress.h"

#include <rwedge.h>

int64_t plan_size(const plan *what)
{
    double size = 1; /* the product of the counts may not fit an integer */
    for (int i = 0; i < what->table->axis_count; i++)
        size *= (double)what->axis[what->table->axis[i]].count;
    return size < 9e18 ? (int64_t)size : INT64_MAX;
}

static bool not_computed(const table *which, const double value[], int32_t status)
{
    char where[160] = "";
    for (int i = 0; i < which->axis_count; i++) {
        char text[NUMBER_SIZE];
        const int variable = which->axis[i];
        number_write(value[variable], NUMBER_DIGITS, '.', text);
        list_add(where, sizeof where, ", ", "%s = %s", variables[variable].column, text);
    }
    progress_erase();
    failure("%s at %s: %s", which->name, where, rwedge_strerror(status));
    return false;
}

/* ---- What is computed ahead ---- */

typedef struct {
    double value[VARIABLE_COUNT];
    int32_t status;
    cell row[COLUMNS_MAX];
} computed;

/* The combination of index i; the last axis runs fastest. */
static void set_combination(const plan *what, int64_t i, double value[])
{
    for (int axis = what->table->axis_count - 1; axis >= 0; axis--) {
        const int variable = what->table->axis[axis];
        const range *values = &what->axis[variable];
        value[variable] = range_value(values, i % values->count);
        i /= values->count;
    }
}

/* The same for a grid: along its rows. */
static void set_grid_combination(const plan *what, int64_t i, double value[])
{
    const range *across = &what->axis[what->table->across];
    if (table_depends_on(what->table, NU))
        value[NU] = range_value(&what->axis[NU], 0); /* its one value, unless it runs across */
    value[A_OVER_B] = range_value(&what->axis[A_OVER_B], i / across->count);
    value[what->table->across] = range_value(across, i % across->count);
}

static void compute(const void *of_plan, int64_t i, void *result)
{
    const plan *what = of_plan;
    computed *to = result;
    (what->grid ? set_grid_combination : set_combination)(what, i, to->value);
    to->status = what->table->row(to->value, to->row);
}

/* The next in order; NULL, with the reason said, where it could not be computed. */
static const computed *next_computed(const plan *what, ahead *work)
{
    const computed *next = ahead_next(work);
    progress_step();
    return next->status == RWEDGE_OK || not_computed(what->table, next->value, next->status) ? next
                                                                                             : NULL;
}

/* ---- Layouts ---- */

static bool write_long(const plan *what, records *rows, ahead *work)
{
    const int64_t size = plan_size(what);
    for (int64_t i = 0; i < size && records_go_on(rows); i++) {
        const computed *one = next_computed(what, work);
        if (one == NULL)
            return false;
        for (int k = 0; k < what->table->column_count; k++)
            rows->format->value(rows, what->table->column[k], one->row[k]);
        rows->format->end_row(rows);
    }
    return records_go_on(rows);
}

static void write_long_header(const plan *what, records *rows)
{
    for (int i = 0; i < what->table->column_count; i++)
        rows->format->name(rows, what->table->column[i]);
    rows->format->end_header(rows);
}

/* The names of a grid's columns are numbers, and never rounded: they stay apart, and read back. */
static void name_across(const plan *what, const records *rows, int64_t i, char name[NUMBER_SIZE])
{
    number_write(range_value(&what->axis[what->table->across], i), NUMBER_DIGITS,
                 rows->decimal_sign, name);
}

static void write_grid_header(const plan *what, records *rows)
{
    rows->format->name(rows, what->table->column[what->quantity]);
    for (int64_t i = 0; i < what->axis[what->table->across].count && records_go_on(rows); i++) {
        char name[NUMBER_SIZE];
        name_across(what, rows, i, name);
        rows->format->name(rows, name);
    }
    rows->format->end_header(rows);
}

static bool write_grid_row(const plan *what, records *rows, double a_over_b, ahead *work)
{
    rows->format->value(rows, what->table->column[what->quantity], cell_number(a_over_b));
    for (int64_t i = 0; i < what->axis[what->table->across].count && records_go_on(rows); i++) {
        char name[NUMBER_SIZE];
        const computed *one = next_computed(what, work);
        if (one == NULL)
            return false;
        name_across(what, rows, i, name);
        rows->format->value(rows, name, one->row[what->quantity]);
    }
    rows->format->end_row(rows);
    return records_go_on(rows);
}

static bool write_grid(const plan *what, records *rows, ahead *work)
{
    for (int64_t i = 0; i < what->axis[A_OVER_B].count; i++)
        if (!write_grid_row(what, rows, range_value(&what->axis[A_OVER_B], i), work))
            return false;
    return true;
}

bool plan_write(void *plan_to_write, records *rows, bool show_progress)
{
    const plan *what = plan_to_write;
    ahead *work = ahead_start(what->threads, plan_size(what), sizeof(computed), compute, what);
    if (work == NULL)
        return false;
    progress_start(show_progress, plan_size(what), what->grid ? "values" : "rows");
    records_describe(rows, table_columns, COLUMN_KINDS);
    rows->format->begin(rows);
    if (what->grid)
        write_grid_header(what, rows);
    else
        write_long_header(what, rows);
    const bool done = (what->grid ? write_grid : write_long)(what, rows, work);
    ahead_stop(work);
    rows->format->end(rows);
    progress_erase();
    /* that, output_finish() says */
    return records_are_sound(rows) && (done || rows->out->error != 0);
}
