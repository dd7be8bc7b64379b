/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "history.h"

#include "field/field.h"

#include <string.h>

const char *const point_columns[POINT_COLUMNS] = {"load", "x",  "y",  "sxx",       "syy",    "szz",
                                                  "txy",  "s1", "s2", "von_mises", "tau_max"};

/* ---- Columns that pass through ---- */

void passed_check(const load_history *loads, const char *result)
{
    for (int i = INPUT_TILT; i <= INPUT_SIGMA; i++)
        if (strcmp(result, input_kinds[i].column) == 0)
            return;
    if (header_has(&loads->names, result))
        failure("%s: column %s: a result has that name; allowed: any other", loads->name, result);
}

void passed_names(const load_history *loads, records *rows)
{
    for (size_t i = 0; i < loads->names.count; i++)
        if (!header_is_input(&loads->names, i))
            records_name(rows, loads->names.name[i]);
}

void passed_cells(const load_history *loads, size_t row, records *rows)
{
    double number;
    for (size_t i = 0; i < loads->names.count; i++) {
        const char *text = loads->row[row].cell[i];
        const bool is_number = number_survives(text, rows->how->decimal_sign, &number);
        if (!header_is_input(&loads->names, i))
            records_value(rows, is_number ? (cell){text, number} : cell_text(text));
    }
}

/* ---- Rows ---- */

typedef struct {
    const contact_history *history;
    const places *at;
    records *rows;
} point_rows;

static void write_row(const point_rows *job, size_t loads, size_t i, const tensor *stress)
{
    static const int stresses[] = {TENSOR_SXX, TENSOR_SYY, TENSOR_SZZ,       TENSOR_TXY,
                                   TENSOR_S1,  TENSOR_S2,  TENSOR_VON_MISES, TENSOR_TAU_MAX};
    const double place[] = {(double)loads, job->at->x[i], job->at->y[i]};
    passed_cells(&job->history->loads, contact_history_row(job->history, loads - 1), job->rows);
    for (int k = 0; k < POINT_COLUMNS; k++)
        records_value(job->rows, cell_number(k < 3 ? place[k] : stress->value[stresses[k - 3]]));
    records_end_row(job->rows);
}

static void write_points(void *of_job, size_t loads, const rwedge_contact *contact)
{
    const point_rows *job = of_job;
    const contact_case *setup = &job->history->setup;
    for (size_t i = 0; i < job->at->count && loads > 0 && records_go_on(job->rows); i++) {
        const tensor stress =
            point_stress(contact, &setup->shape, setup->nu1, job->at->x[i], job->at->y[i]);
        write_row(job, loads, i, &stress);
    }
}

void point_rows_write(const contact_history *history, const places *at, records *rows)
{
    contact_history again = *history;
    point_rows job = {&again, at, rows};
    again.shows_progress = rows->show_progress;
    passed_names(&history->loads, rows);
    records_header(rows, POINT_COLUMNS, point_columns);
    contact_history_go(&again, write_points, &job);
}
