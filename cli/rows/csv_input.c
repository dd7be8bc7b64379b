/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The only file that knows libcsv. Callers ask for one row after the other, but libcsv's parser
 * calls back for whatever it is given. So it is given one line at a time: a line ends one row at
 * the most. */
#include "csv_input.h"

#include "text/message.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <csv.h>

enum { BLOCK = 1 << 16 };

struct csv_input {
    const char *name;
    FILE *file;
    struct csv_parser parser;
    unsigned char block[BLOCK];
    size_t begin, end; /* what of the block has not been parsed */
    bool at_start, at_end, skipping, row_ended, in_row, too_many, after_return;
    int64_t line, first_line; /* of the byte that comes next; of the row */
    size_t pushed;            /* bytes of the row */
    char *text;               /* the cells of the row, each with its 0 */
    size_t used, room;
    size_t cell[CSV_ROW_CELLS]; /* where each starts */
    size_t count;
};

/* ---- What libcsv calls ---- */

/* Spaces belong to their cell, as RFC 4180 has it. */
static int is_space(unsigned char c)
{
    (void)c;
    return 0;
}

static bool make_room(csv_input *in, size_t more)
{
    if (in->room - in->used >= more)
        return true;
    const size_t room = 2 * (in->used + more);
    char *text = realloc(in->text, room);
    if (text == NULL)
        return false;
    in->text = text;
    in->room = room;
    return true;
}

static void take_cell(void *bytes, size_t length, void *data)
{
    csv_input *in = data;
    if (in->count == CSV_ROW_CELLS || !make_room(in, length + 1)) {
        in->too_many = true;
        return;
    }
    in->cell[in->count++] = in->used;
    if (length > 0)
        memcpy(in->text + in->used, bytes, length);
    in->text[in->used + length] = '\0';
    in->used += length + 1;
}

static void end_row(int terminator, void *data)
{
    (void)terminator;
    ((csv_input *)data)->row_ended = true;
}

/* ---- Opening and reading ---- */

static bool start_parser(csv_input *in, char separator)
{
    if (csv_init(&in->parser, CSV_STRICT | CSV_STRICT_FINI) != 0)
        return false;
    csv_set_delim(&in->parser, (unsigned char)separator);
    csv_set_space_func(&in->parser, is_space);
    return true;
}

csv_input *csv_input_open(const char *path, char separator)
{
    const bool standard = strcmp(path, "-") == 0;
    const char *name = standard ? "standard input" : path;
    csv_input *in = calloc(1, sizeof *in);
    if (in == NULL || !start_parser(in, separator)) {
        free(in);
        failure("out of memory");
        return NULL;
    }
    in->name = name;
    in->at_start = true;
    in->line = 1;
    in->file = standard ? stdin : fopen(path, "rb");
    if (in->file == NULL) {
        failure("%s: %s", name, strerror(errno));
        csv_input_close(in);
        return NULL;
    }
    return in;
}

static void stop(const csv_input *in, const char *why)
{
    failure("%s: line %" PRId64 ": %s", in->name, in->line, why);
}

/* The mark that some programs put before UTF-8. */
static void skip_mark(csv_input *in)
{
    static const unsigned char mark[] = {0xef, 0xbb, 0xbf};
    if (in->at_start && in->end >= sizeof mark && memcmp(in->block, mark, sizeof mark) == 0)
        in->begin = sizeof mark;
    in->at_start = false;
}

/* Fills the block, unless the file ends before. */
static bool fill(csv_input *in)
{
    in->begin = in->end = 0;
    do {
        clearerr(in->file);
        in->end += fread(in->block + in->end, 1, BLOCK - in->end, in->file);
    } while (ferror(in->file) && errno == EINTR);
    in->at_end = in->end < BLOCK;
    if (ferror(in->file)) {
        failure("%s: %s", in->name, strerror(errno));
        return false;
    }
    skip_mark(in);
    return true;
}

/* ---- Rows ---- */

/* As far as the next end of a line, that included; a return and a line feed are one. */
static size_t line_length(const csv_input *in)
{
    size_t i = in->begin;
    while (i < in->end && in->block[i] != '\n' && in->block[i] != '\r')
        i++;
    return i - in->begin + (i < in->end ? 1 : 0);
}

