/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "page.h"

#include <inttypes.h>
#include <stdlib.h>

void load_list_add(load_list *loads, load to, int line)
{
    loads->load = memory_for_one_more(loads->load, loads->count, sizeof *loads->load);
    loads->load[loads->count++] = (listed_load){to, line};
}

void load_list_free(load_list *loads)
{
    free(loads->load);
}

void load_list_write(const load_list *loads)
{
    for (size_t i = 0; i < loads->count; i++) {
        const load to = loads->load[i].to;
        json_add("{'loads':[{'P':%n,'M':%n,'Q':%n,'sigma':%n}]}", to.P, to.M, to.Q, to.sigma);
    }
    json_add("{'unused':%t}", loads->unused.text);
}

/* The names of a table without: P and Q, or all four; NULL for another number of columns. */
static const char *const *usual_names(size_t count)
{
    static const char *const names[][4] = {{"P", "Q"}, {"P", "M", "Q", "sigma"}};
    return count == 2 ? names[0] : count == 4 ? names[1] : NULL;
}

static bool is_load(const csv_row *row, char decimal_sign)
{
    double number;
    for (size_t i = 0; i < row->count; i++)
        if (!number_read_cell(row->cell[i], decimal_sign, &number))
            return false;
    return true;
}

static bool take_row(const header *names, const csv_row *row, char decimal_sign, load_list *loads)
{
    load to;
    complaint why = {"misplaced quotes"};
    if (row->malformed ||
        !load_row_read(names, row->cell, row->count, '\0', decimal_sign, &to, &why))
        return json_refuse("", "line %" PRId64 ": %s", row->line, why.text);
    load_list_add(loads, to, (int)row->line);
    return true;
}

static bool take_rows(csv_input *in, const csv_row *first, char decimal_sign, load_list *loads)
{
    header names;
    complaint why;
    const bool bare = usual_names(first->count) != NULL && is_load(first, decimal_sign);
    if (!load_header_find(bare ? usual_names(first->count) : first->cell, first->count, &names,
                          &why))
        return json_refuse("", "%s", why.text);
    bool taken = !bare || take_row(&names, first, decimal_sign, loads);
    while (taken && csv_input_next(in)) {
        taken = take_row(&names, &in->row, decimal_sign, loads);
        if (taken)
            header_note_unused(&names, in->row.cell);
    }
    if (taken)
        header_write_unused(&names, loads->unused.text, sizeof loads->unused.text);
    return taken && (loads->count > 0 || json_refuse("", "no loads below the names"));
}

bool load_list_read(const char *text, char decimal_sign, load_list *loads)
{
    csv_row first;
    csv_input *in = pasted_open(text, &first);
    bool read = first.cell != NULL && take_rows(in, &first, decimal_sign, loads);
    if (in->problem.text[0] != '\0' || first.cell == NULL)
        read = json_refuse("", "%s", in->problem.text);
    csv_row_free(&first);
    csv_input_close(in);
    return read;
}
