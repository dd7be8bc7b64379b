/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The only file that knows libcsv. Callers ask for one row after the other, but libcsv's parser
 * calls back for whatever it is given. So it is given a row at a time: the lines up to one at whose
 * end no quote is open. */
#include "input.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include <csv.h>

enum { BLOCK = 1 << 16, PROBLEM = 600 };

struct csv_input {
    text_input *source;
    struct csv_parser parser;
    char block[BLOCK];
    size_t begin, end; /* what of the block has not been parsed */
    bool at_start, at_end, too_many, after_return;
    int64_t line, first_line; /* of the byte that comes next; of the row */
    char *row;                /* as it stands in the file */
    size_t length, row_room;
    char *text; /* the cells of the row, each with its 0 */
    size_t used, room;
    size_t begins[CSV_ROW_CELLS]; /* where each starts */
    const char *cell[CSV_ROW_CELLS];
    size_t count;
    char problem[PROBLEM]; /* why it cannot be read on */
};

/* ---- What libcsv calls ---- */

/* Spaces belong to their cell, as RFC 4180 has it. */
static int is_space(unsigned char c)
{
    (void)c;
    return 0;
}

static void make_room(char **text, size_t *room, size_t used, size_t more)
{
    if (*room - used >= more)
        return;
    *text = memory_resized(*text, 2 * (used + more));
    *room = 2 * (used + more);
}

static void take_cell(void *bytes, size_t length, void *data)
{
    csv_input *in = data;
    if (in->count == CSV_ROW_CELLS) {
        in->too_many = true;
        return;
    }
    make_room(&in->text, &in->room, in->used, length + 1);
    in->begins[in->count++] = in->used;
    if (length > 0)
        memcpy(in->text + in->used, bytes, length);
    in->text[in->used + length] = '\0';
    in->used += length + 1;
}

/* ---- Opening and reading ---- */

static void start_parser(csv_input *in, char separator)
{
    csv_init(&in->parser, CSV_STRICT | CSV_STRICT_FINI);
    csv_set_delim(&in->parser, (unsigned char)separator);
    csv_set_space_func(&in->parser, is_space);
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
    in->source = text_input_open(path, encoding);
    in->at_start = true;
    in->line = 1;
    start_parser(in, is_tsv(path) ? '\t' : separator);
    snprintf(in->problem, PROBLEM, "%s", text_input_problem(in->source));
    return in;
}

csv_input *csv_input_open(const char *path, char separator, const char *encoding)
{
    csv_input *in = csv_input_try(path, separator, encoding);
    if (in->problem[0] != '\0')
        csv_input_fail(in);
    return in;
}

static csv_event stop(csv_input *in, int64_t line, const char *why)
{
    const char *name = csv_input_name(in);
    snprintf(in->problem, PROBLEM, "%.400s: line %" PRId64 ": %s", name, line, why);
    return CSV_FAILED;
}

static bool ends_line(char c)
{
    return c == '\n' || c == '\r';
}

/* The length of the first line with its end; a return and a line feed are two ends. */
static size_t line_length(const char *bytes, size_t count)
{
    size_t i = 0;
    while (i < count && !ends_line(bytes[i]))
        i++;
    return i + (i < count ? 1 : 0);
}

