/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "batch.h"

#include "contact/notices.h"
#include "contact/table_header.h"
#include "system/ahead.h"
#include "text/message.h"
#include "text/number.h"
#include "system/progress.h"
#include "model/results.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* So many rows are held at a time, for threads to solve them; fewer where they are long. */
enum { HELD_ROWS = 1024, HELD_BYTES = 1 << 20 };

/* What goes on from row to row. */
typedef struct {
    const batch *what;
    const output_options *how;
    csv_input *in;
    csv_row first;
    header names;
    bool unused[HEADER_COLUMNS]; /* columns with numbers in any row that are not used */
    bool shown[RESULT_COUNT];    /* the results that become columns */
    records *rows;
    int64_t count, failed;
    int32_t doubts; /* of any row */
    csv_row *held;
    int64_t held_count;
} run;

static const char error_column[] = "error";

/* ---- Columns ---- */

/* The inputs of a row: constants, and its cells. */
static input_texts texts_of(const run *r, const char *const text[INPUT_COUNT])
{
    input_texts texts = r->what->constants;
    texts.cell_decimal_sign = r->how->decimal_sign;
    for (int i = 0; i < INPUT_COUNT; i++)
        if (r->what->constants.text[i] == NULL) {
            texts.text[i] = text[i];
            texts.is_cell[i] = true;
        }
    return texts;
}

static int check_constants(const run *r)
{
    for (int i = 0; i < INPUT_COUNT; i++) {
        char name[INPUT_NAME_SIZE];
        if (r->what->constants.text[i] != NULL && header_has_input(&r->names, i))
            return usage_error("%s %s: %s has a column for it; allowed: one of the two",
                               input_name(&r->what->constants, i, name), r->what->constants.text[i],
                               csv_input_name(r->in));
    }
    return STATUS_DONE;
}

static bool is_rigid(const input_texts *texts)
{
    char complaint[COMPLAINT_SIZE];
    double E2;
    return input_is_given(texts, INPUT_E2) && input_read(texts, INPUT_E2, &E2, complaint) &&
           isinf(E2);
}

/* An empty cell is a gap in the data: a default would look like a result. Only a rigid body has
 * no Poisson's ratio. */
static bool has_no_gap(const run *r, const input_texts *texts, char complaint[COMPLAINT_SIZE])
{
    for (int i = 0; i < INPUT_COUNT; i++) {
        if (!header_has_input(&r->names, i) || input_is_given(texts, i) ||
            (i == INPUT_NU2 && is_rigid(texts)))
            continue;
        char name[INPUT_NAME_SIZE];
        snprintf(complaint, COMPLAINT_SIZE, "%s: the cell is empty", input_column(i, name));
        return false;
    }
    return true;
}

/* Before any row: whether the columns and constants can give a contact. A second body may be
 * rigid in every row. */
static int check_complete(const run *r)
{
    const char *present[INPUT_COUNT];
    for (int i = 0; i < INPUT_COUNT; i++)
        present[i] = header_has_input(&r->names, i) ? "(a column)" : NULL;
    if (header_has_input(&r->names, INPUT_E2))
        present[INPUT_E2] = "inf";
    const input_texts texts = texts_of(r, present);
    char complaint[COMPLAINT_SIZE];
    if (case_is_complete(&texts, CASE_OF_SOLVE, complaint))
        return STATUS_DONE;
    return failure("%s: %s%s", csv_input_name(r->in), complaint, header_separator_hint(&r->names));
}

/* A result that the file has as an input is not repeated; another column of its name would be
 * mistaken for it. */
static int choose_results(run *r)
{
    results_wanted wanted = r->what->wanted;
    wanted.edges = wanted.edges || header_has_input(&r->names, INPUT_M) ||
                   header_has_input(&r->names, INPUT_SIGMA);
    for (int i = 0; i < RESULT_COUNT; i++) {
        const char *name = result_kinds[i].name;
        const bool is_input = (i == RESULT_ROUNDING && header_has_input(&r->names, INPUT_A)) ||
                              (i == RESULT_RADIUS && header_has_input(&r->names, INPUT_RADIUS));
        r->shown[i] = !is_input && results_include(wanted, i);
        if (r->shown[i] && header_has(&r->names, name))
            return failure("%s: column %s: a result has that name; allowed: any other",
                           csv_input_name(r->in), name);
    }
    if (header_has(&r->names, error_column))
        return failure("%s: column error: a result has that name; allowed: any other",
                       csv_input_name(r->in));
    return STATUS_DONE;
}

