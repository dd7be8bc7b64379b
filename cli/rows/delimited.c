/* SPDX-License-Identifier: GPL-3.0-or-later */
/* CSV and TSV: one header row, no comments, quotes only where they are needed. CSV is that of
 * RFC 4180, except that records end in LF. */
#include "rows.h"

#include <math.h>
#include <string.h>

/* The signs that a formula begins with, also in full width, as East Asian input writes them. */
static bool begins_like_formula(const char *text)
{
    static const char *const wide[] = {"\xef\xbc\x9d", "\xef\xbc\x8b", "\xef\xbc\x8d",
                                       "\xef\xbc\xa0"};
    for (size_t i = 0; i < sizeof wide / sizeof wide[0]; i++)
        if (strncmp(text, wide[i], 3) == 0)
            return true;
    return text[0] != '\0' && strchr("=+-@\t\r", text[0]) != NULL;
}

/* Spreadsheets compute what begins like this, unless it is a number. */
static bool is_formula(const records *rows, const char *text)
{
    double number;
    return begins_like_formula(text) && !number_read_cell(text, rows->how->decimal_sign, &number);
}

static void put_text(const records *rows, const char *text)
{
    const char special[] = {rows->how->separator, '"', '\n', '\r', '\0'};
    const char *guard = rows->how->no_formulas && is_formula(rows, text) ? "'" : "";
    const char *quote = strpbrk(text, special) != NULL ? "\"" : "";
    output_text(rows->out, quote);
    output_text(rows->out, guard);
    for (size_t count; *text != '\0'; text += count) { /* up to a quote, which is doubled */
        count = strcspn(text, "\"");
        count += text[count] == '"';
        output_write(rows->out, text, count);
        output_text(rows->out, text[count - 1] == '"' ? "\"" : "");
    }
    output_text(rows->out, quote);
}

static void separate(records *rows)
{
    if (rows->row_begun)
        output_write(rows->out, &rows->how->separator, 1);
    rows->row_begun = true;
}

static void put_name(records *rows, const char *name)
{
    separate(rows);
    put_text(rows, name);
}

static void put_value(records *rows, cell value)
{
    separate(rows);
    char text[NUMBER_SIZE];
    if (value.text != NULL)
        put_text(rows, value.text);
    else if (isfinite(value.number))
        output_write(rows->out, text,
                     number_write(value.number, rows->how->digits, rows->how->decimal_sign, text));
}

static void end_row(records *rows)
{
    output_text(rows->out, "\n");
    rows->row_begun = false;
}

static void begin(records *rows)
{
    if (rows->mark)
        output_text(rows->out, "\xef\xbb\xbf");
}

const record_format delimited_format = {begin,     put_name, end_row,
                                        put_value, end_row,  records_nothing};
