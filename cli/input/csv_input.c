/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The only file that knows libcsv. Callers ask for one row after the other, but libcsv's parser
 * calls back for whatever it is given. So it is given one line at a time: a line ends one row at
 * the most. */
#include "csv_input.h"

#include "text_input.h"
#include "text/message.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include <csv.h>

enum { BLOCK = 1 << 16 };

struct csv_input {
    text_input *source;
    struct csv_parser parser;
    char block[BLOCK];
    size_t begin, end; /* what of the block has not been parsed */
    bool at_start, at_end, skipping, row_ended, too_many, after_return;
    int64_t line, first_line; /* of the byte that comes next; of the row */
    const char *fault;        /* of a malformed row */
    char *row;                /* as it stands in the file */
    size_t pushed, row_room;
    size_t line_bytes, line_cells; /* of the row's first line, where it goes on; else 0 */
    size_t again, kept;            /* what of `row`, behind the row, is read once more */
    char *text;                    /* the cells of the row, each with its 0 */
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

static bool make_room(char **text, size_t *room, size_t used, size_t more)
{
    if (*room - used >= more)
        return true;
    char *larger = realloc(*text, 2 * (used + more));
    if (larger == NULL)
        return false;
    *text = larger;
    *room = 2 * (used + more);
    return true;
}

static void take_cell(void *bytes, size_t length, void *data)
{
    csv_input *in = data;
    if (in->count == CSV_ROW_CELLS || !make_room(&in->text, &in->room, in->used, length + 1)) {
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

/* The ending of a file whose columns are separated by tabs. */
static bool is_tsv(const char *path)
{
    const char *ending = strrchr(path, '.');
    return ending != NULL && strcasecmp(ending, ".tsv") == 0;
}

csv_input *csv_input_open(const char *path, char separator, const char *encoding)
{
    csv_input *in = calloc(1, sizeof *in);
    if (in == NULL || !start_parser(in, is_tsv(path) ? '\t' : separator)) {
        free(in);
        failure("out of memory");
        return NULL;
    }
    in->at_start = true;
    in->line = 1;
    in->source = text_input_open(path, encoding);
    if (in->source == NULL) {
        csv_input_close(in);
        return NULL;
    }
    return in;
}

static void stop(const csv_input *in, const char *why)
{
    failure("%s: line %" PRId64 ": %s", csv_input_name(in), in->line, why);
}

static bool ends_line(char c)
{
    return c == '\n' || c == '\r';
}

/* As far as the next end of a line, that included; a return and a line feed are two. */
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
    if (!text_input_read(in->source, in->block, BLOCK, &in->end))
        return false;
    in->at_end = in->end == 0;
    if (in->at_start)
        find_separator(in);
    return true;
}

/* ---- Rows ---- */

static void count_line(csv_input *in, const char *bytes, size_t length)
{
    const char last = bytes[length - 1];
    const bool same_end = in->after_return && length == 1; /* the feed that follows a return */
    if (last == '\r' || (last == '\n' && !same_end))
        in->line++;
    in->after_return = last == '\r';
}

/* What comes next, whether it is new or read once more. */
static const char *unread(const csv_input *in, size_t *count)
{
    const bool is_new = in->again == in->kept;
    *count = is_new ? in->end - in->begin : in->kept - in->again;
    return is_new ? in->block + in->begin : in->row + in->again;
}

/* Keeps what comes next as a part of the row. What is read once more stands further behind. */
static bool keep(csv_input *in, const char *bytes, size_t length)
{
    if (!make_room(&in->row, &in->row_room, in->pushed, length + 1)) {
        stop(in, "out of memory");
        return false;
    }
    memmove(in->row + in->pushed, bytes, length);
    in->pushed += length;
    if (in->again == in->kept)
        in->begin += length;
    else
        in->again += length;
    return true;
}

/* After misplaced quotes, what the parser still holds is thrown away. */
static void restart(csv_input *in)
{
    const char separator = (char)csv_get_delim(&in->parser);
    csv_free(&in->parser);
    start_parser(in, separator);
}

static csv_event malformed(csv_input *in, const char *fault)
{
    in->fault = fault;
    restart(in);
    return CSV_MALFORMED;
}

/* Of a row over several lines with a fault, the first one is it. The others are read once more: an
 * open quote would cost all rows behind it. No line is read a third time: one that goes on with a
 * quote does not open one. */
static csv_event take_first_line(csv_input *in, const char *fault)
{
    const size_t more = in->pushed - in->line_bytes;
    if (in->again == in->kept)
        in->again = in->kept = in->pushed;
    in->again -= more;
    memmove(in->row + in->again, in->row + in->line_bytes, more);
    in->pushed = in->line_bytes;
    in->count = in->line_cells;
    in->line = in->first_line + 1;
    in->after_return = in->row[in->pushed - 1] == '\r';
    return malformed(in, fault);
}

/* The parser's own memory: no fault of the row. */
static bool is_out_of_memory(csv_input *in)
{
    const bool out = csv_error(&in->parser) == CSV_ENOMEM;
    if (out)
        stop(in, "out of memory");
    return out;
}

static const char misplaced[] = "misplaced quotes", not_closed[] = "a quote that is not closed";

/* A row goes on with the next line where a quote is open. */
static void end_line(csv_input *in)
{
    if (in->row_ended)
        return;
    if (in->count == 0 && in->parser.entry_pos == 0 && in->parser.quoted == 0) {
        in->first_line = in->line; /* a blank line */
        in->pushed = 0;
    } else if (in->line_bytes == 0) {
        in->line_bytes = in->pushed;
        in->line_cells = in->count;
    }
}

static csv_event refuse_length(csv_input *in)
{
    if (in->line_bytes > 0)
        return take_first_line(in, not_closed);
    stop(in, "a line of more than 1 MiB; allowed: CSV");
    return CSV_FAILED;
}

/* Pushes one line, or as much of it as there is. */
static csv_event push(csv_input *in)
{
    size_t count;
    const char *bytes = unread(in, &count);
    const size_t length = line_length(bytes, count);
    if (in->pushed + length > CSV_ROW_BYTES)
        return refuse_length(in);
    if (!keep(in, bytes, length))
        return CSV_FAILED;
    bytes = in->row + in->pushed - length;
    const bool ends = ends_line(bytes[length - 1]);
    const bool refused =
        !in->skipping && csv_parse(&in->parser, bytes, length, take_cell, end_row, in) != length;
    if (refused && is_out_of_memory(in))
        return CSV_FAILED;
    if (refused && in->line_bytes > 0)
        return take_first_line(in, misplaced);
    count_line(in, bytes, length);
    if (refused || in->skipping) {
        in->skipping = !ends;
        return ends ? malformed(in, misplaced) : CSV_ROW;
    }
    if (ends)
        end_line(in);
    return CSV_ROW;
}

/* The last row may lack its end of line. */
static csv_event finish(csv_input *in)
{
    if (in->skipping) {
        in->skipping = false;
        return malformed(in, misplaced);
    }
    if (csv_fini(&in->parser, take_cell, end_row, in) == 0)
        return in->row_ended ? CSV_ROW : CSV_END;
    if (is_out_of_memory(in))
        return CSV_FAILED;
    return in->line_bytes > 0 ? take_first_line(in, not_closed) : malformed(in, not_closed);
}

static csv_event next_row(csv_input *in)
{
    in->count = in->used = in->pushed = in->line_bytes = in->line_cells = 0;
    in->row_ended = in->too_many = false;
    in->first_line = in->line;
    csv_event event = CSV_ROW;
    while (!in->row_ended && event == CSV_ROW && !in->too_many) {
        size_t count;
        unread(in, &count);
        if (count == 0 && !in->at_end && !fill(in))
            return CSV_FAILED;
        unread(in, &count);
        event = count > 0 ? push(in) : finish(in);
    }
    if (in->too_many) {
        stop(in, "more than 1000 cells in a row, or out of memory");
        return CSV_FAILED;
    }
    return event;
}

static bool is_blank(const csv_input *in)
{
    for (size_t i = 0; i < in->count; i++)
        if (csv_input_cell(in, i)[strspn(csv_input_cell(in, i), " \t")] != '\0')
            return false;
    return true;
}

csv_event csv_input_next(csv_input *in)
{
    csv_event event;
    do
        event = next_row(in);
    while (event == CSV_ROW && is_blank(in));
    return event;
}

bool csv_input_take_line(csv_input *in)
{
    if (in->line_bytes == 0)
        return false;
    take_first_line(in, "a quote over several lines, and too few or too many cells,");
    return true;
}

const char *csv_input_fault(const csv_input *in)
{
    return in->fault;
}

size_t csv_input_count(const csv_input *in)
{
    return in->count;
}

const char *csv_input_cell(const csv_input *in, size_t i)
{
    return in->text + in->cell[i];
}

const char *csv_input_row(csv_input *in)
{
    size_t length = in->pushed;
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

const char *csv_surplus_hint(size_t cells, size_t wanted, char separator)
{
    return cells > wanted && separator == ','
               ? "; with decimal commas, separate the cells by ';' and give --decimal-comma"
               : "";
}

bool csv_input_has_mark(const csv_input *in)
{
    return text_input_has_mark(in->source);
}

void csv_input_close(csv_input *in)
{
    if (in == NULL)
        return;
    csv_free(&in->parser);
    text_input_close(in->source);
    free(in->row);
    free(in->text);
    free(in);
}
