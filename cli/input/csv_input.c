/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The only file that knows libcsv. Callers ask for one row after the other, but libcsv calls back
 * for whatever it is given. So it is given a byte at a time, until one ends a row. */
#include "input.h"

#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include <csv.h>

enum { BLOCK = 1 << 16 };

struct csv_source {
    text_input *text;
    struct csv_parser parser;
    char block[BLOCK];
    size_t begin, end; /* what of the block has not been parsed */
    bool at_start, after_return;
    bool has_ended, is_broken, too_many; /* of the row; broken by misplaced quotes */
    int64_t next_line;
    char *row; /* as it stands in the file */
    size_t length, row_capacity;
    char *cells; /* of the row, each with its 0 */
    size_t used, capacity;
    size_t begins[CSV_ROW_CELLS]; /* where each starts */
    const char *cell[CSV_ROW_CELLS];
};

/* ---- What libcsv calls ---- */

/* Spaces belong to their cell, as RFC 4180 has it. */
static int is_space(unsigned char c)
{
    (void)c;
    return 0;
}

static void reserve(char **text, size_t *capacity, size_t used, size_t more)
{
    if (*capacity - used >= more)
        return;
    *text = memory_resized(*text, 2 * (used + more));
    *capacity = 2 * (used + more);
}

static void take_cell(void *bytes, size_t length, void *of_input)
{
    csv_input *in = of_input;
    struct csv_source *from = in->source;
    from->too_many = in->count == CSV_ROW_CELLS;
    if (from->too_many)
        return;
    reserve(&from->cells, &from->capacity, from->used, length + 1);
    from->begins[in->count++] = from->used;
    if (length > 0)
        memcpy(from->cells + from->used, bytes, length);
    from->cells[from->used + length] = '\0';
    from->used += length + 1;
}

static void take_end(int end, void *of_input)
{
    (void)end;
    ((csv_input *)of_input)->source->has_ended = true;
}

/* ---- Opening and reading ---- */

static void separate_by(csv_input *in, char separator)
{
    in->separator = separator;
    csv_set_delim(&in->source->parser, (unsigned char)separator);
}

static void start_parser(csv_input *in)
{
    csv_init(&in->source->parser, CSV_STRICT);
    csv_set_space_func(&in->source->parser, is_space);
    separate_by(in, in->separator);
}

/* The ending of a file whose columns are separated by tabs. */
static bool is_tsv(const char *path)
{
    const char *ending = strrchr(path, '.');
    return ending != NULL && strcasecmp(ending, ".tsv") == 0;
}

csv_input *csv_input_try(const char *path, char separator, const char *encoding)
{
    csv_input *in = memory_zeroed(1, sizeof *in);
    in->source = memory_zeroed(1, sizeof *in->source);
    in->source->text = text_input_open(path, encoding);
    in->source->at_start = true;
    in->source->next_line = 1;
    in->cell = in->source->cell;
    in->name = in->source->text->name;
    in->separator = is_tsv(path) ? '\t' : separator;
    start_parser(in);
    strcpy(in->problem, in->source->text->problem);
    return in;
}

csv_input *csv_input_open(const char *path, char separator, const char *encoding)
{
    csv_input *in = csv_input_try(path, separator, encoding);
    csv_input_check(in);
    return in;
}

bool csv_input_stop(csv_input *in, const char *format, ...)
{
    va_list values;
    const int used = snprintf(in->problem, sizeof in->problem, "%.300s: ", in->name);
    va_start(values, format);
    vsnprintf(in->problem + used, sizeof in->problem - (size_t)used, format, values);
    va_end(values);
    return false;
}

static csv_event stop(csv_input *in, const char *why)
{
    csv_input_stop(in, "line %" PRId64 ": %s", in->line, why);
    return CSV_FAILED;
}

static bool ends_line(char c)
{
    return c == '\n' || c == '\r';
}

/* Whether there are tabs between the cells of the first row, but not the separator. */
static bool has_tabs_only(const char *bytes, size_t count, char separator)
{
    bool quoted = false, tabs = false;
    for (size_t i = 0; i < count && (quoted || !ends_line(bytes[i])); i++) {
        quoted = quoted != (bytes[i] == '"');
        tabs = tabs || (!quoted && bytes[i] == '\t');
        if (!quoted && bytes[i] == separator)
            return false;
    }
    return tabs;
}

/* The first line of a file may say how its columns are separated, as "sep=;" does for Excel. */
static void find_separator(csv_input *in)
{
    static const char says[] = "sep=";
    struct csv_source *from = in->source;
    const char *line = from->block;
    const size_t before = sizeof says - 1;
    from->at_start = false;
    if (from->end > before + 1 && strncasecmp(line, says, before) == 0 &&
        strchr(",;\t|", line[before]) != NULL && strchr("\r\n", line[before + 1]) != NULL) {
        separate_by(in, line[before]);
        from->begin = before + 1; /* a blank line is left */
    } else if (has_tabs_only(line, from->end, in->separator))
        separate_by(in, '\t');
}

static bool fill(csv_input *in)
{
    struct csv_source *from = in->source;
    from->begin = 0;
    if (!text_input_read(from->text, from->block, BLOCK, &from->end)) {
        strcpy(in->problem, from->text->problem);
        return false;
    }
    in->has_mark = from->text->has_mark;
    if (from->at_start)
        find_separator(in);
    return true;
}

/* ---- Rows ---- */

