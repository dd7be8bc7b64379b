/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Inputs left, results right, named as "solve --input" names its columns; then the working cells,
 * which are hidden. A row refers to itself and to the tables alone: it may be copied. */
#include "batch_sheet.h"

#include "workbook/case/formula.h"
#include "workbook/case/shown.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { HEADER_ROW, FIRST_ROW, CASE_COLUMN = 0, CELLS_COLUMN };

/* Results and working cells follow the inputs as they are numbered. */
static int column_of(int cell)
{
    return CELLS_COLUMN + cell;
}

static void write_header(xlsx *book)
{
    xlsx_text(book, HEADER_ROW, CASE_COLUMN, "case", XLSX_HEADER);
    for (int cell = 0; cell < case_cell_count; cell++)
        xlsx_text(book, HEADER_ROW, column_of(cell),
                  cell < RESULTS_END ? case_cells[cell].column : case_cells[cell].name,
                  XLSX_HEADER);
}

/* A name is not broken. */
static void set_widths(xlsx *book)
{
    xlsx_width(book, CASE_COLUMN, CASE_COLUMN, 24);
    for (int cell = 0; cell < RESULTS_END; cell++)
        xlsx_width(book, column_of(cell), column_of(cell),
                   fmax(12, (double)strlen(case_cells[cell].column) + 2));
    xlsx_width(book, column_of(CELL_WARNINGS), column_of(CELL_ERROR), 40);
}

static void write_row(xlsx *book, int row, const case_values *values)
{
    for (int cell = 0; cell < INPUT_CELLS; cell++)
        xlsx_number(book, row, column_of(cell), values->number[cell], XLSX_INPUT);
    for (int cell = INPUT_CELLS; cell < case_cell_count; cell++)
        cell_in_row(book, row, cell, column_of, values);
}

/* E1, nu1, E2, nu2, theta, theta_deg, a, radius, P, Q, f, k, yield_stress */
static const struct {
    const char *name;
    double input[INPUT_CELLS];
} examples[] = {
    {"steel on steel", {210000, 0.3, NAN, NAN, NAN, 2, NAN, 10, 300, 40, 0.3, NAN, 900}},
    {"a sharper one", {210000, 0.3, NAN, NAN, NAN, 2, NAN, 2, 70, 15, 0.3, NAN, 900}},
    {"steel on aluminium", {72000, 0.33, 210000, 0.3, 0.02, NAN, 0.3, NAN, 10, NAN, 0, 300, NAN}},
};
enum { EXAMPLES = sizeof examples / sizeof examples[0] };

/* What is typed or pasted is checked: typing at once, pasting by the column "error". */
static void check_typing(xlsx *book)
{
    for (int cell = 0; cell < INPUT_CELLS; cell++) {
        char named[FORMULA_SIZE], formula[FORMULA_SIZE], message[FORMULA_SIZE];
        const xlsx_rule rule = {
            formula_in_row(input_check(cell, named), FIRST_ROW, column_of, formula),
            case_cells[cell].column, case_cells[cell].label, input_message(cell, message)};
        xlsx_validate(book, (xlsx_area){FIRST_ROW, column_of(cell), BATCH_ROWS, 1}, &rule);
    }
}

/* A row with an error is red, one with warnings amber. */
static void colour_rows(xlsx *book)
{
    const xlsx_area all = {FIRST_ROW, CASE_COLUMN, BATCH_ROWS, 1};
    char letters[4], formula[FORMULA_SIZE];
    xlsx_colour_when(book, all,
                     compose(formula, "=$%s%d<>\"\"",
                             column_letters(column_of(CELL_ERROR), letters), FIRST_ROW + 1),
                     XLSX_RED);
    xlsx_colour_when(book, all,
                     compose(formula, "=$%s%d<>\"\"",
                             column_letters(column_of(CELL_WARNINGS), letters), FIRST_ROW + 1),
                     XLSX_AMBER);
}

void sheet_batch(xlsx *book)
{
    case_values values;
    write_header(book);
    for (int i = 0; i < BATCH_ROWS; i++) {
        if (i < EXAMPLES)
            shown_values(examples[i].input, &values);
        else
            shown_nothing(&values);
        xlsx_text(book, FIRST_ROW + i, CASE_COLUMN, i < EXAMPLES ? examples[i].name : "",
                  XLSX_INPUT);
        write_row(book, FIRST_ROW + i, &values);
    }
    set_widths(book);
    xlsx_freeze(book, FIRST_ROW, 1);
    xlsx_print(book, (xlsx_page){FIRST_ROW + BATCH_ROWS - 1, column_of(RESULTS_END) - 1, HEADER_ROW,
                                 true, 3});
    check_typing(book);
    colour_rows(book);
    xlsx_protect(book);
    xlsx_hide_columns(book, column_of(RESULTS_END), column_of(case_cell_count) - 1);
}
