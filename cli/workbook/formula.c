/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "workbook.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const char *compose(const char *format, ...)
{
    static char room[FORMULA_SIZE];
    va_list values;
    va_start(values, format);
    vsnprintf(room, sizeof room, format, values);
    va_end(values);
    return text_copy(room);
}

const char *column_letters(int column)
{
    if (column >= 26 * 27) /* below column 1378, as all are */
        return compose("%c%c%c", 'A' + column / 676 - 1, 'A' + column / 26 % 26, 'A' + column % 26);
    return column >= 26 ? compose("%c%c", 'A' + column / 26 - 1, 'A' + column % 26)
                        : compose("%c", 'A' + column);
}

/* ---- Formulas of a row ----------------------------------------------------------------------- */

/* Names of three cells side by side: rwt_wn of rwt_wn1 to rwt_wn3. */
static const char *const triples[] = {"rwt_wn", "rwt_wf", "rwt_wt", "rwt_wp", "rwt_s_k", "rwt_b_k"};
enum { TRIPLES = sizeof triples / sizeof triples[0] };

static bool is_named(const char *name, size_t length, const char *cell)
{
    return strncmp(name, cell, length) == 0 && cell[length] == '\0';
}

static int find_cell(const char *name, size_t length)
{
    int cell = 0;
    while (cell < case_cell_count && !is_named(name, length, case_cells[cell].name))
        cell++;
    return cell;
}

static int first_of(const char *triple)
{
    char name[16];
    return find_cell(name, (size_t)snprintf(name, sizeof name, "%s1", triple));
}

/* The cells that a name stands for: the first, and how many; 0 for a name that is none of a
 * case. */
static int find(const char *name, size_t length, int *first)
{
    if (length < 4 || name[0] != 'r' || name[1] != 'w')
        return 0; /* most words of a formula are functions and numbers */
    *first = find_cell(name, length);
    if (*first < case_cell_count)
        return 1;
    for (int i = 0; i < TRIPLES; i++)
        if (is_named(name, length, triples[i])) {
            *first = first_of(triples[i]);
            return 3;
        }
    return 0;
}

/* Where the cells of a row are. */
typedef struct {
    int row;
    column_finder *column_of;
} row_cells;

static char *write_in_row(char *end, const char *name, size_t length, const void *about)
{
    const row_cells *cells = about;
    int first = 0;
    const int count = find(name, length, &first);
    if (count == 0)
        return word_copy(end, name, length, NULL);
    const int column = cells->column_of(first), row = cells->row + 1;
    end += sprintf(end, "$%s%d", column_letters(column), row);
    return count == 1 ? end : end + sprintf(end, ":$%s%d", column_letters(column + count - 1), row);
}

const char *formula_in_row(const char *formula, int row, column_finder *column_of)
{
    return template_expand(formula, write_in_row, &(row_cells){row, column_of});
}

static char *write_number(char *end, const char *name, size_t length, const void *number)
{
    return is_named(name, length, "rwt_i") ? end + sprintf(end, "%d", *(const int *)number)
                                           : word_copy(end, name, length, NULL);
}

const char *formula_at(const char *formula, int number)
{
    return template_expand(formula, write_number, &number);
}

const char *formula_named(const char *formula)
{
    return template_expand(formula, word_copy, NULL);
}

/* ---- Cells ----------------------------------------------------------------------------------- */

void formula_cell(xlsx *book, int row, int column, const char *formula, double value,
                  xlsx_style style)
{
    if (isfinite(value))
        xlsx_formula(book, row, column, formula, workbook_rounded(value), style);
    else
        xlsx_text_formula(book, row, column, formula, "", style);
}

const char *input_check(int cell)
{
    return compose("NOT(%s)", input_rules[cell].wrong);
}

const char *input_message(int cell)
{
    return compose("%s must be %s.", case_cells[cell].column, input_rules[cell].must);
}

static void write_cell(xlsx *book, int row, int column, int cell, const char *formula,
                       const case_values *values, xlsx_style style)
{
    if (cell == CELL_BRANCH)
        xlsx_text_formula(book, row, column, formula, values->branch, style);
    else
        formula_cell(book, row, column, formula, cell < RESULTS_END ? values->number[cell] : NAN,
                     style);
}

void named_cell(xlsx *book, int row, int column, int cell, const case_values *values,
                xlsx_style style)
{
    write_cell(book, row, column, cell, formula_named(case_cells[cell].formula), values, style);
    xlsx_name(book, case_cells[cell].name, row, column);
}

void cell_in_row(xlsx *book, int row, int cell, column_finder *column_of, const case_values *values)
{
    write_cell(book, row, column_of(cell), cell,
               formula_in_row(case_cells[cell].formula, row, column_of), values, XLSX_PLAIN);
}

void name_triples(xlsx *book, int row, column_finder *column_of)
{
    for (int i = 0; i < TRIPLES; i++)
        xlsx_name_range(book, triples[i], row, column_of(first_of(triples[i])), 1, 3);
}
