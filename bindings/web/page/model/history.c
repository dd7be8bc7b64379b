/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the page asks about a history of loads: a table of them, and the contact before the last
 * cycle. */
#include "answers.h"
#include "field_texts.h"
#include "pasted.h"
#include "records.h"

#include "model/reading/load_row.h"
#include "text/memory.h"
#include "number/number.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    load *load;
    int *line; /* of the pasted text; 0 where the form gives them */
    size_t count, room;
    char unused[COMPLAINT_SIZE]; /* columns with numbers */
} load_list;

static void add(load_list *loads, load to, int line)
{
    if (loads->count == loads->room) {
        loads->room = 2 * loads->room + 64;
        loads->load = memory_resized(loads->load, loads->room * sizeof *loads->load);
        loads->line = memory_resized(loads->line, loads->room * sizeof *loads->line);
    }
    loads->load[loads->count] = to;
    loads->line[loads->count++] = line;
}

/* ---- A table ---- */

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

static bool take_row(const header *names, const csv_row *row, char decimal_sign, load_list *loads,
                     char complaint[COMPLAINT_SIZE])
{
    load to;
    char why[COMPLAINT_SIZE] = "misplaced quotes";
    if (!row->malformed &&
        load_row_read(names, row->cell, row->count, '\0', decimal_sign, &to, why)) {
        add(loads, to, (int)row->line);
        return true;
    }
    snprintf(complaint, COMPLAINT_SIZE, "line %" PRId64 ": %.300s", row->line, why);
    return false;
}

static bool take_rows(csv_input *in, const csv_row *first, char decimal_sign, load_list *loads,
                      char complaint[COMPLAINT_SIZE])
{
    header names;
    csv_row row;
    const char *problem;
    bool unused[HEADER_COLUMNS] = {false};
    const bool bare = usual_names(first->count) != NULL && is_load(first, decimal_sign);
    bool taken = load_header_find(bare ? usual_names(first->count) : first->cell, first->count,
                                  &names, complaint) &&
                 (!bare || take_row(&names, first, decimal_sign, loads, complaint));
    while (taken && pasted_next(in, &row, &problem)) {
        taken = take_row(&names, &row, decimal_sign, loads, complaint);
        if (taken)
            header_note_unused(&names, row.cell, unused);
        csv_row_free(&row);
    }
    if (taken && problem[0] != '\0')
        snprintf(complaint, COMPLAINT_SIZE, "%s", problem);
    else if (taken && loads->count == 0)
        snprintf(complaint, COMPLAINT_SIZE, "no loads below the names");
    else if (taken)
        header_write_unused(&names, unused, loads->unused, sizeof loads->unused);
    return taken && problem[0] == '\0' && loads->count > 0;
}

static bool read_table(const char *text, char decimal_sign, load_list *loads,
                       char complaint[COMPLAINT_SIZE])
{
    csv_input *in = pasted_open(text);
    csv_row first = {0};
    const char *problem;
    bool read = pasted_next(in, &first, &problem);
    if (read)
        read = take_rows(in, &first, decimal_sign, loads, complaint);
    else
        snprintf(complaint, COMPLAINT_SIZE, "%s", problem);
    csv_row_free(&first);
    csv_input_close(in);
    return read;
}

/* ---- The form ---- */

/* P and M come first; then Q and sigma go to and fro. */
static bool to_and_fro(const load *form, rwedge_contact *contact, double f, load_list *loads,
                       char complaint[COMPLAINT_SIZE])
{
    const load before = {.P = form->P, .M = form->M};
    snprintf(complaint, COMPLAINT_SIZE,
             "Q or sigma of the form goes to and fro where no loads are given; both are 0");
    if ((form->Q == 0 && form->sigma == 0) || !loads_apply_next(before, f, contact, complaint))
        return false;
    add(loads, *form, 0);
    add(loads, (load){form->P, form->M, -form->Q, -form->sigma}, 0);
    return true;
}

/* ---- The history ---- */

static bool go_through(const load_list *loads, int64_t cycle, double f, rwedge_contact *contact,
                       char complaint[COMPLAINT_SIZE])
{
    char why[COMPLAINT_SIZE], place[60];
    for (size_t i = 0; i < loads->count; i++) {
        if (loads_apply_next(loads->load[i], f, contact, why))
            continue;
        snprintf(place, sizeof place,
                 cycle > 1 ? "line %d, cycle %" PRId64 ": " : "line %d: ", loads->line[i], cycle);
        snprintf(complaint, COMPLAINT_SIZE, "%s%.300s", loads->line[i] > 0 ? place : "", why);
        return false;
    }
    return true;
}

/* All cycles but the last are gone through, and that is tried. */
static bool go_on(const load_list *loads, int64_t cycles, double f, rwedge_contact *contact,
                  char complaint[COMPLAINT_SIZE])
{
    rwedge_contact *trial = NULL;
    bool gone = true;
    for (int64_t cycle = 1; gone && cycle < cycles; cycle++)
        gone = go_through(loads, cycle, f, contact, complaint);
    if (gone && rwedge_contact_copy(contact, &trial) == RWEDGE_OK)
        gone = go_through(loads, cycles, f, trial, complaint);
    rwedge_contact_destroy(trial);
    return gone;
}

static void write_loads(const load_list *loads)
{
    for (size_t i = 0; i < loads->count; i++) {
        records_add("load");
        records_number(loads->load[i].P);
        records_number(loads->load[i].M);
        records_number(loads->load[i].Q);
        records_number(loads->load[i].sigma);
    }
    records_add("unused");
    records_text(loads->unused);
}

static bool begin(const contact_case *setup, const load *form, const char *text, int decimal_sign,
                  load_list *loads, rwedge_contact **contact, char complaint[COMPLAINT_SIZE])
{
    snprintf(complaint, COMPLAINT_SIZE, "the contact cannot be made");
    if (case_contact(setup, contact) != RWEDGE_OK)
        return false;
    return text[0] != '\0' ? read_table(text, (char)decimal_sign, loads, complaint)
                           : to_and_fro(form, *contact, setup->f, loads, complaint);
}

/* Of the case of the form, and pasted loads, which are gone through so many times: its numbers, the
 * loads of the last cycle, columns that are not used, and the contact before that cycle; or what is
 * wrong. Without a text the loads of the form go to and fro. */
EXPORTED const char *page_history(char *lines, const char *text, int decimal_sign,
                                  const char *times)
{
    contact_case setup;
    load form;
    load_list loads = {0};
    rwedge_contact *contact = NULL;
    int64_t cycles;
    char complaint[COMPLAINT_SIZE];
    records_begin();
    if (answers_history(lines, &setup, &form)) {
        if (!number_read_whole(times, 1, 1000000, &cycles))
            records_refuse("cycles must be a whole number from 1 to 1000000");
        else if (!begin(&setup, &form, text, decimal_sign, &loads, &contact, complaint) ||
                 !go_on(&loads, cycles, setup.f, contact, complaint))
            records_refuse(complaint);
        else {
            write_loads(&loads);
            answers_keep(contact);
            contact = NULL;
        }
    }
    rwedge_contact_destroy(contact);
    free(loads.load);
    free(loads.line);
    return records_end();
}