static void write_header(run *r)
{
    const record_format *format = r->rows->format;
    r->rows->mark = csv_input_has_mark(r->in);
    records_describe(r->rows, result_kinds, RESULT_COUNT);
    format->begin(r->rows);
    for (size_t i = 0; i < r->names.count; i++)
        format->name(r->rows, r->names.name[i]);
    for (int i = 0; i < RESULT_COUNT; i++)
        if (r->shown[i])
            format->name(r->rows, result_kinds[i].name);
    format->name(r->rows, error_column);
    format->end_header(r->rows);
}

/* ---- A row is solved: by several threads at a time ---- */

static void warn_of_unused(const run *r, const csv_row *row, results *found)
{
    bool unused[HEADER_COLUMNS] = {false};
    header_note_unused(&r->names, row->cell, unused);
    header_write_unused(&r->names, unused, found->warnings, sizeof found->warnings);
}

static bool solve_row(const run *r, const csv_row *row, results *found,
                      char complaint[COMPLAINT_SIZE])
{
    if (row->malformed) {
        snprintf(complaint, COMPLAINT_SIZE, "misplaced quotes in the row of line %" PRId64,
                 row->line);
        return false;
    }
    if (!header_fits(&r->names, row->count, csv_input_separator(r->in), complaint))
        return false;
    const char *text[INPUT_COUNT];
    for (int i = 0; i < INPUT_COUNT; i++)
        text[i] = header_has_input(&r->names, i) ? row->cell[r->names.column[i]] : NULL;
    const input_texts texts = texts_of(r, text);
    contact_case what;
    if (!has_no_gap(r, &texts, complaint) || !case_read(&texts, CASE_OF_SOLVE, &what, complaint) ||
        !results_compute(&what, r->what->wanted, found, complaint))
        return false;
    if (texts.text[INPUT_F] == NULL)
        results_warn(found, "no friction given");
    warn_of_unused(r, row, found);
    return true;
}

typedef struct {
    results found;
    char complaint[COMPLAINT_SIZE];
    bool solved;
} answer;

static void compute_answer(const void *of_run, int64_t i, void *of_answer)
{
    const run *r = of_run;
    answer *to = of_answer;
    to->complaint[0] = '\0';
    to->solved = solve_row(r, &r->held[i], &to->found, to->complaint);
}

/* ---- A row is written ---- */

/* A cell as it is in the file. A column that is no input may have names that look like numbers. */
static cell cell_of(const run *r, const csv_row *row, size_t column)
{
    const char *text = column < row->count ? row->cell[column] : "";
    const bool is_input = header_is_input(&r->names, column);
    double number;
    return number_read_cell(text, r->how->decimal_sign, &number) &&
                   (is_input || number_is_exact(text))
               ? cell_typed(text, number)
               : cell_text(text);
}

/* What the columns cannot show of a row is in its error. */
static char *with_row(run *r, const csv_row *row, const char *complaint)
{
    char *whole = malloc(strlen(complaint) + strlen(row->whole) + 3);
    if (whole == NULL)
        r->rows->problem = "out of memory";
    else
        sprintf(whole, "%s: %s", complaint, row->whole);
    return whole;
}

static void write_error(run *r, const csv_row *row, const char *complaint)
{
    char *whole =
        row->malformed || row->count > r->names.count ? with_row(r, row, complaint) : NULL;
    r->rows->format->value(r->rows, error_column, cell_text(whole != NULL ? whole : complaint));
    free(whole);
}

static void write_row(run *r, const csv_row *row, const answer *one)
{
    for (size_t i = 0; i < r->names.count; i++)
        r->rows->format->value(r->rows, r->names.name[i], cell_of(r, row, i));
    for (int i = 0; i < RESULT_COUNT; i++)
        if (r->shown[i])
            r->rows->format->value(r->rows, result_kinds[i].name,
                                   one->solved ? one->found.value[i] : cell_empty());
    write_error(r, row, one->complaint);
    r->rows->format->end_row(r->rows);
    if (row->count == r->names.count)
        header_note_unused(&r->names, row->cell, r->unused);
    r->count++;
    r->failed += one->solved ? 0 : 1;
    r->doubts |= one->solved ? one->found.doubts : 0;
    progress_step();
}

/* ---- The file ---- */

/* Behind rows that have gone to standard output: who reads them may not see the exit status. */
static void write_broken_end(run *r)
{
    for (size_t i = 0; i < r->names.count; i++)
        r->rows->format->value(r->rows, r->names.name[i], cell_empty());
    for (int i = 0; i < RESULT_COUNT; i++)
        if (r->shown[i])
            r->rows->format->value(r->rows, result_kinds[i].name, cell_empty());
    r->rows->format->value(r->rows, error_column,
                           cell_text("the file could not be read beyond this row"));
    r->rows->format->end_row(r->rows);
}

