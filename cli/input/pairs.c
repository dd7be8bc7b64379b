/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "input.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

/* A file that is read. */
typedef struct {
    csv_input *in;
    const pair_columns *wanted;
    char decimal_sign;
    header names;
    size_t column[2];
    pairs *to;
} reading;

/* ---- The first row ---- */

/* Either the second column or what may stand for it. */
static bool find_second(reading *r, complaint *why)
{
    const char *second = r->wanted->second, *other = r->wanted->instead;
    const size_t none = r->names.count;
    size_t instead = none;
    if (!header_column(&r->names, second, &r->column[1], why) ||
        (other != NULL && !header_column(&r->names, other, &instead, why)))
        return false;
    if (r->column[1] < none && instead < none)
        return complain(why, "column %s: given together with %s; allowed: one of the two", other,
                        second);
    r->to->column = instead < none ? other : second;
    r->column[1] = instead < none ? instead : r->column[1];
    return true;
}

static bool find_columns(reading *r, const char *const names[], size_t count)
{
    complaint why;
    header_find(names, count, 0, 0, NULL, &r->names, &why);
    if (!header_column(&r->names, r->wanted->first, &r->column[0], &why) || !find_second(r, &why))
        return csv_input_stop(r->in, "%s", why.text);
    for (int i = 0; i < 2; i++) {
        if (r->column[i] == r->names.count)
            return csv_input_stop(r->in, "column %s: missing; needed: %s%s",
                                  i == 0 ? r->wanted->first : r->wanted->second, r->wanted->needed,
                                  header_hint(r->names.name, r->names.count));
        r->names.is_used[r->column[i]] = true;
    }
    return true;
}

/* ---- Rows ---- */

static bool refuse_row(const reading *r, const char *reason)
{
    return csv_input_stop(r->in, "line %" PRId64 ": %s", r->in->row.line, reason);
}

static bool read_row(reading *r)
{
    double value[2];
    pairs *to = r->to;
    complaint why;
    const csv_row *row = &r->in->row;
    if (!header_fits(r->names.count, row->count, r->in->separator, &why))
        return refuse_row(r, why.text);
    for (int i = 0; i < 2; i++)
        if (!cell_read(row->cell[r->column[i]], i == 0 ? r->wanted->first : to->column,
                       r->decimal_sign, &value[i], &why))
            return refuse_row(r, why.text);
    if (r->wanted->complaint_about != NULL &&
        r->wanted->complaint_about(value[0], value[1]) != NULL)
        return refuse_row(r, r->wanted->complaint_about(value[0], value[1]));
    if (to->count == r->wanted->most)
        return csv_input_stop(r->in, "more than %zu %s", r->wanted->most, r->wanted->rows);
    header_note_unused(&r->names, row->cell);
    to->first = memory_for_one_more(to->first, to->count, sizeof *to->first);
    to->second = memory_for_one_more(to->second, to->count, sizeof *to->second);
    to->line = memory_for_one_more(to->line, to->count, sizeof *to->line);
    to->first[to->count] = value[0];
    to->second[to->count] = value[1];
    to->line[to->count++] = row->line;
    return true;
}

/* The first row has the names, or numbers where names may be missing. */
static bool read_first(reading *r, csv_row *first)
{
    const char *const *usual = r->wanted->usual;
    double number;
    if (!csv_input_header(r->in, first))
        return false;
    if (usual != NULL && number_read_cell(first->cell[0], r->decimal_sign, &number))
        return find_columns(r, usual, 2) && read_row(r);
    return find_columns(r, first->cell, first->count);
}

void pairs_read(const char *path, const char *encoding, char decimal_sign,
                const pair_columns *wanted, pairs *to)
{
    *to = (pairs){.count = 0};
    reading r = {.in = csv_input_open(path, decimal_sign == ',' ? ';' : ',', encoding),
                 .wanted = wanted,
                 .decimal_sign = decimal_sign,
                 .to = to};
    csv_row first = {.cell = NULL};
    if (read_first(&r, &first))
        while (csv_input_next(r.in) && read_row(&r))
            continue;
    if (r.in->problem.text[0] == '\0' && to->count == 0)
        csv_input_stop(r.in, "no %s; needed: rows of %s and %s", wanted->rows, wanted->first,
                       to->column);
    header_write_unused(&r.names, to->unused.text, sizeof to->unused.text);
    csv_row_free(&first);
    to->problem = r.in->problem;
    csv_input_close(r.in);
}

void pairs_free(pairs *all)
{
    free(all->first);
    free(all->second);
    free(all->line);
    *all = (pairs){.count = 0};
}
