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

/* What callers see comes first. */
typedef struct {
    csv_input seen;
    text_input *text;
    struct csv_parser parser;
    char block[BLOCK];
    size_t begin, end; /* what of the block has not been parsed */
    bool at_start, after_return;
    bool is_scanning;              /* the block that was read first is all there is */
    bool has_own;                  /* the file says how its cells are separated */
    size_t first_begin, first_end; /* of what is scanned */
    bool is_quoted, in_line;       /* for runs of blanks */
    bool has_ended, too_many;      /* of the row */
    int64_t next_line;
    size_t length, used;
    char row[CSV_ROW_BYTES + 2];   /* as it stands in the file */
    char cells[CSV_ROW_BYTES + 2]; /* each with a 0, which takes the place of what ended it */
    const char *cell[CSV_ROW_CELLS];
} reader;

/* ---- What libcsv calls ---- */

/* Spaces belong to their cell, as RFC 4180 has it. */
static int is_space(unsigned char c)
{
    (void)c;
    return 0;
}

static void take_cell(void *bytes, size_t length, void *of_reader)
{
    reader *in = of_reader;
    in->too_many = in->seen.row.count == CSV_ROW_CELLS;
    if (in->too_many)
        return;
    char *text = in->cells + in->used;
    in->cell[in->seen.row.count++] = text;
    if (length > 0)
        memcpy(text, bytes, length);
    text[length] = '\0';
    in->used += length + 1;
}

static void take_end(int end, void *of_reader)
{
    (void)end;
    ((reader *)of_reader)->has_ended = true;
}

/* ---- Opening and reading ---- */

static void separate_by(reader *in, char separator)
{
    in->seen.separator = separator;
    csv_set_delim(&in->parser, separator == CSV_BLANKS ? '\t' : (unsigned char)separator);
}

static void start_parser(reader *in)
{
    csv_init(&in->parser, CSV_STRICT);
    csv_set_space_func(&in->parser, is_space);
    separate_by(in, in->seen.separator);
}

csv_input *csv_input_open(const char *path, char separator, const char *encoding)
{
    reader *in = memory_zeroed(1, sizeof *in);
    const char *ending = strrchr(path, '.');
    const bool is_tsv = ending != NULL && strcasecmp(ending, ".tsv") == 0;
    in->text = text_input_open(path, encoding);
    in->at_start = true;
    in->next_line = 1;
    in->seen.row.cell = in->cell;
    in->seen.row.whole = in->row;
    in->seen.name = in->text->name;
    in->seen.separator = is_tsv ? '\t' : separator;
    in->has_own = is_tsv;
    start_parser(in);
    in->seen.problem = in->text->problem;
    return &in->seen;
}

bool csv_input_stop(csv_input *in, const char *format, ...)
{
    va_list values;
    const int used = snprintf(in->problem.text, sizeof in->problem.text, "%.300s: ", in->name);
    va_start(values, format);
    vsnprintf(in->problem.text + used, sizeof in->problem.text - (size_t)used, format, values);
    va_end(values);
    return false;
}

