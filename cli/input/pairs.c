/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "input.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

/* The columns of a file. */
typedef struct {
    const pair_columns *wanted;
    const char *name; /* of the second */
    size_t column[2];
} pair_finding;

/* ---- The header ---- */

/* Either the second column or what may stand for it. */
static bool find_second(pair_finding *r, const header *names, complaint *why)
{
    const char *second = r->wanted->second, *other = r->wanted->instead;
    const size_t none = names->count;
    size_t instead = none;
    if (!header_column(names, second, &r->column[1], why) ||
        (other != NULL && !header_column(names, other, &instead, why)))
        return false;
    if (r->column[1] < none && instead < none)
        return complain(why, "column %s: given together with %s; allowed: one of the two", other,
                        second);
    r->name = instead < none ? other : second;
    r->column[1] = instead < none ? instead : r->column[1];
    return true;
}

static bool find_columns(void *of_finding, header *names, complaint *why)
{
    pair_finding *r = of_finding;
    const pair_columns *wanted = r->wanted;
    if (!header_column(names, wanted->first, &r->column[0], why) || !find_second(r, names, why))
        return false;
    for (int i = 0; i < 2; i++) {
        if (r->column[i] < names->count)
            continue;
        complain(why, "column %s: missing; needed: %s%s", i == 0 ? wanted->first : wanted->second,
                 wanted->needed, header_hint(names->name, names->count));
        header_write_names(names, why);
        return false;
    }
    header_note_labels(names);
    return header_need(names, r->column[0], wanted->first, "length", SHARE_NONE, NEED_PLACE, why) &&
           header_need(names, r->column[1], r->name,
                       r->name == wanted->instead ? wanted->other : wanted->dimension, SHARE_NONE,
                       NEED_NUMBER, why);
}

/* ---- Rows ---- */

static bool refuse_row(const table_input *t, const char *reason)
{
    return csv_input_stop(t->in, "line %" PRId64 ": %s", t->in->row.line, reason);
}

static bool read_row(table_input *t, const pair_finding *r, pairs *to)
{
    double value[2];
    complaint why;
    const csv_row *row = &t->in->row;
    if (!header_fits(t->names.count, row->count, t->in->separator, &why))
        return refuse_row(t, why.text);
    for (int i = 0; i < 2; i++)
        if (!header_cell(&t->names, row->cell, r->column[i], i == 0 ? r->wanted->first : to->column,
                         t->decimal_sign, &value[i], &why))
            return refuse_row(t, why.text);
    if (r->wanted->complaint_about != NULL &&
        r->wanted->complaint_about(value[0], value[1]) != NULL)
        return refuse_row(t, r->wanted->complaint_about(value[0], value[1]));
    if (to->count == r->wanted->most)
        return csv_input_stop(t->in, "more than %zu %s", r->wanted->most, r->wanted->rows);
    header_note_unused(&t->names, row->cell);
    to->first = memory_for_one_more(to->first, to->count, sizeof *to->first);
    to->second = memory_for_one_more(to->second, to->count, sizeof *to->second);
    to->line = memory_for_one_more(to->line, to->count, sizeof *to->line);
    to->first[to->count] = value[0];
    to->second[to->count] = value[1];
    to->line[to->count++] = row->line;
    return true;
}

void pairs_read(const char *path, const reading *how, const pair_columns *wanted, pairs *to)
{
    pair_finding r = {.wanted = wanted};
    const table_wanted needed = {
        .find = find_columns, .context = &r, .usual = wanted->usual, .counts_missing = true};
    table_input t;
    *to = (pairs){.count = 0};
    if (table_open(path, how, &needed, &t)) {
        to->column = r.name;
        while (table_next(&t) && read_row(&t, &r, to))
            continue;
        if (t.in->problem.text[0] == '\0' && to->count == 0)
            csv_input_stop(t.in, "no %s; needed: rows of %s and %s", wanted->rows, wanted->first,
                           to->column);
    }
    to->remark = t.remark;
    header_write_unused(&t.names, to->remark.text, sizeof to->remark.text);
    to->problem = t.in->problem;
    table_close(&t);
}

void pairs_free(pairs *all)
{
    free(all->first);
    free(all->second);
    free(all->line);
    *all = (pairs){.count = 0};
}
