/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "look_up.h"

#include "formula.h"

#include <string.h>

#include <rwedge.h>

enum { LABEL, NAME, VALUE, TEXT, FIRST_ROW = 4, TEXT_WIDTH = 110, LINE_LENGTH = 120 };

/* At an entry of the table, the formulas give that entry: the example is one. */
static const double example_tip = 0.3, example_f = 0.1;

#define CORNER(T, I, J) "INDEX(" T ",rw_row" I ",rw_column" J ")"
#define BETWEEN(T)                                                                                 \
    "(1-rw_share_f)*((1-rw_share_tip)*" CORNER(T, "", "") "+rw_share_tip*" CORNER(                 \
        T, "",                                                                                     \
        "+1") ")+rw_share_f*((1-rw_share_tip)*" CORNER(T, "+1",                                    \
                                                       "") "+rw_share_tip*" CORNER(T, "+1",        \
                                                                                   "+1") ")"

typedef struct {
    const char *what, *name, *formula;
    double value;
} step;

/* To be copied; a long one is wrapped, or a page would cut it. */
static void write_formula_text(xlsx *book, int row, const char *text)
{
    const int lines = 1 + (int)strlen(text) / LINE_LENGTH;
    if (lines > 1)
        xlsx_lines(book, row, lines);
    xlsx_text(book, row, TEXT, text, lines > 1 ? XLSX_WRAPPED : XLSX_NOTE);
}

static void write_step(xlsx *book, int row, const step *what)
{
    xlsx_text(book, row, LABEL, what->what, XLSX_PLAIN);
    xlsx_text(book, row, NAME, what->name, XLSX_NOTE);
    formula_cell(book, row, VALUE, what->formula, what->value, XLSX_RESULT);
    write_formula_text(book, row, what->formula + 1);
    xlsx_name(book, what->name, row, VALUE);
}

static void write_steps(xlsx *book, int row)
{
    double surface, below, x, y;
    rwedge_surface_yield(example_tip, example_f, 0.3, &surface, &x);
    rwedge_subsurface_yield(example_tip, example_f, 0.3, &below, &x, &y);
    const step steps[] = {
        {"Column of the next smaller a/b", "rw_column",
         "=MIN(MATCH(rw_look_a_over_b,rw_table_tips,1),28)", 18},
        {"Row of the next smaller f", "rw_row", "=MIN(MATCH(rw_look_f,rw_table_f,1),64)", 9},
        {"How far to the next column", "rw_share_tip",
         "=(rw_look_a_over_b-INDEX(rw_table_tips,rw_column))/(INDEX(rw_table_tips,rw_column+1)-"
         "INDEX(rw_table_tips,rw_column))",
         0},
        {"How far to the next row", "rw_share_f",
         "=(rw_look_f-INDEX(rw_table_f,rw_row))/(INDEX(rw_table_f,rw_row+1)-INDEX(rw_table_f,"
         "rw_row))",
         0},
        {"P/(bk) at the surface", "rw_look_surface", "=" BETWEEN("rw_table_surface"), surface},
        {"P/(bk) below it; empty: none", "rw_look_below",
         "=IF(COUNT(INDEX(rw_table_below,rw_row,rw_column):INDEX(rw_table_below,rw_row+1,"
         "rw_column+1))=4," BETWEEN("rw_table_below") ",\"\")",
         below},
        {"Elastic limit P/(bk): the smaller", "rw_look_P_over_bk",
         "=MIN(rw_look_surface,rw_look_below)", surface < below ? surface : below},
    };
    for (size_t i = 0; i < sizeof steps / sizeof steps[0]; i++)
        write_step(book, row + (int)i, &steps[i]);
}

static void write_input(xlsx *book, int row, const char *what, const char *name, double value,
                        const char *check, const char *must)
{
    const xlsx_rule rule = {check, what, must, must};
    xlsx_text(book, row, LABEL, what, XLSX_PLAIN);
    xlsx_text(book, row, NAME, name, XLSX_NOTE);
    xlsx_number(book, row, VALUE, value, XLSX_INPUT);
    xlsx_text(book, row, TEXT, must, XLSX_NOTE);
    xlsx_name(book, name, row, VALUE);
    xlsx_validate(book, (xlsx_area){row, VALUE, 1, 1}, &rule);
}

void sheet_look_up(xlsx *book)
{
    static const char *const lines[] = {
        "Interpolate each branch by itself, then take the smaller: the elastic limit has a kink "
        "where they cross, the branches have none.",
        "Error: 0.12 %, the largest over the middles of all cells. The nearest entry instead errs "
        "by up to half the step between entries, some per cent.",
        "The table is the two blocks on the right of the sheet Elastic limit, nu = 0.3. For other "
        "nu use Batch.",
        "To interpolate many points, copy the formulas beside the cells, with cells of yours "
        "instead of the names.",
    };
    xlsx_text(book, 0, LABEL, "Look up: the elastic limit between the entries of the table",
              XLSX_TITLE);
    write_input(book, FIRST_ROW - 2, "a/b", "rw_look_a_over_b", example_tip,
                "=AND(ISNUMBER(rw_look_a_over_b),rw_look_a_over_b>=0.01,rw_look_a_over_b<=1)",
                "from 0.01 to 1; above 1 type 1");
    write_input(book, FIRST_ROW - 1, "Coefficient of friction f", "rw_look_f", example_f,
                "=AND(ISNUMBER(rw_look_f),rw_look_f>=0,rw_look_f<=0.8)", "from 0 to 0.8");
    write_steps(book, FIRST_ROW);
    for (int i = 0; i < 4; i++)
        xlsx_text(book, FIRST_ROW + 8 + i, LABEL, lines[i], XLSX_NOTE);
    xlsx_width(book, LABEL, LABEL, 32);
    xlsx_width(book, NAME, NAME, 18);
    xlsx_width(book, VALUE, VALUE, 12);
    xlsx_width(book, TEXT, TEXT, TEXT_WIDTH);
    xlsx_protect(book);
    xlsx_print(book, (xlsx_page){FIRST_ROW + 11, TEXT, -1, true, 1});
}
