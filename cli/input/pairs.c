/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "input.h"

#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A file that is read. */
typedef struct {
    csv_input *in;
    const pair_columns *wanted;
    char decimal_sign;
    header names;
    bool unused[HEADER_COLUMNS];
    size_t column[2];
    pairs *to;
} reading;

static bool refuse(const reading *r, const char *format, ...) PRINTF_LIKE(2, 3);

static bool refuse(const reading *r, const char *format, ...)
{
    va_list values;
    char *problem = r->to->problem;
    const size_t size = sizeof r->to->problem;
    const int used = snprintf(problem, size, "%.300s: ", csv_input_name(r->in));
    va_start(values, format);
    vsnprintf(problem + used, size - (size_t)used, format, values);
    va_end(values);
    return false;
}

/* ---- The first row ---- */

/* The column of that name; how many there are where it is not there. */
static bool find_column(reading *r, const char *name, size_t *column)
{
    *column = r->names.count;
    for (size_t c = 0; name != NULL && c < r->names.count; c++) {
        if (strcmp(r->names.name[c], name) != 0)
            continue;
        if (*column < c)
            return refuse(r, "column %s: there twice; allowed: once", name);
        *column = c;
        r->names.is_used[c] = true;
    }
    return true;
}

static bool find_second(reading *r)
{
    size_t instead;
    if (!find_column(r, r->wanted->second, &r->column[1]) ||
        !find_column(r, r->wanted->instead, &instead))
        return false;
    const bool is_there = r->column[1] < r->names.count, has_other = instead < r->names.count;
    if (is_there && has_other)
        return refuse(r, "column %s: given together with %s; allowed: one of the two",
                      r->wanted->instead, r->wanted->second);
    r->to->column = has_other ? r->wanted->instead : r->wanted->second;
    r->column[1] = has_other ? instead : r->column[1];
    return true;
}

static bool find_columns(reading *r, const csv_row *first)
{
    static const bool no_input[INPUT_COUNT] = {false};
    char complaint[COMPLAINT_SIZE];
    header_find(first->cell, first->count, no_input, NULL, &r->names, complaint);
    if (!find_column(r, r->wanted->first, &r->column[0]) || !find_second(r))
        return false;
    for (int i = 0; i < 2; i++)
        if (r->column[i] == r->names.count)
            return refuse(r, "column %s: missing; needed: %s%s",
                          i == 0 ? r->wanted->first : r->wanted->second, r->wanted->needed,
                          header_separator_hint(r->names.name, r->names.count));
    return true;
}

/* ---- Rows ---- */

static void add(pairs *to, double first, double second, int64_t line)
{
    to->first = memory_for_one_more(to->first, to->count, sizeof *to->first);
    to->second = memory_for_one_more(to->second, to->count, sizeof *to->second);
    to->line = memory_for_one_more(to->line, to->count, sizeof *to->line);
    to->first[to->count] = first;
    to->second[to->count] = second;
    to->line[to->count++] = line;
}

static bool refuse_row(const reading *r, const char *complaint)
{
    return refuse(r, "line %" PRId64 ": %s", csv_input_line(r->in), complaint);
}

static bool read_row(reading *r)
{
    double value[2];
    char complaint[COMPLAINT_SIZE];
    const char *const *cells = csv_input_cells(r->in);
    if (!header_fits(r->names.count, csv_input_count(r->in), csv_input_separator(r->in), complaint))
        return refuse_row(r, complaint);
    for (int i = 0; i < 2; i++) {
        const char *text = cells[r->column[i]];
        if (number_read_cell(text, r->decimal_sign, &value[i]))
            continue;
        snprintf(complaint, COMPLAINT_SIZE, "%s %.60s: must be a number, with a decimal %s",
                 i == 0 ? r->wanted->first : r->to->column, text,
                 r->decimal_sign == ',' ? "comma" : "point");
        return refuse_row(r, complaint);
    }
    if (r->wanted->complaint_about != NULL &&
        r->wanted->complaint_about(value[0], value[1]) != NULL)
        return refuse_row(r, r->wanted->complaint_about(value[0], value[1]));
    if (r->to->count == r->wanted->most)
        return refuse(r, "more than %zu %s", r->wanted->most, r->wanted->rows);
    header_note_unused(&r->names, cells, r->unused);
    add(r->to, value[0], value[1], csv_input_line(r->in));
    return true;
}

static bool read_rows(reading *r)
{
    csv_event event;
    while ((event = csv_input_next(r->in)) == CSV_ROW)
        if (!read_row(r))
            return false;
    if (event == CSV_FAILED)
        snprintf(r->to->problem, sizeof r->to->problem, "%s", csv_input_problem(r->in));
    else if (event == CSV_MALFORMED)
        refuse_row(r, "misplaced quotes");
    else if (r->to->count == 0)
        refuse(r, "no %s; needed: rows of %s and %s", r->wanted->rows, r->wanted->first,
               r->to->column);
    return r->to->problem[0] == '\0';
}

static void read_file(reading *r)
{
    csv_row first;
    const csv_event event = csv_input_next(r->in);
    if (event == CSV_FAILED)
        snprintf(r->to->problem, sizeof r->to->problem, "%s", csv_input_problem(r->in));
    else if (event != CSV_ROW)
        refuse(r, "%s; needed: a header row with the names of the columns",
               event == CSV_END ? "empty" : "misplaced quotes in the first row");
    if (event != CSV_ROW)
        return;
    csv_row_keep(r->in, false, &first);
    if (find_columns(r, &first) && read_rows(r))
        header_write_unused(&r->names, r->unused, r->to->unused, sizeof r->to->unused);
    csv_row_free(&first);
}

void pairs_read(const char *path, const char *encoding, char decimal_sign,
                const pair_columns *wanted, pairs *to)
{
    *to = (pairs){.count = 0};
    reading r = {.in = csv_input_try(path, decimal_sign == ',' ? ';' : ',', encoding),
                 .wanted = wanted,
                 .decimal_sign = decimal_sign,
                 .to = to};
    read_file(&r);
    csv_input_close(r.in);
}

void pairs_free(pairs *all)
{
    free(all->first);
    free(all->second);
    free(all->line);
    *all = (pairs){.count = 0};
}