/* Whether there are tabs between the cells of the first row, but not the separator. */
static bool has_tabs_only(const char *bytes, size_t count, char separator)
{
    bool quoted = false, tabs = false;
    for (size_t i = 0; i < count && (quoted || strchr("\r\n", bytes[i]) == NULL); i++) {
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
    const char *line = in->block;
    const size_t length = line_length(line, in->end), before = sizeof says - 1;
    in->at_start = false;
    if (length > before + 1 && strncasecmp(line, says, before) == 0 &&
        strchr(",;\t|", line[before]) != NULL && strchr("\r\n", line[before + 1]) != NULL) {
        csv_set_delim(&in->parser, (unsigned char)line[before]);
        in->begin = before + 1; /* a blank line is left */
    } else if (has_tabs_only(line, in->end, (char)csv_get_delim(&in->parser)))
        csv_set_delim(&in->parser, '\t');
}

static bool fill(csv_input *in)
{
    in->begin = 0;
    if (!text_input_read(in->source, in->block, BLOCK, &in->end)) {
        snprintf(in->problem, PROBLEM, "%s", text_input_problem(in->source));
        return false;
    }
    in->at_end = in->end == 0;
    if (in->at_start)
        find_separator(in);
    return true;
}

/* ---- Rows ---- */

/* A quote that is closed nowhere, or where it cannot be: no one knows which rows it has taken. */
static csv_event not_closed(csv_input *in)
{
    return stop(in, in->first_line, "a quote that is not closed");
}

/* Where the next byte stands. */
typedef enum { CELL_BEGINS, CELL_PLAIN, CELL_QUOTED, CELL_AFTER_QUOTE } position;

static position after_byte(position at, char byte, char separator)
{
    if (at == CELL_QUOTED)
        return byte == '"' ? CELL_AFTER_QUOTE : CELL_QUOTED;
    if (byte == separator || ends_line(byte))
        return CELL_BEGINS;
    return byte == '"' && at != CELL_PLAIN ? CELL_QUOTED : CELL_PLAIN;
}

/* How many bytes of the block belong to the row: up to its end, or all. */
static size_t row_bytes(csv_input *in, position *at, bool *ends)
{
    const char separator = csv_input_separator(in);
    size_t i = in->begin;
    for (*ends = false; i < in->end && !*ends; i++) {
        const char byte = in->block[i];
        const bool is_end = ends_line(byte), same_end = in->after_return && byte == '\n';
        *at = after_byte(*at, byte, separator);
        *ends = is_end && *at == CELL_BEGINS;
        in->line += is_end && !same_end;
        in->after_return = byte == '\r';
    }
    return i - in->begin;
}

/* The lines of a row; an empty one where there is a blank line. The last may lack its end. */
static csv_event read_lines(csv_input *in)
{
    position at = CELL_BEGINS;
    in->length = 0;
    in->first_line = in->line;
    for (bool ends = false; !ends;) {
        if (in->begin == in->end && !in->at_end && !fill(in))
            return CSV_FAILED;
        if (in->begin == in->end)
            return at == CELL_QUOTED ? not_closed(in) : in->length > 0 ? CSV_ROW : CSV_END;
        const size_t count = row_bytes(in, &at, &ends);
        if (in->length + count > CSV_ROW_BYTES)
            return at == CELL_QUOTED && in->line > in->first_line
                       ? not_closed(in)
                       : stop(in, in->first_line, "a line of more than 1 MiB; allowed: CSV");
        make_room(&in->row, &in->row_room, in->length, count + 1); /* and for what may end it */
        memcpy(in->row + in->length, in->block + in->begin, count);
        in->length += count;
        in->begin += count;
    }
    return CSV_ROW;
}

/* What the parser still holds of a row with misplaced quotes is thrown away. */
static csv_event refuse(csv_input *in)
{
    const char separator = csv_input_separator(in);
    if (csv_error(&in->parser) == CSV_ENOMEM) /* no fault of the row */
        failure("out of memory");
    csv_free(&in->parser);
    start_parser(in, separator);
    return csv_input_spans_lines(in) ? not_closed(in) : CSV_MALFORMED;
}

static csv_event next_row(csv_input *in)
{
    csv_event event = read_lines(in);
    if (event != CSV_ROW)
        return event;
    in->count = in->used = 0;
    in->row[in->length] = '\n';
    if (csv_parse(&in->parser, in->row, in->length + 1, take_cell, NULL, in) != in->length + 1)
        event = refuse(in);
    if (in->too_many)
        return stop(in, in->first_line, "more than 1000 cells in a row");
    for (size_t i = 0; i < in->count; i++)
        in->cell[i] = in->text + in->begins[i];
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
    csv_event event;
    if (in->problem[0] != '\0')
        return CSV_FAILED;
    do
        event = next_row(in);
    while (event == CSV_ROW && is_blank(in));
    return event;
}

bool csv_input_spans_lines(csv_input *in)
{
    return strpbrk(csv_input_row(in), "\r\n") != NULL;
}

csv_event csv_input_stop(csv_input *in, const char *why)
{
    return stop(in, in->first_line, why);
}

void csv_input_fail(const csv_input *in)
{
    if (in->problem[0] != '\0')
        failure("%s", in->problem);
    failure("%s: line %" PRId64 ": misplaced quotes", csv_input_name(in), in->first_line);
}

const char *csv_input_problem(const csv_input *in)
{
    return in->problem;
}

size_t csv_input_count(const csv_input *in)
{
    return in->count;
}

const char *const *csv_input_cells(const csv_input *in)
{
    return in->cell;
}

const char *csv_input_row(csv_input *in)
{
    size_t length = in->length;
    if (in->row == NULL)
        return "";
    while (length > 0 && strchr("\r\n", in->row[length - 1]) != NULL)
        length--;
    in->row[length] = '\0';
    return in->row;
}

int64_t csv_input_line(const csv_input *in)
{
    return in->first_line;
}

const char *csv_input_name(const csv_input *in)
{
    return text_input_name(in->source);
}

char csv_input_separator(csv_input *in)
{
    return (char)csv_get_delim(&in->parser);
}

bool csv_input_has_mark(const csv_input *in)
{
    return text_input_has_mark(in->source);
}

void csv_input_close(csv_input *in)
{
    csv_free(&in->parser);
    text_input_close(in->source);
    free(in->row);
    free(in->text);
    free(in);
}
