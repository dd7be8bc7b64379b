/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cells with a formula. */
#ifndef CLI_FORMULA_H
#define CLI_FORMULA_H

#include "cells.h"

#include "template.h"

#include "sheet/xlsx.h"
#include "text/printf_like.h"

/* Formulas and texts stay as long as the command. One that is put together: */
const char *compose(const char *format, ...) PRINTF_LIKE(1, 2);

/* "A", "Z", "AA" ... */
const char *column_letters(int column);

/* Where a row has the cells of a case. */
typedef int column_finder(int cell);

/* The formula, a template, with the names of the calculator. */
const char *formula_named(const char *formula);

/* The formula, a template, in a row: the names of a case's cells are replaced by those of the
 * row. */
const char *formula_in_row(const char *formula, int row, column_finder *column_of);

/* The condition, a template, that what is typed into an input is sound, and the message where it is
 * not. */
const char *input_check(int cell);
const char *input_message(int cell);

/* The formula, a template, with a number instead of rwt_i. */
const char *formula_at(const char *formula, int number);

/* A formula and its value, to ten digits; an empty text where there is no such number. */
void formula_cell(xlsx *book, int row, int column, const char *formula, double value,
                  xlsx_style style);

/* A cell of a case with its formula: under its name; or in a row. */
void named_cell(xlsx *book, int row, int column, int cell, const case_values *values,
                xlsx_style style);
void cell_in_row(xlsx *book, int row, int cell, column_finder *column_of,
                 const case_values *values);

/* The names of three cells side by side, in the row that has the calculator's. */
void name_triples(xlsx *book, int row, column_finder *column_of);

#endif
