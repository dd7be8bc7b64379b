/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Inputs left, results right, named as "solve --input" names its columns; then the working cells,
 * which are hidden. A row refers to itself and to the tables alone: it may be copied. */
#include "workbook.h"

#include <math.h>

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
                  cell < SHOWN_CELLS ? case_cells[cell].column : case_cells[cell].name,
                  cell < FIRST_REMARK ? XLSX_UPRIGHT : XLSX_HEADER);
}

/* Narrow: all of it is printed on one page. */
static void set_widths(xlsx *book)
{
    xlsx_width(book, CASE_COLUMN, CASE_COLUMN, 20);
    xlsx_width(book, CELLS_COLUMN, column_of(FIRST_REMARK) - 1, 9);
    xlsx_width(book, column_of(FIRST_REMARK), column_of(SHOWN_CELLS - 1), 30);
}

static void write_row(xlsx *book, int row, const case_values *values)
{
    for (int cell = 0; cell < INPUT_CELLS; cell++)
        xlsx_number(book, row, column_of(cell), values->number[cell], XLSX_BARE);
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
        const xlsx_rule rule = {formula_in_row(input_check(cell), FIRST_ROW, column_of),
                                case_cells[cell].column, case_cells[cell].label,
                                input_message(cell)};
        xlsx_validate(book, (xlsx_area){FIRST_ROW, column_of(cell), BATCH_ROWS, 1}, &rule);
    }
}

/* A row with an error, or that yields, is red, one with warnings amber. The cells to type into are
 * yellow, and so are those of the next rows: unused rows further down are printed without. */
#define NEXT_ROWS "ROW()<=rwt_used+20"
static void colour_rows(xlsx *book)
{
    const xlsx_area cases = {FIRST_ROW, CASE_COLUMN, BATCH_ROWS, 1},
                    inputs = {FIRST_ROW, CELLS_COLUMN, BATCH_ROWS, INPUT_CELLS},
                    results = {FIRST_ROW, CELLS_COLUMN + INPUT_CELLS, BATCH_ROWS,
                               SHOWN_CELLS - INPUT_CELLS};
    static const struct {
        const char *condition;
        xlsx_colour colour;
    } rules[] = {{"OR(rw_error<>\"\",AND(ISNUMBER(rw_safety),rw_safety<1))", XLSX_RED},
                 {"rw_remarks<>\"\"", XLSX_AMBER},
                 {NEXT_ROWS, XLSX_YELLOW}};
    for (size_t i = 0; i < sizeof rules / sizeof rules[0]; i++)
        xlsx_colour_when(book, cases, formula_in_row(rules[i].condition, FIRST_ROW, column_of),
                         rules[i].colour);
    xlsx_colour_when(book, inputs, "=" NEXT_ROWS, XLSX_YELLOW);
    xlsx_colour_when(book, results, "=ROW()<=rwt_used", XLSX_BLUE);
}

/* The last row that has an input, beside the hidden names. */
static void write_used(xlsx *book)
{
    const int column = column_of(case_cell_count);
    formula_cell(book, HEADER_ROW, column,
                 "=MAX(1,SUMPRODUCT(MAX((Batch!$B$2:$N$10000<>\"\")*ROW(Batch!$B$2:$N$10000))))",
                 FIRST_ROW + EXAMPLES, XLSX_PLAIN);
    xlsx_name(book, "rwt_used", HEADER_ROW, column);
}

static void print_used_rows(xlsx *book)
{
    const char *last = column_letters(column_of(SHOWN_CELLS) - 1);
    const char *area = compose("=Batch!$A$1:INDEX(Batch!$%s$1:$%s$10000,rwt_used)", last, last);
    xlsx_print(book, (xlsx_page){0, 0, HEADER_ROW, true, area});
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
                  XLSX_BARE);
        write_row(book, FIRST_ROW + i, &values);
    }
    write_used(book);
    set_widths(book);
    xlsx_freeze(book, FIRST_ROW, 1);
    print_used_rows(book);
    check_typing(book);
    colour_rows(book);
    xlsx_protect(book);
    xlsx_hide_columns(book, column_of(SHOWN_CELLS), column_of(case_cell_count));
}
