/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The reader of CSV files. It comes to an end with any bytes, loses no letter, and its cells are
 * texts. It reads back what the writer has written. */
#include "input/input.h"
#include "file.h"
#include "input.h"
#include "rows/rows.h"
#include "text/text.h"
#include "until_exit.h"

#include <ctype.h>
#include <strings.h>

enum { COLUMNS_MAX = 6, ROWS_MAX = 8, TEXT_MAX = 12 };

static void check_row(const csv_input *in, int64_t *line)
{
    CLAIM(in->count <= CSV_ROW_CELLS, "%zu", in->count);
    CLAIM(in->line >= *line, "line %lld after %lld", (long long)in->line, (long long)*line);
    *line = in->line;
    for (size_t i = 0; i < in->count; i++)
        CLAIM(strlen(in->cell[i]) <= CSV_ROW_BYTES, "%zu", i);
}

static size_t count_letters(const uint8_t *bytes, size_t size)
{
    size_t letters = 0;
    for (size_t i = 0; i < size; i++)
        letters += bytes[i] < 0x80 && isalnum(bytes[i]) ? 1 : 0;
    return letters;
}

/* A first line that is no row, or a mark of Unicode. */
static bool has_other_start(const uint8_t *data, size_t size)
{
    return size > 0 &&
           (data[0] >= 0x80 || (size > 4 && strncasecmp((const char *)data, "sep=", 4) == 0));
}

typedef struct {
    const char *path;
    const uint8_t *data;
    size_t size;
    char separator;
} any_file;

/* What cannot be opened ends in exit(). */
static void read_anything(void *of_file)
{
    const any_file *file = of_file;
    const uint8_t *data = file->data;
    const size_t size = file->size;
    csv_input *in = csv_input_open(file->path, file->separator, NULL);
    CLAIM(in != NULL, "open");
    csv_event event;
    size_t rows = 0, letters = 0;
    int64_t line = 1;
    while ((event = csv_input_next(in)) == CSV_ROW || event == CSV_MALFORMED) {
        check_row(in, &line);
        CLAIM(++rows <= size, "%zu rows of %zu bytes", rows, size);
        const char *row = csv_input_row(in);
        letters += count_letters((const uint8_t *)row, strlen(row));
        CLAIM(event == CSV_ROW || !csv_input_spans_lines(in), "more than a line");
    }
    CLAIM((event == CSV_FAILED) == (in->problem[0] != '\0'), "a reason");
    const size_t all = count_letters(data, size);
    if (event == CSV_END)
        CLAIM(csv_input_next(in) == CSV_END, "a row after the end");
    if (event == CSV_END && !has_other_start(data, size))
        CLAIM(letters == all, "%zu of %zu letters", letters, all);
    csv_input_close(in);
}

/* ---- What was written ---- */

typedef struct {
    size_t columns, rows;
    char cell[ROWS_MAX][COLUMNS_MAX][2 * TEXT_MAX + 1];
} table;

/* One of the characters that mean something, or a letter of two bytes. */
static void add_character(char *text, uint8_t any)
{
    static const char special[] = "\",;\n\r\t 'x.";
    text += strlen(text);
    text[0] = any < 128 ? special[any % (sizeof special - 1)] : '\xc3';
    text[1] = any < 128 ? '\0' : (char)(0x80 | (any & 0x3f));
}

static bool is_blank(const table *t, size_t row)
{
    for (size_t i = 0; i < t->columns; i++)
        if (t->cell[row][i][strspn(t->cell[row][i], " \t")] != '\0')
            return false;
    return true;
}

static void take_table(input *in, table *t)
{
    memset(t, 0, sizeof *t);
    t->columns = 2 + take_byte(in) % (COLUMNS_MAX - 1);
    while (t->rows < ROWS_MAX && in->left > 0) {
        for (size_t i = 0; i < t->columns; i++) {
            const size_t length = take_byte(in) % (TEXT_MAX + 1);
            for (size_t j = 0; j < length; j++)
                add_character(t->cell[t->rows][i], take_byte(in));
        }
        t->rows++;
    }
}

static void write_and_read(input *in, char separator)
{
    static table t;
    static output out;
    take_table(in, &t);
    out = (output){.used = 0};
    records rows = {.format = &delimited_format,
                    .out = &out,
                    .digits = 17,
                    .decimal_sign = '.',
                    .separator = separator};
    for (size_t i = 0; i < t.rows; i++) {
        for (size_t j = 0; j < t.columns; j++)
            records_value(&rows, cell_text(t.cell[i][j]));
        records_end_row(&rows);
    }
    csv_input *file = csv_input_open(file_of(out.buffer, out.used), separator, NULL);
    CLAIM(file != NULL, "open");
    for (size_t i = 0; i < t.rows; i++) {
        if (is_blank(&t, i))
            continue;
        CLAIM(csv_input_next(file) == CSV_ROW && file->count == t.columns, "row %zu", i);
        for (size_t j = 0; j < t.columns; j++)
            CLAIM(strcmp(file->cell[j], t.cell[i][j]) == 0, "row %zu, column %zu", i, j);
    }
    CLAIM(csv_input_next(file) == CSV_END, "end");
    csv_input_close(file);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    input in = {data, size};
    const uint8_t kind = take_byte(&in);
    const char separator = kind % 2 == 0 ? ',' : ';';
    if (kind < 128) {
        any_file file = {file_of(in.data, in.left), in.data, in.left, separator};
        const int ended = until_exit(read_anything, &file);
        CLAIM(ended == NO_EXIT || ended == STATUS_FAILED, "%d", ended);
    } else
        write_and_read(&in, separator);
    return 0;
}