static bool stop(reader *in, const char *why)
{
    return csv_input_stop(&in->seen, "line %" PRId64 ": %s", in->seen.row.line, why);
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
static void find_separator(reader *in)
{
    static const char says[] = "sep=";
    const char *line = in->block;
    const size_t before = sizeof says - 1;
    in->at_start = false;
    if (in->end > before + 1 && strncasecmp(line, says, before) == 0 &&
        strchr(",;\t|", line[before]) != NULL && strchr("\r\n", line[before + 1]) != NULL) {
        separate_by(in, line[before]);
        in->has_own = true;
        in->begin = before + 1; /* a blank line is left */
    } else if (has_tabs_only(line, in->end, in->seen.separator))
        separate_by(in, '\t');
}

/* ---- Rows ---- */

/* A quote that is closed nowhere, or where it cannot be: no one knows which rows it has taken. */
static bool not_closed(reader *in)
{
    return stop(in, "a quote that is not closed");
}

/* Fills the block where all of it has been parsed. False at the end of the file, or where there is
 * a problem. */
static bool has_bytes(reader *in)
{
    if (in->begin < in->end)
        return true;
    if (in->is_scanning)
        return false;
    const bool is_read = text_input_read(in->text, in->block, BLOCK, &in->end);
    in->begin = 0;
    in->seen.problem = in->text->problem;
    in->seen.has_mark = in->text->has_mark;
    if (is_read && in->at_start)
        find_separator(in);
    return is_read && in->end > 0;
}

static bool is_blank_byte(char byte)
{
    return byte == ' ' || byte == '\t';
}

/* Whether a run of blanks separates two cells; it is passed over. */
static bool pass_blanks(reader *in)
{
    bool any = false;
    while (has_bytes(in) && is_blank_byte(in->block[in->begin])) {
        in->begin++;
        any = true;
    }
    return any && in->in_line && in->begin < in->end && !ends_line(in->block[in->begin]);
}

/* False at the end of the file, or where there is a problem. */
static bool next_byte(reader *in, char *byte)
{
    if (in->seen.separator == CSV_BLANKS && !in->is_quoted && pass_blanks(in)) {
        *byte = '\t';
        return true;
    }
    if (!has_bytes(in))
        return false;
    *byte = in->block[in->begin++];
    in->next_line += ends_line(*byte) && !(in->after_return && *byte == '\n');
    in->after_return = *byte == '\r';
    in->is_quoted = in->is_quoted != (*byte == '"');
    in->in_line = !ends_line(*byte);
    return true;
}

/* The bytes of a row that begins with this one. The last may lack its end. After misplaced quotes
 * the rest of the line is left out. */
static bool read_row(reader *in, char byte)
{
    bool *malformed = &in->seen.row.malformed;
    for (bool more = true;; more = next_byte(in, &byte)) {
        if (in->seen.problem.text[0] != '\0')
            return false;
        byte = more ? byte : '\n';
        in->row[in->length++] = byte;
        *malformed = *malformed || csv_parse(&in->parser, &byte, 1, take_cell, take_end, in) != 1;
        if (*malformed && csv_error(&in->parser) == CSV_ENOMEM) /* no fault of the row */
            failure("out of memory");
        in->has_ended = in->has_ended || (*malformed && ends_line(byte));
        if (in->has_ended)
            return true;
        if (!more)
            return not_closed(in);
        if (in->length > CSV_ROW_BYTES)
            return in->next_line > in->seen.row.line
                       ? not_closed(in)
                       : stop(in, "a line of more than 1 MiB; allowed: CSV");
    }
}

/* Blank lines are no rows. */
static bool next_row(reader *in)
{
    char byte;
    in->seen.row.count = in->length = in->used = 0;
    in->seen.row.malformed = in->has_ended = in->too_many = false;
    do
        if (!next_byte(in, &byte))
            return false;
    while (ends_line(byte));
    in->seen.row.line = in->next_line;
    if (!read_row(in, byte))
        return false;
    while (in->length > 0 && ends_line(in->row[in->length - 1]))
        in->length--;
    in->row[in->length] = '\0';
    if (in->too_many)
        return stop(in, "more than 1000 cells in a row");
    if (!in->seen.row.malformed)
        return true;
    csv_free(&in->parser); /* what it still holds of the row is thrown away */
    start_parser(in);
    if (strpbrk(in->row, "\r\n") != NULL) /* over several lines */
        return not_closed(in);
    return in->seen.takes_malformed || stop(in, "misplaced quotes");
}

static bool is_blank(const csv_row *row)
{
    for (size_t i = 0; i < row->count; i++)
        if (row->cell[i][strspn(row->cell[i], " \t")] != '\0')
            return false;
    return !row->malformed;
}

bool csv_input_next(csv_input *in)
{
    bool there = in->problem.text[0] == '\0' && next_row((reader *)in);
    while (there && is_blank(&in->row))
        there = next_row((reader *)in);
    return there;
}

/* ---- Looking ahead ---- */

static void start_anew(reader *in, char separator)
{
    csv_free(&in->parser);
    start_parser(in);
    separate_by(in, in->has_own ? in->seen.separator : separator);
    in->begin = in->first_begin;
    in->end = in->first_end;
    in->next_line = 1;
    in->after_return = in->is_quoted = in->in_line = false;
    in->seen.problem.text[0] = '\0';
}

bool csv_input_scan(csv_input *seen, char separator)
{
    reader *in = (reader *)seen;
    if (seen->problem.text[0] != '\0' && !in->is_scanning)
        return false;
    if (!in->is_scanning) {
        if (!has_bytes(in))
            return false;
        in->first_begin = in->begin;
        in->first_end = in->end;
        in->is_scanning = seen->takes_malformed = true;
    }
    start_anew(in, separator);
    return true;
}

void csv_input_begin(csv_input *seen, char separator)
{
    reader *in = (reader *)seen;
    if (!in->is_scanning)
        return;
    start_anew(in, separator);
    in->is_scanning = false;
}

bool csv_input_names_separator(const csv_input *in)
{
    return ((const reader *)in)->has_own;
}

char csv_input_guess(const csv_input *seen, char usual)
{
    const reader *in = (const reader *)seen;
    return in->has_own ? seen->separator
           : has_tabs_only(in->block + in->first_begin, in->first_end - in->first_begin, usual)
               ? '\t'
               : usual;
}

bool csv_input_header(csv_input *in, csv_row *row)
{
    const bool there = csv_input_next(in);
    if (in->problem.text[0] != '\0')
        return false;
    if (!there || in->row.malformed)
        return csv_input_stop(in, "%s; needed: a header row with the names of the columns",
                              there ? "misplaced quotes in the first row" : "empty");
    csv_row_keep(in, row);
    return true;
}

void csv_input_check(const csv_input *in)
{
    if (in->problem.text[0] != '\0')
        failure("%s", in->problem.text);
}

void csv_input_close(csv_input *seen)
{
    reader *in = (reader *)seen;
    csv_free(&in->parser);
    text_input_close(in->text);
    free(in);
}

/* ---- A row that stays ---- */

/* One piece of memory: the places of the cells, and their texts behind them. */
void csv_row_keep(const csv_input *seen, csv_row *row)
{
    const reader *in = (const reader *)seen;
    const size_t places = (seen->row.count + 1) * sizeof *row->cell, length = in->length + 1;
    *row = seen->row;
    row->bytes = places + in->used + length;
    row->cell = memory_resized(NULL, row->bytes);
    char *text = (char *)row->cell + places;
    if (in->used > 0)
        memcpy(text, in->cells, in->used);
    for (size_t i = 0; i < row->count; i++)
        row->cell[i] = text + (in->cell[i] - in->cells);
    row->whole = memcpy(text + in->used, in->row, length);
}

void csv_row_free(csv_row *row)
{
    free(row->cell);
    row->cell = NULL;
}

char *csv_row_fault(const csv_row *row, size_t columns, const char *why)
{
    const bool is_hidden = row->malformed || row->count > columns;
    const size_t size = strlen(why) + strlen(row->whole) + 3;
    char *fault = memory_zeroed(size, 1);
    snprintf(fault, size, "%s%s%s", why, is_hidden ? ": " : "", is_hidden ? row->whole : "");
    return fault;
}
