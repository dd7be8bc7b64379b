/* SPDX-License-Identifier: GPL-3.0-or-later */
/* XLSX. One sheet has the rows, or several have, below a header that does not scroll. Another says
 * what the columns mean, where that is known; the last, how the rows were made. */
#include "rows.h"

#include "sheet/sheet.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include <rwedge.h>

enum { WIDTH_LEAST = 13, WIDTH_MOST = 40 };

static void write_about(xlsx *book)
{
    static const char *const lines[] = {
        "\"rwedge COMMAND --help\" describes the columns and their units; a cell without a value "
        "is empty.",
        "Source: M. Ciavarella, D. A. Hills, G. Monno, \"Contact problems for a wedge with rounded "
        "apex\",",
        "Int. J. Mech. Sci. 40 (1998) 977-988. Plane strain; a is half the width of the rounding, "
        "b that of the contact.",
        "Numbers have 16 digits, one less than in CSV.",
    };
    char text[1200];
    xlsx_text(book, 0, 0, "About these rows", XLSX_TITLE);
    snprintf(text, sizeof text, "Written by rwedge %s with the command:  %s", rwedge_version(),
             invocation());
    xlsx_text(book, 2, 0, text, XLSX_PLAIN);
    for (int i = 0; i < (int)(sizeof lines / sizeof lines[0]); i++)
        xlsx_text(book, 4 + i, 0, lines[i], XLSX_PLAIN);
    xlsx_width(book, 0, 100);
    xlsx_print(book, 7, 0, XLSX_ONE_PAGE, true);
}

static void turn_to_rows(const records *rows)
{
    xlsx_sheet(rows->book, rows->sheets != NULL ? rows->sheets[rows->sheet] : "Rows");
}

/* The next row of the sheet Columns, for a name that is known and new. */
static void describe(records *rows, const char *name)
{
    for (int i = 0; i < rows->kind_count; i++) {
        const column_kind *kind = &rows->kinds[i];
        if (strcmp(kind->name, name) != 0 || (rows->described_kinds >> i & 1) != 0)
            continue;
        const char *const texts[] = {name, kind->meaning, kind->unit};
        rows->described++;
        rows->described_kinds |= UINT64_C(1) << i;
        xlsx_sheet(rows->book, "Columns");
        for (int j = 0; j < 3; j++)
            xlsx_text(rows->book, rows->described, j, texts[j], XLSX_PLAIN);
        turn_to_rows(rows);
        return;
    }
}

static void begin(records *rows)
{
    static const struct {
        const char *name;
        double width;
    } headers[] = {{"column", 24}, {"meaning", 64}, {"unit", 14}};
    rows->book = xlsx_begin(rows->out, message_speaker());
    const char *const single[] = {"Rows", NULL}, *const *names =
                                                     rows->sheets != NULL ? rows->sheets : single;
    for (int i = 0; names[i] != NULL; i++)
        xlsx_sheet(rows->book, names[i]);
    if (rows->kinds != NULL) {
        xlsx_sheet(rows->book, "Columns");
        for (int i = 0; i < 3; i++) {
            xlsx_text(rows->book, 0, i, headers[i].name, XLSX_HEADING);
            xlsx_width(rows->book, i, headers[i].width);
        }
        xlsx_freeze(rows->book, 1, 0);
    }
    xlsx_sheet(rows->book, "About");
    write_about(rows->book);
    turn_to_rows(rows);
}

NO_RETURN static void refuse(const records *rows, const char *excess)
{
    failure("%s: %s, which XLSX cannot hold; allowed: csv, tsv, json", rows->out->name, excess);
}

static void check_room(const records *rows)
{
    if (rows->column >= XLSX_COLUMNS_MAX)
        refuse(rows, "more than 16384 columns");
    if (rows->row >= XLSX_ROWS_MAX)
        refuse(rows, "more than 1048575 rows");
}

/* A grid's columns are named by numbers. */
static void put_name(records *rows, const char *name)
{
    const double wanted = (double)strlen(name) + 2;
    double number;
    check_room(rows);
    xlsx_width(rows->book, rows->column, fmin(fmax(wanted, WIDTH_LEAST), WIDTH_MOST));
    if (number_read(name, &number))
        xlsx_number(rows->book, rows->row, rows->column, number, XLSX_HEADER);
    else
        xlsx_text(rows->book, rows->row, rows->column, name, XLSX_HEADER);
    describe(rows, name);
    rows->column++;
}

/* Six to nine digits are shown; the cell holds them all. */
static xlsx_style style_for(double value)
{
    const double size = fabs(value);
    if (value == floor(value) && size < 1e9)
        return XLSX_PLAIN;
    if (size < 1e-3 || size >= 1e6)
        return XLSX_POWER;
    return size < 0.1 ? XLSX_SMALL : size < 100 ? XLSX_MIDDLE : XLSX_LARGE;
}

static void put_value(records *rows, cell value)
{
    check_room(rows);
    if (isfinite(value.number))
        xlsx_number(
            rows->book, rows->row, rows->column,
            number_rounded(value.number, value.text != NULL ? NUMBER_DIGITS : rows->how->digits),
            style_for(value.number));
    else if (value.text != NULL && strlen(value.text) > XLSX_TEXT_MAX)
        refuse(rows, "a text has more than 32767 bytes");
    else if (value.text != NULL && value.text[0] != '\0')
        xlsx_text(rows->book, rows->row, rows->column, value.text, XLSX_UNIT);
    rows->column++;
}

static void end_row(records *rows)
{
    rows->column = 0;
    rows->row++;
}

static void end_header(records *rows)
{
    xlsx_freeze(rows->book, 1, 1);
    rows->last_column = rows->column - 1;
    end_row(rows);
}

static void end_sheet(records *rows)
{
    xlsx_print(rows->book, rows->row - 1, rows->last_column, XLSX_PAGES, rows->last_column > 6);
}

void spreadsheet_next_sheet(records *rows)
{
    end_sheet(rows);
    rows->row = rows->column = 0;
    rows->sheet++;
    turn_to_rows(rows);
}

static void end(records *rows)
{
    end_sheet(rows);
    if (rows->kinds != NULL) {
        xlsx_sheet(rows->book, "Columns");
        xlsx_print(rows->book, rows->described, 2, XLSX_ONE_PAGE, false);
    }
    xlsx_finish(rows->book);
}

const record_format xlsx_format = {begin, put_name, end_header, put_value, end_row, end};
