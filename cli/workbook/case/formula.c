/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formula.h"

#include "rounded.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const char *compose(char text[], const char *format, ...)
{
    va_list values;
    va_start(values, format);
    vsnprintf(text, FORMULA_SIZE, format, values);
    va_end(values);
    return text;
}

const char *column_letters(int column, char text[4])
{
    if (column >= 26 * 27)
        snprintf(text, 4, "%c%c%c", 'A' + column / 676 - 1, 'A' + column / 26 % 26,
                 'A' + column % 26); /* below column 1378, as all are */
    else if (column >= 26)
        snprintf(text, 4, "%c%c", 'A' + column / 26 - 1, 'A' + column % 26);
    else
        snprintf(text, 4, "%c", 'A' + column);
    return text;
}

/* ---- Formulas of a row ----------------------------------------------------------------------- */

/* Names of several cells side by side. */
static const struct {
    const char *name;
    int first, count;
} groups[] = {{"rwt_wn", WORK_WEIGHT_NU, 3},
              {"rwt_wf", WORK_WEIGHT_F, 3},
              {"rwt_wt", WORK_WEIGHT_T, 3},
              {"rwt_wp", WORK_WEIGHT_PLACE, 3},
              {"rwt_s_ks", WORK_YIELD_S + YIELD_K, 3},
              {"rwt_b_ks", WORK_YIELD_B + YIELD_K, 3}};
enum { GROUPS = sizeof groups / sizeof groups[0] };

static bool is_named(const char *name, size_t length, const char *cell)
{
    return strncmp(name, cell, length) == 0 && cell[length] == '\0';
}

/* The cells that a name stands for: the first, and how many; 0 for a name that is none of a
 * case. */
static int find(const char *name, size_t length, int *first)
{
    if (length < 4 || name[0] != 'r' || name[1] != 'w')
        return 0; /* most words of a formula are functions and numbers */
    for (int i = 0; i < CELL_COUNT; i++)
        if (is_named(name, length, case_cells[i].name)) {
            *first = i;
            return 1;
        }
    for (int i = 0; i < GROUPS; i++)
        if (is_named(name, length, groups[i].name)) {
            *first = groups[i].first;
            return groups[i].count;
        }
    return 0;
}

static size_t name_length(const char *text)
{
    size_t length = 0;
    while (isalnum((unsigned char)text[length]) || text[length] == '_')
        length++;
    return length;
}

/* What a name becomes: writes it, and returns its end. */
typedef struct {
    int row;
    column_finder *column_of; /* or NULL */
    int number;               /* instead of rwt_i */
} substitution;

static char *put(char *end, const char *name, size_t length, const substitution *with)
{
    char from[4], to[4];
    int first = 0;
    if (is_named(name, length, "rwt_i"))
        return end + sprintf(end, "%d", with->number);
    const int count = with->column_of != NULL ? find(name, length, &first) : 0;
    if (count == 0)
        return (char *)memcpy(end, name, length) + length;
    column_letters(with->column_of(first), from);
    end += sprintf(end, "$%s%d", from, with->row + 1);
    column_letters(with->column_of(first) + count - 1, to);
    return count == 1 ? end : end + sprintf(end, ":$%s%d", to, with->row + 1);
}

/* Outside of quotes. */
static const char *substitute(const char *from, const substitution *with, char *text)
{
    char *end = text;
    bool quoted = false;
    while (*from != '\0') {
        const size_t length = quoted ? 0 : name_length(from);
        if (length > 0) {
            end = put(end, from, length, with);
            from += length;
        } else {
            quoted = quoted != (*from == '"');
            *end++ = *from++;
        }
    }
    *end = '\0';
    return text;
}

const char *formula_in_row(const char *formula, int row, column_finder *column_of,
                           char text[FORMULA_SIZE])
{
    const substitution with = {row, column_of, 0};
    return substitute(formula, &with, text);
}

const char *formula_at(const char *formula, int number, char text[FORMULA_SIZE])
{
    const substitution with = {0, NULL, number};
    return substitute(formula, &with, text);
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

const char *input_check(int cell, char text[FORMULA_SIZE])
{
    return compose(text, "=NOT(%s)", input_rules[cell].wrong);
}

const char *input_message(int cell, char text[FORMULA_SIZE])
{
    return compose(text, "%s must be %s.", case_cells[cell].column, input_rules[cell].must);
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
    write_cell(book, row, column, cell, case_cells[cell].formula, values, style);
    xlsx_name(book, case_cells[cell].name, row, column);
}

void cell_in_row(xlsx *book, int row, int cell, column_finder *column_of, const case_values *values)
{
    char formula[FORMULA_SIZE];
    write_cell(book, row, column_of(cell), cell,
               formula_in_row(case_cells[cell].formula, row, column_of, formula), values,
               case_cells[cell].style);
}

void name_groups(xlsx *book, int row, column_finder *column_of)
{
    for (int i = 0; i < GROUPS; i++)
        xlsx_name_range(book, groups[i].name, row, column_of(groups[i].first), 1, groups[i].count);
}