/* A quote that is closed nowhere, or where it cannot be: no one knows which rows it has taken. */
static csv_event not_closed(csv_input *in)
{
    return stop(in, "a quote that is not closed");
}

/* False at the end of the file, or where there is a problem. */
static bool next_byte(csv_input *in, char *byte)
{
    struct csv_source *from = in->source;
    if (from->begin == from->end && (!fill(in) || from->end == 0))
        return false;
    *byte = from->block[from->begin++];
    from->next_line += ends_line(*byte) && !(from->after_return && *byte == '\n');
    from->after_return = *byte == '\r';
    return true;
}

/* After misplaced quotes the rest of the line is left out. */
static void parse(csv_input *in, char byte)
{
    struct csv_source *from = in->source;
    reserve(&from->row, &from->row_capacity, from->length, 2);
    from->row[from->length++] = byte;
    from->is_broken =
        from->is_broken || csv_parse(&from->parser, &byte, 1, take_cell, take_end, in) != 1;
    if (from->is_broken && csv_error(&from->parser) == CSV_ENOMEM) /* no fault of the row */
        failure("out of memory");
    from->has_ended = from->has_ended || (from->is_broken && ends_line(byte));
}

/* The bytes of a row that begins with this one. The last may lack its end. */
static csv_event read_row(csv_input *in, char byte)
{
    struct csv_source *from = in->source;
    for (bool more = true;; more = next_byte(in, &byte)) {
        if (in->problem[0] != '\0')
            return CSV_FAILED;
        parse(in, more ? byte : '\n');
        if (from->has_ended)
            return CSV_ROW;
        if (!more)
            return not_closed(in);
        if (from->length > CSV_ROW_BYTES)
            return from->next_line > in->line ? not_closed(in)
                                              : stop(in, "a line of more than 1 MiB; allowed: CSV");
    }
}

/* Blank lines are no rows. */
static csv_event begin_row(csv_input *in)
{
    struct csv_source *from = in->source;
    char byte;
    in->count = from->length = from->used = 0;
    from->has_ended = from->is_broken = from->too_many = false;
    do
        if (!next_byte(in, &byte))
            return in->problem[0] != '\0' ? CSV_FAILED : CSV_END;
    while (ends_line(byte));
    in->line = from->next_line;
    return read_row(in, byte);
}

/* What the parser still holds of a row with misplaced quotes is thrown away. */
static csv_event refuse(csv_input *in)
{
    csv_free(&in->source->parser);
    start_parser(in);
    if (csv_input_spans_lines(in))
        return not_closed(in);
    return in->takes_malformed ? CSV_MALFORMED : stop(in, "misplaced quotes");
}

static csv_event next_row(csv_input *in)
{
    struct csv_source *from = in->source;
    csv_event event = begin_row(in);
    if (event != CSV_ROW)
        return event;
    if (from->is_broken)
        event = refuse(in);
    if (from->too_many)
        return stop(in, "more than 1000 cells in a row");
    for (size_t i = 0; i < in->count; i++)
        from->cell[i] = from->cells + from->begins[i];
    return event;
}

static bool is_blank(const csv_input *in)
{
    for (size_t i = 0; i < in->count; i++)
        if (in->cell[i][strspn(in->cell[i], " \t")] != '\0')
            return false;
    return true;
}

csv_event csv_input_next(csv_input *in)
{
    csv_event event = CSV_FAILED;
    if (in->problem[0] == '\0')
        do
            event = next_row(in);
        while (event == CSV_ROW && is_blank(in));
    return event;
}

void csv_input_header(csv_input *in, csv_row *row)
{
    const csv_event event = csv_input_next(in);
    if (event == CSV_END || event == CSV_MALFORMED)
        csv_input_stop(in, "%s; needed: a header row with the names of the columns",
                       event == CSV_END ? "empty" : "misplaced quotes in the first row");
    if (event == CSV_ROW)
        csv_row_keep(in, false, row);
}

bool csv_input_spans_lines(csv_input *in)
{
    return strpbrk(csv_input_row(in), "\r\n") != NULL;
}

void csv_input_check(const csv_input *in)
{
    if (in->problem[0] != '\0')
        failure("%s", in->problem);
}

const char *csv_input_row(csv_input *in)
{
    size_t length = in->source->length;
    char *row = in->source->row;
    while (length > 0 && ends_line(row[length - 1]))
        length--;
    row[length] = '\0';
    return row;
}

void csv_input_close(csv_input *in)
{
    csv_free(&in->source->parser);
    text_input_close(in->source->text);
    free(in->source->row);
    free(in->source->cells);
    free(in->source);
    free(in);
}

/* ---- A row that stays ---- */

/* One piece of memory: the places of the cells, and their texts behind them. */
void csv_row_keep(csv_input *in, bool malformed, csv_row *row)
{
    const struct csv_source *from = in->source;
    const char *whole = csv_input_row(in);
    const size_t places = (in->count + 1) * sizeof *row->cell, length = strlen(whole) + 1;
    *row = (csv_row){.malformed = malformed,
                     .line = in->line,
                     .count = in->count,
                     .bytes = places + from->used + length};
    row->cell = memory_resized(NULL, row->bytes);
    char *text = (char *)row->cell + places;
    if (from->used > 0)
        memcpy(text, from->cells, from->used);
    for (size_t i = 0; i < in->count; i++)
        row->cell[i] = text + from->begins[i];
    row->whole = memcpy(text + from->used, whole, length);
}

void csv_row_free(csv_row *row)
{
    free(row->cell);
    row->cell = NULL;
}
