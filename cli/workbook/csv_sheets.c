/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "csv_sheets.h"

#include "text/message.h"
#include "input/csv_input.h"
#include "rows/spreadsheet.h"
#include "table/tables.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

/* A sheet's name has up to 31 letters, and none of these. */
enum { NAME_BYTES = 31, NAME_SIZE };
static const char not_in_names[] = "[]:*?\\'";

static bool is_inside_letter(char byte)
{
    return ((unsigned char)byte & 0xC0) == 0x80; /* UTF-8 */
}

/* The file's, without folder and ending. */
static void name_sheet(const char *path, char name[NAME_SIZE])
{
    const char *slash = strrchr(path, '/');
    const char *base = slash != NULL ? slash + 1 : path;
    const char *point = strrchr(base, '.');
    size_t length = point != NULL && point != base ? (size_t)(point - base) : strlen(base);
    if (length > NAME_BYTES)
        for (length = NAME_BYTES; is_inside_letter(base[length]);)
            length--;
    snprintf(name, NAME_SIZE, "%.*s", (int)length, base);
    for (char *bad = name; (bad = strpbrk(bad, not_in_names)) != NULL;)
        *bad = '_';
}

/* Spreadsheets do not tell capitals from small letters in names. */
static bool is_new(const char *path, const char *const names[], int count)
{
    for (int i = 0; i < count; i++)
        if (strcasecmp(names[i], names[count]) == 0) {
            failure("%s: a second sheet of the name %s; allowed: files with different names", path,
                    names[i]);
            return false;
        }
    return true;
}

/* "007" and twenty digits are meant as they stand; a fraction of 17 digits is a number. */
static cell cell_of(const char *text)
{
    double number;
    const bool exact = number_is_exact(text) || strpbrk(text, ".e") != NULL;
    return exact && number_read(text, &number) ? cell_number(number) : cell_text(text);
}

static void write_row(const csv_input *in, bool header, records *rows)
{
    for (size_t i = 0; i < csv_input_count(in); i++)
        if (header)
            rows->format->name(rows, csv_input_cells(in)[i]);
        else
            rows->format->value(rows, NULL, cell_of(csv_input_cells(in)[i]));
    (header ? rows->format->end_header : rows->format->end_row)(rows);
}

static bool write_rows(csv_input *in, records *rows)
{
    bool header = true;
    csv_event event = CSV_END;
    while (records_go_on(rows) && (event = csv_input_next(in)) == CSV_ROW) {
        write_row(in, header, rows);
        header = false;
    }
    if (event == CSV_MALFORMED || event == CSV_FAILED)
        csv_input_fail(in);
    if (event == CSV_END && header)
        failure("%s: no rows", csv_input_name(in));
    return event == CSV_END && !header;
}

static bool write_file(const char *path, records *rows)
{
    csv_input *in = csv_input_open(path, ',', NULL);
    const bool done = in != NULL && write_rows(in, rows);
    csv_input_close(in);
    return done;
}

bool csv_sheets_write(void *paths, records *rows, bool show_progress)
{
    const char *const *path = *(const char *const **)paths;
    char text[CSV_SHEETS_MAX][NAME_SIZE];
    const char *names[CSV_SHEETS_MAX + 1] = {NULL};
    (void)show_progress;
    for (int i = 0; path[i] != NULL; i++) {
        name_sheet(path[i], text[i]);
        names[i] = text[i];
        if (!is_new(path[i], names, i))
            return false;
    }
    records_describe(rows, table_columns, COLUMN_KINDS);
    rows->sheets = names;
    rows->format->begin(rows);
    for (int i = 0; path[i] != NULL && records_go_on(rows); i++) {
        if (i > 0)
            spreadsheet_next_sheet(rows);
        if (!write_file(path[i], rows))
            return false;
    }
    rows->format->end(rows);
    return records_are_sound(rows);
}
