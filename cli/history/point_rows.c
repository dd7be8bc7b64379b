/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "history.h"

#include "field/field.h"

#include <string.h>

const char *const point_columns[POINT_COLUMNS] = {"load", "x",  "y",  "sxx",       "syy",    "szz",
                                                  "txy",  "s1", "s2", "von_mises", "tau_max"};

/* ---- Columns that pass through ---- */

void passed_check(const load_history *loads, const char *result)
{
    for (int i = INPUT_P; i <= INPUT_SIGMA; i++)
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

tensor point_rows_stress(const point_rows *points, const rwedge_contact *contact, size_t i)
{
    const contact_case *setup = &points->history->setup;
    return point_stress(contact, &setup->shape, setup->nu1, points->at->x[i], points->at->y[i]);
}

void point_rows_write(const point_rows *points, records *rows)
{
    static const int stresses[] = {TENSOR_SXX, TENSOR_SYY, TENSOR_SZZ,       TENSOR_TXY,
                                   TENSOR_S1,  TENSOR_S2,  TENSOR_VON_MISES, TENSOR_TAU_MAX};
    rwedge_contact *contact = contact_history_begin(points->history);
    passed_names(&points->history->loads, rows);
    records_header(rows, POINT_COLUMNS, point_columns);
    for (size_t step = 0; step < points->history->steps && records_go_on(rows); step++) {
        contact_history_go_on(points->history, step, contact);
        for (size_t i = 0; i < points->at->count && records_go_on(rows); i++) {
            const tensor at = point_rows_stress(points, contact, i);
            const double value[] = {(double)(step + 1), points->at->x[i], points->at->y[i]};
            passed_cells(&points->history->loads, contact_history_row(points->history, step), rows);
            for (int k = 0; k < POINT_COLUMNS; k++)
                records_value(rows, cell_number(k < 3 ? value[k] : at.value[stresses[k - 3]]));
            records_end_row(rows);
            progress_step();
        }
    }
}
