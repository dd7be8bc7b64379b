/* SPDX-License-Identifier: GPL-3.0-or-later */
/* In place of xlsx.c where libxlsxwriter is missing: nothing here is called but the first. */
#include "xlsx.h"

bool xlsx_available(void)
{
    return false;
}

xlsx *xlsx_begin(const char *title, bool in_order)
{
    (void)title, (void)in_order;
    return NULL;
}

void xlsx_sheet(xlsx *book, const char *name)
{
    (void)book, (void)name;
}

void xlsx_turn_to(xlsx *book, int sheet)
{
    (void)book, (void)sheet;
}

void xlsx_number(xlsx *book, int row, int column, double value, xlsx_style style)
{
    (void)book, (void)row, (void)column, (void)value, (void)style;
}

void xlsx_text(xlsx *book, int row, int column, const char *text, xlsx_style style)
{
    (void)book, (void)row, (void)column, (void)text, (void)style;
}

void xlsx_formula(xlsx *book, int row, int column, const char *formula, double value,
                  xlsx_style style)
{
    (void)book, (void)row, (void)column, (void)formula, (void)value, (void)style;
}

void xlsx_text_formula(xlsx *book, int row, int column, const char *formula, const char *value,
                       xlsx_style style)
{
    (void)book, (void)row, (void)column, (void)formula, (void)value, (void)style;
}

void xlsx_name(xlsx *book, const char *name, int row, int column)
{
    (void)book, (void)name, (void)row, (void)column;
}

void xlsx_name_range(xlsx *book, const char *name, int row, int column, int rows, int columns)
{
    (void)book, (void)name, (void)row, (void)column, (void)rows, (void)columns;
}

void xlsx_width(xlsx *book, int first_column, int last_column, double characters)
{
    (void)book, (void)first_column, (void)last_column, (void)characters;
}

void xlsx_lines(xlsx *book, int row, int lines)
{
    (void)book, (void)row, (void)lines;
}

void xlsx_freeze(xlsx *book, int rows, int columns)
{
    (void)book, (void)rows, (void)columns;
}

void xlsx_print(xlsx *book, xlsx_page page)
{
    (void)book, (void)page;
}

void xlsx_draw(xlsx *book, int row, int column, const xlsx_chart *chart)
{
    (void)book, (void)row, (void)column, (void)chart;
}

const char *xlsx_finish(xlsx *book, output *out)
{
    (void)book, (void)out;
    return XLSX_MISSING;
}

void xlsx_discard(xlsx *book)
{
    (void)book;
}