/* A quote that is left open may close in a later row, and take the rows between. */
static csv_event next_row(const run *r)
{
    const csv_event event = csv_input_next(r->in);
    const bool misfit = event == CSV_ROW && csv_input_count(r->in) != r->names.count;
    return misfit && csv_input_spans_lines(r->in)
               ? csv_input_stop(r->in, "a quote over several lines, and too few or too many cells")
               : event;
}

static void release_held(run *r)
{
    for (int64_t i = 0; i < r->held_count; i++)
        csv_row_free(&r->held[i]);
    r->held_count = 0;
}

/* Reads rows until there are enough for the threads; the event is that of the row that is none.
 * Without memory for a row, the threads would have none either. */
static csv_event hold_rows(run *r)
{
    size_t bytes = 0;
    csv_event event = CSV_ROW;
    for (r->held_count = 0; r->held_count < HELD_ROWS && bytes < HELD_BYTES; r->held_count++) {
        event = next_row(r);
        if (event == CSV_END || event == CSV_FAILED)
            return event;
        csv_row *row = &r->held[r->held_count];
        if (!csv_row_keep(r->in, event == CSV_MALFORMED, row))
            failure("out of memory");
        bytes += row->bytes;
    }
    return event;
}

static void write_held(run *r)
{
    ahead *work = ahead_start(r->what->threads, r->held_count, sizeof(answer), compute_answer, r);
    for (int64_t i = 0; i < r->held_count && records_go_on(r->rows); i++)
        write_row(r, &r->held[i], ahead_next(work));
    ahead_stop(work);
    release_held(r);
}

/* Ends where the file or the format cannot go on. */
static bool write_rows(void *of_run, records *rows, bool show_progress)
{
    run *r = of_run;
    csv_event event = CSV_ROW;
    r->rows = rows;
    progress_start(show_progress, PROGRESS_NO_TOTAL, "rows");
    write_header(r);
    while (records_go_on(r->rows) && event != CSV_END && event != CSV_FAILED) {
        event = hold_rows(r);
        write_held(r);
    }
    if (event == CSV_FAILED)
        write_broken_end(r);
    r->rows->format->end(r->rows);
    progress_erase();
    if (event == CSV_FAILED)
        csv_input_fail(r->in);
    return records_are_sound(r->rows);
}

static void say_doubts(const run *r)
{
    char where[300];
    snprintf(where, sizeof where, "%.250s, in some rows: ", csv_input_name(r->in));
    doubts_say(r->doubts, where);
}

static int write_output(run *r)
{
    const int status = output_options_write(r->how, write_rows, r);
    if (status == STATUS_DONE)
        table_header_say_unused(&r->names, r->unused, csv_input_name(r->in));
    if (status == STATUS_DONE && r->failed > 0)
        notice("%s: %" PRId64 " of %" PRId64 " rows could not be solved: see the column error",
               csv_input_name(r->in), r->failed, r->count);
    if (status == STATUS_DONE)
        say_doubts(r);
    return status == STATUS_DONE && r->failed > 0 && r->failed == r->count ? STATUS_FAILED : status;
}

static int read_header(run *r)
{
    bool wanted[INPUT_COUNT];
    char complaint[COMPLAINT_SIZE];
    for (int i = 0; i < INPUT_COUNT; i++)
        wanted[i] = true;
    if (!table_header_read(r->in, &r->first))
        return STATUS_FAILED;
    if (!header_find(r->first.cell, r->first.count, wanted, &r->what->constants, &r->names,
                     complaint))
        return failure("%s: %s", csv_input_name(r->in), complaint);
    int status = check_constants(r);
    if (status == STATUS_DONE)
        status = check_complete(r);
    return status == STATUS_DONE ? choose_results(r) : status;
}

int batch_run(const batch *what, const output_options *how)
{
    run r = {.what = what,
             .how = how,
             .in = csv_input_open(what->path, how->decimal_sign == ',' ? ';' : ',', what->encoding),
             .held = calloc(HELD_ROWS, sizeof *r.held)};
    if (r.in == NULL || r.held == NULL) {
        csv_input_close(r.in);
        free(r.held);
        return r.in == NULL ? STATUS_FAILED : failure("out of memory");
    }
    int status = read_header(&r);
    if (status == STATUS_DONE)
        status = write_output(&r);
    csv_row_free(&r.first);
    csv_input_close(r.in);
    free(r.held);
    return status;
}
