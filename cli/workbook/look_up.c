/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "workbook.h"

#include <math.h>
#include <stdio.h>

#include <rwedge.h>

enum { TIP, FRICTION, LIMIT, NOTE, HEADER_ROW = 9, FIRST_ROW, ROWS = 20 };

/* The row and the column of the next smaller entries of the table; # is the row. */
#define ROW "MIN(MATCH(B#,rw_table_f,1),64)"
#define COLUMN "MIN(MATCH(A#,rw_table_tips,1),28)"

/* On a line through two entries of a row of the table T, I below ROW. */
#define ALONG(T, I)                                                                                \
    "FORECAST(MIN(1,A#),INDEX(" T "," ROW I "," COLUMN "):INDEX(" T "," ROW I "," COLUMN           \
    "+1),INDEX(rw_table_tips," COLUMN "):INDEX(rw_table_tips," COLUMN "+1))"
/* The entries of f are 1/80 apart. */
#define BETWEEN(T) ALONG(T, "") "*(" ROW "-80*B#)+" ALONG(T, "+1") "*(1-" ROW "+80*B#)"

/* Where an entry is missing, FORECAST has one point, and the surface decides. */
static const char formula[] =
    "=IF(OR(A#=\"\",B#=\"\"),\"\",IF(OR(B#<0,B#>0.8),NA(),"
    "MIN(" BETWEEN("rw_table_surface") ",IFERROR(" BETWEEN("rw_table_below") ",1E+99))))";

/* Entries of the table, of which the formula gives back the value. */
static const double examples[][2] = {{0.3, 0.1}, {0.11, 0.3}, {1, 0}};
enum { EXAMPLES = sizeof examples / sizeof examples[0] };

static const char *in_row(int row, char text[FORMULA_SIZE])
{
    char *end = text;
    for (const char *from = formula; *from != '\0'; from++)
        if (*from == '#')
            end += sprintf(end, "%d", row + 1);
        else
            *end++ = *from;
    *end = '\0';
    return text;
}

static void write_row(xlsx *book, int row, double tip, double f)
{
    char text[FORMULA_SIZE];
    xlsx_number(book, row, TIP, tip, XLSX_INPUT);
    xlsx_number(book, row, FRICTION, f, XLSX_INPUT);
    formula_cell(book, row, LIMIT, in_row(row, text),
                 isnan(tip) ? NAN : rwedge_elastic_limit(tip, f, 0.3), XLSX_RESULT);
}

static void check_typing(xlsx *book)
{
    const xlsx_rule of_tip = {compose("=AND(A%d>=0.01,A%d<1E+60)", FIRST_ROW + 1, FIRST_ROW + 1),
                              "a/b", "0.01 and above", "a/b must be a number, 0.01 or above."};
    xlsx_validate(book, (xlsx_area){FIRST_ROW, TIP, ROWS, 1}, &of_tip);
    const xlsx_rule of_f = {compose("=AND(B%d>=0,B%d<=0.8)", FIRST_ROW + 1, FIRST_ROW + 1), "f",
                            "0 to 0.8", "f must be a number, 0 to 0.8."};
    xlsx_validate(book, (xlsx_area){FIRST_ROW, FRICTION, ROWS, 1}, &of_f);
}

void sheet_look_up(xlsx *book)
{
    static const char *const lines[] = {
        "Type a/b and f, or copy a blue cell to the right of your own two columns, on any sheet of "
        "this workbook.",
        "a/b from 0.01 (from 1 on, all are Hertz' contact), f from 0 to 0.8; nu = 0.3. For other "
        "nu take the sheet Batch.",
        "Its table is on the right of the sheet Elastic limit: the two branches, at the surface "
        "and below it.",
        "The formula interpolates each branch by itself, linearly, and takes the smaller. The "
        "limit has a kink where they cross;",
        "the branches have none. Where one of the four entries below the surface is missing, the "
        "surface decides.",
        "Error: 0.12 % at most, over the middles of all cells of the table.",
    };
    static const char *const header[] = {"a/b", "f", "P/(bk)"};
    xlsx_text(book, 0, TIP, "Look up: the elastic limit between the entries of the table",
              XLSX_TITLE);
    for (int i = 0; i < (int)(sizeof lines / sizeof lines[0]); i++)
        xlsx_text(book, 2 + i, TIP, lines[i], XLSX_PLAIN);
    for (int i = 0; i < 3; i++)
        xlsx_text(book, HEADER_ROW, i, header[i], XLSX_HEADER);
    for (int i = 0; i < ROWS; i++)
        write_row(book, FIRST_ROW + i, i < EXAMPLES ? examples[i][0] : NAN,
                  i < EXAMPLES ? examples[i][1] : NAN);
    check_typing(book);
    xlsx_width(book, TIP, LIMIT, 16);
    xlsx_width(book, NOTE, NOTE, 60);
    xlsx_freeze(book, FIRST_ROW, 0);
    xlsx_protect(book);
    xlsx_print(book, (xlsx_page){FIRST_ROW + ROWS - 1, NOTE, -1, true, NULL});
}
