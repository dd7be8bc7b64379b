/* SPDX-License-Identifier: GPL-3.0-or-later */
/* JSON: an array of objects, one to a line; an empty cell is null. Jansson would build the whole
 * array in memory, and print every number with the same digits. So it writes the texts only. The
 * numbers are those of the other formats, which are valid in JSON too. */
#include "rows.h"

#include "document/document.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static void put_text(records *rows, const char *text)
{
    char *encoded = document_quoted(text);
    if (encoded == NULL)
        failure("%s: %s", rows->out->name,
                errno == ENOMEM ? "out of memory" : "a text is not UTF-8, which JSON needs");
    output_text(rows->out, encoded);
    free(encoded);
}

static void begin(records *rows)
{
    output_text(rows->out, "[");
}

static bool is_taken(const records *rows, const char *name)
{
    for (size_t i = 0; i < rows->key_count; i++)
        if (strcmp(rows->key[i], name) == 0)
            return true;
    return false;
}

/* Readers of JSON take the last of two values with one name. */
static void keep_name(records *rows, const char *name)
{
    const size_t size = strlen(name) + 24;
    char *key = memory_zeroed(size, 1);
    snprintf(key, size, "%s", name);
    for (int n = 2; is_taken(rows, key); n++)
        snprintf(key, size, "%s_%d", name, n);
    if (strcmp(key, name) != 0)
        notice("column '%.60s': there again; in JSON it is '%.70s'", name, key);
    rows->key = memory_for_one_more(rows->key, rows->key_count, sizeof *rows->key);
    rows->key[rows->key_count++] = key;
}

static void put_value(records *rows, cell value)
{
    output_text(rows->out, rows->row_begun ? ", " : rows->any_row ? ",\n{" : "\n{");
    rows->row_begun = rows->any_row = true;
    put_text(rows, rows->key[rows->next_key++]);
    output_text(rows->out, ": ");
    char text[NUMBER_SIZE];
    const int digits = value.text != NULL ? NUMBER_DIGITS : rows->how->digits;
    if (isfinite(value.number))
        output_write(rows->out, text, number_write(value.number, digits, '.', text));
    else if (value.text != NULL && value.text[0] != '\0')
        put_text(rows, value.text);
    else
        output_text(rows->out, "null");
}

static void end_row(records *rows)
{
    output_text(rows->out, "}");
    rows->row_begun = false;
    rows->next_key = 0;
}

static void end(records *rows)
{
    output_text(rows->out, "\n]\n");
}

const record_format json_format = {begin, keep_name, records_nothing, put_value, end_row, end};
