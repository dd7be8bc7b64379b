/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rows of a series of tests: their cells, and the results behind them. */
#include "fretting.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const column_kind contact_columns[] = {
    {"left", "left edge of the contact, as far as it reaches", "length"},
    {"right", "right edge", "length"},
    {"stick_left", "left edge of what sticks all the time", "length"},
    {"stick_right", "right edge", "length"},
    {"peak_pressure", "largest pressure after the last load", "stress"},
};
enum { CONTACT_COLUMNS = sizeof contact_columns / sizeof contact_columns[0] };

/* Ends of the columns of each criterion, behind its name. */
static const char *const ends[] = {"", "_x", "_at_length", "_load_factor"};
enum { ENDS = sizeof ends / sizeof ends[0], AT_LENGTH = 2, LOAD_FACTOR = 3 };

typedef struct {
    const series_table *table;
    const output_options *how;
} job;

/* ---- Names ---- */

static bool has_end(const series *all, int criterion, int end)
{
    if (end == AT_LENGTH)
        return !isnan(all->below.length);
    return end != LOAD_FACTOR || !isnan(material_allowable(&all->asked.given, criterion));
}

/* A result that the table has as a column would be mistaken for it. */
static void add_name(const series_table *table, const char *name, records *rows)
{
    if (header_has(&table->all.names, name))
        usage_error("%s: column %s: a result has that name; allowed: any other",
                    table->file.in->name, name);
    records_name(rows, name);
}

static void write_names(const series_table *table, records *rows)
{
    static char names[DAMAGE][ENDS][MEASURE_NAME_SIZE + 16];
    const series *all = &table->all;
    rows->mark = table->file.in->has_mark;
    for (size_t i = 0; i < all->names.count; i++)
        records_name(rows, all->names.name[i]);
    if (series_has(all, TEST_P0) && !header_has_input(&all->names, INPUT_P))
        add_name(table, "P", rows);
    for (int i = 0; i < CONTACT_COLUMNS; i++)
        add_name(table, contact_columns[i].name, rows);
    if (!isnan(all->below.length))
        add_name(table, "length", rows);
    for (int i = 0; i < DAMAGE; i++)
        for (int end = 0; end < ENDS && criterion_exists(i) && series_shows(all, i); end++) {
            snprintf(names[i][end], sizeof names[i][end], "%s%s",
                     measure_kind_of(measure_column(i, PART_VALUE))->column, ends[end]);
            if (has_end(all, i, end))
                add_name(table, names[i][end], rows);
        }
    if (series_of_lives(all) != NO_CRITERION) {
        add_name(table, "damage", rows);
        add_name(table, "life", rows);
        if (series_has(all, TEST_LIFE))
            add_name(table, "tested_over_predicted", rows);
    }
    add_name(table, "warnings", rows);
    add_name(table, "error", rows);
    records_end_header(rows);
}

/* ---- Cells ---- */

static cell life_cell(double life)
{
    return isinf(life) ? cell_text("inf") : cell_number(life);
}

/* The ratio to a run-out is a bound; that of two run-outs says nothing. */
static cell ratio_cell(const test_run *run, char text[NUMBER_SIZE])
{
    const double ratio = run->test.tested / run->results.life;
    if (run->test.is_run_out && isinf(run->results.life))
        return cell_text("");
    if (!run->test.is_run_out)
        return cell_number(ratio);
    snprintf(text, NUMBER_SIZE, ">%.6g", ratio);
    return cell_text(text);
}

static void write_criterion(const series *all, const test_results *of_test, int i, records *rows)
{
    const test_criterion *c = &of_test->criterion[i];
    const double value[ENDS] = {c->value, c->x, c->at_length, c->load_factor};
    for (int end = 0; end < ENDS; end++)
        if (has_end(all, i, end))
            records_value(rows, cell_number(value[end]));
}

static void write_results(const job *j, const test_run *run, records *rows)
{
    const series *all = &j->table->all;
    const test_results *r = &run->results;
    const double contact[CONTACT_COLUMNS] = {r->left, r->right, r->stick_left, r->stick_right,
                                             r->peak_pressure};
    char ratio[NUMBER_SIZE], doubtful[600] = "";
    if (series_has(all, TEST_P0) && !header_has_input(&all->names, INPUT_P))
        records_value(rows, cell_number(run->test.P));
    for (int i = 0; i < CONTACT_COLUMNS; i++)
        records_value(rows, cell_number(contact[i]));
    if (!isnan(all->below.length))
        records_value(rows, cell_number(all->below.length));
    for (int i = 0; i < DAMAGE; i++)
        if (criterion_exists(i) && series_shows(all, i))
            write_criterion(all, r, i, rows);
    if (series_of_lives(all) != NO_CRITERION) {
        records_value(rows, cell_number(r->damage));
        records_value(rows, life_cell(r->life));
        if (series_has(all, TEST_LIFE))
            records_value(rows, ratio_cell(run, ratio));
    }
    doubts_write(r->doubts, doubtful, sizeof doubtful);
    records_value(rows, cell_text(doubtful));
}

/* Writes as many empty cells. */
static void write_none(const job *j, records *rows)
{
    const series *all = &j->table->all;
    int count = CONTACT_COLUMNS + (isnan(all->below.length) ? 1 : 2);
    count += series_has(all, TEST_P0) && !header_has_input(&all->names, INPUT_P) ? 1 : 0;
    for (int i = 0; i < DAMAGE; i++)
        for (int end = 0; end < ENDS && criterion_exists(i) && series_shows(all, i); end++)
            count += has_end(all, i, end) ? 1 : 0;
    count += series_of_lives(all) == NO_CRITERION ? 0 : series_has(all, TEST_LIFE) ? 3 : 2;
    for (int i = 0; i < count; i++)
        records_value(rows, cell_text(""));
}

static void write_rows(void *of_job, records *rows)
{
    const job *j = of_job;
    const series_table *table = j->table;
    const header *names = &table->all.names;
    write_names(table, rows);
    for (size_t i = 0; i < table->count && records_go_on(rows); i++) {
        const test_row *row = &table->row[i];
        for (size_t k = 0; k < names->count; k++)
            records_value(rows,
                          header_cell_written(names, k, k < row->row.count ? row->row.cell[k] : "",
                                              j->how->decimal_sign));
        if (table->run[i].is_run)
            write_results(j, &table->run[i], rows);
        else
            write_none(j, rows);
        char *error = csv_row_fault(&row->row, names->count, row->why.text);
        records_value(rows, cell_text(error));
        free(error);
        records_end_row(rows);
    }
}

/* ---- All ---- */

void series_table_say(series_table *table)
{
    const char *file = table->file.in->name;
    doubts all = {0};
    char where[300];
    for (size_t i = 0; i < table->count; i++) {
        const csv_row *row = &table->row[i].row;
        if (row->count == table->all.names.count)
            header_note_unused(&table->all.names, row->cell);
        if (table->run[i].is_run)
            doubts_add(&all, table->run[i].results.doubts);
    }
    unused_say(&table->all.names, file);
    if (table->file.remark.text[0] != '\0')
        notice("%s: %s", file, table->file.remark.text);
    if (table->failed > 0)
        notice("%s: %zu of %zu tests have an error: see the column error", file, table->failed,
               table->count);
    snprintf(where, sizeof where, "%.250s, in some tests: ", file);
    doubts_say(all, where);
}

int series_table_write(series_table *table, const output_options *how)
{
    job of_table = {table, how};
    output_options_write(how, write_rows, &of_table);
    series_table_say(table);
    return table->failed > 0 && table->failed == table->count ? STATUS_FAILED : STATUS_DONE;
}
