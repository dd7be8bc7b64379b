/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "page.h"

#include <inttypes.h>
#include <math.h>
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
        if (to.is_guided)
            json_add("{'tilts':[%n]}", to.tilt);
        if (to.is_driven)
            json_add("{'displacements':[%n]}", to.displacement);
    }
    if (loads->count > 0 && loads->load->to.is_driven)
        json_add("{'compliance':%n}", loads->compliance);
    json_add("{'unused':%t}", loads->unused.text);
}

/* The names of a table without: P and Q, or all four; NULL for another number of columns. */
static const char *const *usual_names(size_t count)
{
    static const char *const names[][4] = {{"P", "Q"}, {"P", "M", "Q", "sigma"}};
    return count == 2 ? names[0] : count == 4 ? names[1] : NULL;
}

static bool find_columns(void *context, header *names, complaint *why)
{
    (void)context;
    return load_header_find(names, why);
}

static bool take_row(const table_input *rows, load_list *loads)
{
    load to;
    complaint why = {"misplaced quotes"};
    const csv_row *row = &rows->in->row;
    if (row->malformed ||
        !load_row_read(&rows->names, row->cell, row->count, '\0', rows->decimal_sign, &to, &why))
        return json_refuse("", "line %" PRId64 ": %s", row->line, why.text);
    to.compliance = loads->compliance;
    load_list_add(loads, to, (int)row->line);
    return true;
}

static bool take_rows(table_input *rows, load_list *loads)
{
    while (table_next(rows)) {
        if (!take_row(rows, loads))
            return false;
        header_note_unused(&rows->names, rows->in->row.cell);
    }
    loads->unused = rows->remark;
    if (!isnan(loads->compliance) && header_has_input(&rows->names, INPUT_Q))
        list_add(loads->unused.text, sizeof loads->unused.text, "; ",
                 "column Q is not used: the displacement stands in its place");
    header_write_unused(&rows->names, loads->unused.text, sizeof loads->unused.text);
    return rows->in->problem.text[0] != '\0' || loads->count > 0 ||
           json_refuse("", "no loads below the names");
}

/* The compliance of the form, if it has one. */
static bool take_compliance(char decimal_sign, load_list *loads)
{
    complaint why;
    const char *text = field_compliance();
    loads->compliance = NAN;
    return text == NULL ||
           loads_read_compliance(text, decimal_sign, field_units(), &loads->compliance, &why) ||
           json_refuse("compliance", "%s", why.text);
}

bool load_list_read(const char *text, char decimal_sign, load_list *loads)
{
    static table_input rows;
    if (!take_compliance(decimal_sign, loads))
        return false;
    const reading how = {.decimal_sign = decimal_sign,
                         .units = field_units(),
                         .is_driven = !isnan(loads->compliance)};
    const table_wanted wanted = {
        .find = find_columns, .usual = usual_names, .takes_malformed = true};
    pasted_offer(text);
    const bool open = table_open("", &how, &wanted, &rows);
    bool read = open && take_rows(&rows, loads);
    if (rows.in->problem.text[0] != '\0')
        read = json_refuse("", "%s", pasted_problem(&rows));
    table_close(&rows);
    return read;
}
