/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "workbook.h"

#include "input/input.h"
#include "table/table.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* A sheet's name has up to 31 letters, and none of these. */
enum { NAME_BYTES = 31, NAME_SIZE };
static const char not_in_names[] = "[]:*?\\'";

/* ---- Names of sheets ---- */

static bool fits_in_name(uint32_t code)
{
    return utf8_is_text(code) && !utf8_is_command(code) &&
           (code > 0x7f || strchr(not_in_names, (int)code) == NULL);
}

/* The workbook has sheets of its own, and Excel keeps one name for itself. Spreadsheets do not tell
 * capitals from small letters. */
static bool is_taken(const char *name, const char *const names[], int count)
{
    static const char *const kept[] = {"Columns", "About", "History"};
    for (int i = 0; i < (int)(sizeof kept / sizeof kept[0]); i++)
        if (strcasecmp(name, kept[i]) == 0)
            return true;
    for (int i = 0; i < count; i++)
        if (strcasecmp(name, names[i]) == 0)
            return true;
    return false;
}

/* The file's name without folder and ending, as far as a sheet may have it. */
static void name_sheet(const char *path, const char *const names[], int count, char name[NAME_SIZE])
{
    const char *slash = strrchr(path, '/');
    const char *base = slash != NULL ? slash + 1 : path;
    const char *point = strrchr(base, '.');
    const size_t whole = strlen(base);
    const int length = (int)(point != NULL && point != base ? (size_t)(point - base) : whole);
    char *own = memory_zeroed((size_t)length + 1, 1), plain[NAME_SIZE];
    snprintf(own, (size_t)length + 1, "%.*s", length, base);
    utf8_copy(own, fits_in_name, "_", plain, NAME_SIZE);
    snprintf(name, NAME_SIZE, "%s", plain);
    for (int n = 2; is_taken(name, names, count); n++) {
        char number[12];
        const int digits = snprintf(number, sizeof number, "_%d", n);
        utf8_copy(plain, fits_in_name, "_", name, NAME_SIZE - (size_t)digits);
        strcat(name, number);
    }
    if (strcmp(name, own) != 0)
        notice("%s: its sheet is called %s", path, name);
    free(own);
}

/* ---- Rows ---- */

typedef struct {
    csv_input *in;
    char decimal_sign;
    size_t columns;
} sheet;

static void refuse(const sheet *from, const complaint *why)
{
    failure("%s: line %" PRId64 ": %s", from->in->name, from->in->row.line, why->text);
}

/* A number with the other decimal sign is hardly meant as a text, unless commas separate the
 * cells. */
static cell cell_of(const sheet *from, const char *text)
{
    double number;
    if (number_survives(text, from->decimal_sign, &number))
        return cell_number(number);
    const bool comma = from->decimal_sign == ',';
    complaint why;
    complain(&why, "%.40s: a decimal %s", text,
             comma ? "point; without --decimal-comma it is a number"
                   : "comma; --decimal-comma reads it");
    if ((comma || from->in->separator != ',') && number_survives(text, comma ? '.' : ',', &number))
        refuse(from, &why);
    return cell_text(text);
}

static void write_header(sheet *from, records *rows)
{
    const char *const *cells = from->in->row.cell;
    from->columns = from->in->row.count;
    const char *hint = header_separator_hint(cells, from->columns);
    if (hint[0] != '\0')
        failure("%s: one column%s", from->in->name, hint);
    records_header(rows, from->columns, cells);
}

static void write_row(const sheet *from, records *rows)
{
    complaint why;
    const size_t count = from->in->row.count;
    if (!header_fits(from->columns, count, from->in->separator, &why))
        refuse(from, &why);
    for (size_t i = 0; i < count; i++)
        records_value(rows, cell_of(from, from->in->row.cell[i]));
    records_end_row(rows);
}

static void write_file(const char *path, char decimal_sign, records *rows)
{
    sheet from = {csv_input_open(path, decimal_sign == ',' ? ';' : ',', NULL), decimal_sign, 0};
    while (records_go_on(rows) && csv_input_next(from.in))
        if (from.columns == 0)
            write_header(&from, rows);
        else
            write_row(&from, rows);
    csv_input_check(from.in);
    if (from.columns == 0)
        failure("%s: no rows", from.in->name);
    csv_input_close(from.in);
}

void csv_sheets_write(void *of_files, records *rows)
{
    const csv_files *files = of_files;
    char text[CSV_SHEETS_MAX][NAME_SIZE];
    const char *names[CSV_SHEETS_MAX + 1] = {NULL};
    for (int i = 0; files->path[i] != NULL; i++) {
        name_sheet(files->path[i], names, i, text[i]);
        names[i] = text[i];
    }
    records_describe(rows, table_columns, COLUMN_KINDS);
    rows->sheets = names;
    for (int i = 0; files->path[i] != NULL && records_go_on(rows); i++) {
        if (i > 0)
            spreadsheet_next_sheet(rows);
        write_file(files->path[i], files->decimal_sign, rows);
    }
}
