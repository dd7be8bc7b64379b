/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "workbook.h"

#include <stdio.h>
#include <string.h>

#include <rwedge.h>

/* ---- About ---- */

enum { COLUMN_WIDTH = 80, LINE_LENGTH = 88 };

/* How many lines a paragraph takes; letters are narrower on average than the digits that widths
 * count. */
static int lines_of(const char *text)
{
    return 1 + (int)strlen(text) / LINE_LENGTH;
}

static void sheet_about(xlsx *book)
{
    char text[1200];
    int row = 0;
    xlsx_width(book, 0, 0, COLUMN_WIDTH);
    xlsx_text(book, row++, 0, "About this workbook", XLSX_TITLE);
    snprintf(text, sizeof text, "Written by rwedge %s with the command:  %s", rwedge_version(),
             invocation());
    xlsx_lines(book, row, lines_of(text));
    xlsx_text(book, row++, 0, text, XLSX_WRAPPED);
    const char *const *next = about_lines, *line;
    while ((line = workbook_line(&next)) != NULL) {
        const bool heading = line[0] == '=';
        row += heading;
        xlsx_lines(book, row, heading ? 1 : lines_of(line));
        xlsx_text(book, row++, 0, heading ? line + 2 : line, heading ? XLSX_HEADING : XLSX_WRAPPED);
    }
    xlsx_print(book, (xlsx_page){row - 1, 0, -1, false, NULL});
}

/* ---- The book ---- */

/* The sheets, in their order. */
enum {
    SHEET_CALCULATOR,
    SHEET_BATCH,
    SHEET_LOOK_UP,
    SHEET_ELASTIC_LIMIT,
    SHEET_MAX_TENSION,
    SHEET_CONTACT_LAW,
    SHEET_CRITICAL_FRICTION,
    SHEET_ABOUT,
    SHEET_WORKING,
    SHEETS
};

static void fill_tables(xlsx *book)
{
    xlsx_turn_to(book, SHEET_ELASTIC_LIMIT);
    sheet_elastic_limit(book);
    xlsx_turn_to(book, SHEET_MAX_TENSION);
    sheet_max_tension(book);
    xlsx_turn_to(book, SHEET_CONTACT_LAW);
    sheet_contact_law(book);
    xlsx_turn_to(book, SHEET_CRITICAL_FRICTION);
    sheet_critical_friction(book);
}

static void fill(xlsx *book, const yield_table *table)
{
    static const char *const names[SHEETS] = {
        "Calculator",        "Batch",           "Look up",
        "Elastic limit",     "Maximum tension", "Contact law",
        "Critical friction", "About",           WORKING_SHEET};
    case_values values;
    for (int i = 0; i < SHEETS; i++)
        xlsx_sheet(book, names[i]);
    xlsx_turn_to(book, SHEET_ABOUT);
    sheet_about(book);
    xlsx_turn_to(book, SHEET_CALCULATOR);
    sheet_calculator(book, &values);
    xlsx_turn_to(book, SHEET_WORKING);
    sheet_working(book, table, &values);
    xlsx_hide_sheet(book);
    xlsx_turn_to(book, SHEET_BATCH);
    sheet_batch(book);
    xlsx_turn_to(book, SHEET_LOOK_UP);
    sheet_look_up(book);
    xlsx_hide_names(book, "rwt_");
    fill_tables(book);
}

void book_write(output *out)
{
    yield_table *table = memory_zeroed(1, sizeof *table);
    yield_table_fill(table);
    cells_read();
    const char *problem;
    xlsx *book = xlsx_begin("rwedge: contact of a rounded wedge", false, &problem);
    if (book != NULL) {
        fill(book, table);
        problem = xlsx_finish(book, out);
    }
    if (problem != NULL)
        failure("%s: %s", out->name, problem);
}
