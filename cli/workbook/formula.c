/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formula.h"

#include "model.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

const char *compose(char text[], const char *format, ...)
{
    va_list values;
    va_start(values, format);
    vsnprintf(text, FORMULA_SIZE, format, values);
    va_end(values);
    return text;
}

void formula_cell(xlsx *book, int row, int column, const char *formula, double value,
                  xlsx_style style)
{
    if (isfinite(value))
        xlsx_formula(book, row, column, formula, workbook_rounded(value), style);
    else
        xlsx_text_formula(book, row, column, formula, "", style);
}
