/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "workbook.h"

#include "input/input.h"
#include "table/table.h"

#include <inttypes.h>
#include <stdio.h>
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
}

/* ---- Rows ---- */

static void refuse(const csv_input *in, const complaint *why)
{
    failure("%s: line %" PRId64 ": %s", in->name, in->row.line, why->text);
}

/* A number with the other decimal sign is hardly meant as a text, unless commas separate the
 * cells. */
static cell cell_of(const csv_input *in, const char *text, char decimal_sign)
{
    double number;
    if (number_survives(text, decimal_sign, &number))
        return cell_number(number);
    const bool comma = decimal_sign == ',';
    complaint why;
    complain(&why, "%.40s: a decimal %s", text,
             comma ? "point; without --decimal-comma it is a number"
                   : "comma; --decimal-comma reads it");
    if ((comma || in->separator != ',') && number_survives(text, comma ? '.' : ',', &number))
        refuse(in, &why);
    return cell_text(text);
}

static void write_file(const char *path, char decimal_sign, records *rows)
{
    csv_input *in = csv_input_open(path, decimal_sign == ',' ? ';' : ',', NULL);
    const csv_row *row = &in->row;
    size_t columns = 0;
    complaint why;
    while (records_go_on(rows) && csv_input_next(in)) {
        if (columns == 0) {
            const char *hint = row->count == 1 ? header_hint(row->cell, 1) : "";
            if (hint[0] != '\0')
                failure("%s: one column%s", in->name, hint);
            columns = row->count;
            records_header(rows, columns, row->cell);
            continue;
        }
        if (!header_fits(columns, row->count, in->separator, &why))
            refuse(in, &why);
        for (size_t i = 0; i < row->count; i++)
            records_value(rows, cell_of(in, row->cell[i], decimal_sign));
        records_end_row(rows);
    }
    csv_input_check(in);
    if (columns == 0)
        failure("%s: no rows", in->name);
    csv_input_close(in);
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
    rows->sheets = NULL; /* the names end here */
}
