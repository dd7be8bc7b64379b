/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "table.h"

#include "text/text.h"

#include <rwedge.h>

int64_t plan_size(const plan *job)
{
    double size = 1; /* the product of the counts may not fit an integer */
    for (int i = 0; i < job->table->axis_count; i++)
        size *= (double)job->axis[job->table->axis[i]].count;
    return size < 9e18 ? (int64_t)size : INT64_MAX;
}

static void refuse(const table *chosen, const double value[], int32_t status)
{
    char where[160] = "";
    for (int i = 0; i < chosen->axis_count; i++) {
        char text[NUMBER_SIZE];
        const int variable = chosen->axis[i];
        number_write(value[variable], NUMBER_DIGITS, '.', text);
        list_add(where, sizeof where, ", ", "%s = %s", variables[variable].column, text);
    }
    progress_erase();
    failure("%s at %s: %s", chosen->name, where, rwedge_strerror(status));
}

/* ---- What is computed ahead ---- */

typedef struct {
    double value[VARIABLE_COUNT];
    int32_t status;
    cell row[COLUMNS_MAX];
} computed;

/* The combination of index i; the last axis runs fastest. */
static void set_combination(const plan *job, int64_t i, double value[])
{
    for (int axis = job->table->axis_count - 1; axis >= 0; axis--) {
        const int variable = job->table->axis[axis];
        const range *values = &job->axis[variable];
        value[variable] = range_value(values, i % values->count);
        i /= values->count;
    }
}

/* The same for a grid: along its rows. */
static void set_grid_combination(const plan *job, int64_t i, double value[])
{
    const range *across = &job->axis[job->table->across];
    if (table_depends_on(job->table, NU))
        value[NU] = range_value(&job->axis[NU], 0); /* its one value, unless it runs across */
    value[A_OVER_B] = range_value(&job->axis[A_OVER_B], i / across->count);
    value[job->table->across] = range_value(across, i % across->count);
}

static void compute(const void *of_plan, int64_t i, void *result)
{
    const plan *job = of_plan;
    computed *to = result;
    (job->grid ? set_grid_combination : set_combination)(job, i, to->value);
    to->status = job->table->row(to->value, to->row);
}

/* The next row in order; ends the command where it could not be computed. */
static const cell *next_row(const plan *job, ahead *work)
{
    const computed *next = ahead_next(work);
    progress_step();
    if (next->status != RWEDGE_OK)
        refuse(job->table, next->value, next->status);
    return next->row;
}

/* ---- Layouts ---- */

static void write_long(const plan *job, records *rows, ahead *work)
{
    const int64_t size = plan_size(job);
    for (int64_t i = 0; i < size && records_go_on(rows); i++) {
        const cell *row = next_row(job, work);
        records_row(rows, (size_t)job->table->column_count, row);
    }
}

static void write_long_header(const plan *job, records *rows)
{
    records_header(rows, (size_t)job->table->column_count, job->table->column);
}

/* The names of a grid's columns are numbers, and never rounded: they stay apart, and read back. */
static void name_across(const plan *job, const records *rows, int64_t i, char name[NUMBER_SIZE])
{
    number_write(range_value(&job->axis[job->table->across], i), NUMBER_DIGITS, rows->decimal_sign,
                 name);
}

static void write_grid_header(const plan *job, records *rows)
{
    records_name(rows, job->table->column[job->quantity]);
    for (int64_t i = 0; i < job->axis[job->table->across].count && records_go_on(rows); i++) {
        char name[NUMBER_SIZE];
        name_across(job, rows, i, name);
        records_name(rows, name);
    }
    records_end_header(rows);
}

static void write_grid_row(const plan *job, records *rows, double a_over_b, ahead *work)
{
    records_value(rows, cell_number(a_over_b));
    for (int64_t i = 0; i < job->axis[job->table->across].count && records_go_on(rows); i++) {
        char name[NUMBER_SIZE];
        name_across(job, rows, i, name);
        records_value(rows, next_row(job, work)[job->quantity]);
    }
    records_end_row(rows);
}

static void write_grid(const plan *job, records *rows, ahead *work)
{
    for (int64_t i = 0; i < job->axis[A_OVER_B].count && records_go_on(rows); i++)
        write_grid_row(job, rows, range_value(&job->axis[A_OVER_B], i), work);
}

void plan_write(void *plan_to_write, records *rows)
{
    const plan *job = plan_to_write;
    ahead *work = ahead_start(job->threads, plan_size(job), sizeof(computed), compute, job);
    progress_start(rows->show_progress, plan_size(job), job->grid ? "values" : "rows");
    records_describe(rows, table_columns, COLUMN_KINDS);
    (job->grid ? write_grid_header : write_long_header)(job, rows);
    (job->grid ? write_grid : write_long)(job, rows, work);
    ahead_stop(work);
}