static void count_line(csv_input *in, const unsigned char *bytes, size_t length)
{
    const unsigned char last = bytes[length - 1];
    const bool same_end = in->after_return && length == 1; /* the feed that follows a return */
    if (last == '\r' || (last == '\n' && !same_end))
        in->line++;
    in->after_return = last == '\r';
}

static bool is_sane(csv_input *in, const unsigned char *bytes, size_t length)
{
    in->pushed += length;
    const bool binary = memchr(bytes, '\0', length) != NULL;
    if (binary)
        stop(in, "a NUL byte; allowed: CSV in UTF-8 or ASCII, neither binary files nor UTF-16");
    else if (in->pushed > CSV_ROW_BYTES)
        stop(in, "a row of more than 1 MiB; allowed: CSV whose quotes are closed");
    return !binary && in->pushed <= CSV_ROW_BYTES;
}

/* After misplaced quotes, what the parser still holds is thrown away. */
static void restart(csv_input *in)
{
    const char separator = (char)csv_get_delim(&in->parser);
    csv_free(&in->parser);
    start_parser(in, separator);
}

/* The parser's own memory: no fault of the row. */
static bool is_out_of_memory(csv_input *in)
{
    const bool out = csv_error(&in->parser) == CSV_ENOMEM;
    if (out)
        stop(in, "out of memory");
    return out;
}

/* Pushes one line, or as much of it as the block has. */
static csv_event push(csv_input *in)
{
    const unsigned char *bytes = in->block + in->begin;
    const size_t length = line_length(in);
    if (!is_sane(in, bytes, length))
        return CSV_FAILED;
    in->begin += length;
    const bool ends = bytes[length - 1] == '\n' || bytes[length - 1] == '\r';
    const bool malformed =
        !in->skipping && csv_parse(&in->parser, bytes, length, take_cell, end_row, in) != length;
    if (malformed && is_out_of_memory(in))
        return CSV_FAILED;
    count_line(in, bytes, length);
    if (malformed || in->skipping) {
        in->skipping = !ends;
        if (ends)
            restart(in);
        return ends ? CSV_MALFORMED : CSV_ROW;
    }
    if (ends && !in->row_ended && in->count == 0 && in->parser.entry_pos == 0 &&
        in->parser.quoted == 0) {
        in->first_line = in->line; /* a blank line */
        in->pushed = 0;
    }
    return CSV_ROW;
}

/* The last row may lack its end of line. */
static csv_event finish(csv_input *in)
{
    if (in->skipping) {
        in->skipping = false;
        return CSV_MALFORMED;
    }
    if (csv_fini(&in->parser, take_cell, end_row, in) != 0) {
        if (is_out_of_memory(in))
            return CSV_FAILED;
        restart(in);
        return CSV_MALFORMED;
    }
    return in->row_ended ? CSV_ROW : CSV_END;
}

csv_event csv_input_next(csv_input *in)
{
    in->count = in->used = in->pushed = 0;
    in->row_ended = in->too_many = false;
    in->first_line = in->line;
    csv_event event = CSV_ROW;
    while (!in->row_ended && event == CSV_ROW && !in->too_many) {
        if (in->begin == in->end && !in->at_end && !fill(in))
            return CSV_FAILED;
        event = in->begin < in->end ? push(in) : finish(in);
    }
    if (in->too_many) {
        stop(in, "more than 1000 cells in a row, or out of memory");
        return CSV_FAILED;
    }
    return event;
}

size_t csv_input_count(const csv_input *in)
{
    return in->count;
}

const char *csv_input_cell(const csv_input *in, size_t i)
{
    return in->text + in->cell[i];
}

int64_t csv_input_line(const csv_input *in)
{
    return in->first_line;
}

const char *csv_input_name(const csv_input *in)
{
    return in->name;
}

void csv_input_close(csv_input *in)
{
    if (in == NULL)
        return;
    csv_free(&in->parser);
    if (in->file != NULL && in->file != stdin)
        fclose(in->file);
    free(in->text);
    free(in);
}
