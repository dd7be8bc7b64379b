/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve.h"

#include "setup/setup.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The rows that are held at a time, for threads to solve them: fewer where they are long. */
enum { HELD_ROWS = 1024, HELD_BYTES = 1 << 20 };

typedef struct {
    results results;
    complaint why;
    bool solved;
} answer;

/* The state of the run, from row to row. */
typedef struct {
    const arguments *line;
    const output_options *how;
    table_input file;
    csv_input *in; /* of it */
    reading reading;
    profile_making making;
    case_table table;
    records *rows;
    int64_t count, failed;
    doubts doubts; /* of any row */
    csv_row *held;
    answer *answers; /* to the held rows */
    int64_t held_count;
    size_t constant_profiles; /* that all rows share */
} run;

/* ---- Columns ---- */

static void write_header(run *r)
{
    r->rows->mark = r->in->has_mark;
    records_describe(r->rows, result_kinds, RESULT_COUNT);
    for (size_t i = 0; i < r->table.names.count; i++)
        records_name(r->rows, r->table.names.name[i]);
    for (int i = 0; i < RESULT_COUNT; i++)
        if (r->table.shown[i])
            records_name(r->rows, result_kinds[i].name);
    records_name(r->rows, case_table_error);
    records_end_header(r->rows);
}

/* ---- A row is solved: by several threads at a time ---- */

static void compute_answer(void *of_run, int64_t i)
{
    const run *r = of_run;
    const csv_row *row = &r->held[i];
    answer *to = &r->answers[i];
    to->why.text[0] = '\0';
    to->solved = row->malformed
                     ? complain(&to->why, "misplaced quotes in the row of line %" PRId64, row->line)
                     : case_table_solve(&r->table, row->cell, row->count, &to->results, &to->why);
}

/* ---- A row is written ---- */

static void write_row(run *r, const csv_row *row, const answer *solution)
{
    const header *names = &r->table.names;
    for (size_t i = 0; i < names->count; i++)
        records_value(r->rows, header_cell_written(names, i, i < row->count ? row->cell[i] : "",
                                                   r->how->decimal_sign));
    for (int i = 0; i < RESULT_COUNT; i++)
        if (r->table.shown[i])
            records_value(r->rows, solution->solved ? solution->results.value[i] : cell_text(""));
    char *error = csv_row_fault(row, names->count, solution->why.text);
    records_value(r->rows, cell_text(error));
    free(error);
    records_end_row(r->rows);
    if (row->count == names->count)
        header_note_unused(&r->table.names, row->cell);
    r->count++;
    r->failed += solution->solved ? 0 : 1;
    if (solution->solved)
        doubts_add(&r->doubts, solution->results.doubts);
    progress_step();
}

/* ---- The file ---- */

/* A quote that is left open may close in a later row, and take the rows between. */
static bool next_row(run *r)
{
    const csv_row *row = &r->in->row;
    if (!table_next(&r->file))
        return false;
    if (row->malformed || row->count == r->table.names.count || strpbrk(row->whole, "\r\n") == NULL)
        return true;
    return csv_input_stop(
        r->in, "line %" PRId64 ": a quote over several lines, and too few or too many cells",
        row->line);
}

/* Before the threads look for it. Who writes a file of contacts need not be who runs it: a pipe or
 * a device is not waited for. */
static void read_profile(const run *r, const char *name)
{
    if (name[0] == '\0' || strcmp(name, "-") == 0 || file_kind_of(name) == FILE_OTHER)
        return;
    output_options_spare(r->how, name, "file of a cell in column ", "profile");
    notice("%s", profiles_read(name, &r->reading, &r->making));
}

/* Reads rows until there are enough for the threads; false where no more follow. Where memory is
 * too short for a row the command ends, before threads begin. */
static bool hold_rows(run *r)
{
    const bool has_profile = header_has_input(&r->table.names, INPUT_PROFILE);
    const size_t column = r->table.names.column[INPUT_PROFILE];
    size_t bytes = 0;
    for (r->held_count = 0; r->held_count < HELD_ROWS && bytes < HELD_BYTES; r->held_count++) {
        if (!next_row(r))
            return false;
        csv_row *row = &r->held[r->held_count];
        csv_row_keep(r->in, row);
        read_profile(r, has_profile && column < row->count ? row->cell[column] : "");
        bytes += row->bytes;
    }
    return true;
}

/* Ends where the file or the format cannot go on. */
static void write_rows(void *of_run, records *rows)
{
    run *r = of_run;
    const csv_row none = {.whole = ""};
    const answer broken = {.why = {"the file could not be read beyond this row"}};
    bool more = true;
    r->rows = rows;
    progress_start(rows->show_progress, PROGRESS_NO_TOTAL, "rows");
    write_header(r);
    while (more && records_go_on(r->rows)) {
        more = hold_rows(r);
        threads_run(threads_read(r->line), r->held_count, compute_answer, r);
        for (int64_t i = 0; i < r->held_count && records_go_on(r->rows); i++)
            write_row(r, &r->held[i], &r->answers[i]);
        profiles_forget(r->constant_profiles);
        for (int64_t i = 0; i < r->held_count; i++)
            csv_row_free(&r->held[i]);
    }
    if (r->in->problem.text[0] == '\0')
        return;
    /* a last row says so: who reads rows from standard output may not see the exit status */
    write_row(r, &none, &broken);
    records_end(r->rows);
    progress_erase();
    csv_input_check(r->in);
}

/* Which columns are inputs. A table of which no row would be solved is refused. */
static bool find_columns(void *of_run, header *names, complaint *why)
{
    run *r = of_run;
    if (!header_find(0, INPUT_COUNT, &r->table.constants, names, why))
        return false;
    r->table.names = *names;
    return case_table_begin(&r->table, why);
}

static void read_header(run *r, const char *path)
{
    const table_wanted wanted = {.find = find_columns, .context = r, .takes_malformed = true};
    table_open(path, &r->reading, &wanted, &r->file);
    r->in = r->file.in;
    const input_texts *constants = &r->table.constants;
    for (int i = 0; i < INPUT_COUNT; i++)
        if (constants->text[i] != NULL && header_has_input(&r->file.names, i))
            usage_error("%s %s: %s has a column for it; allowed: one of the two",
                        input_name(constants, i), constants->text[i], r->in->name);
    csv_input_check(r->in);
    if (r->line->value[OPTION_HULL] != NULL && r->table.constants.text[INPUT_PROFILE] == NULL &&
        !header_has_input(&r->table.names, INPUT_PROFILE))
        usage_error("--hull: needs --profile, or a column profile");
    r->table.separator = r->in->separator;
}

int batch_run(const arguments *line, const char *path, const input_texts *constants,
              results_wanted wanted, const output_options *how)
{
    run r = {.line = line,
             .how = how,
             .table = {.constants = *constants, .wanted = wanted},
             .reading = reading_of(line, how->decimal_sign),
             .making = profile_making_of(line),
             .constant_profiles = profiles_count(),
             .held = memory_zeroed(HELD_ROWS, sizeof *r.held),
             .answers = memory_zeroed(HELD_ROWS, sizeof *r.answers)};
    r.table.constants.cell_decimal_sign = how->decimal_sign;
    char where[300];
    read_header(&r, path);
    output_options_write(how, write_rows, &r);
    unused_say(&r.table.names, r.in->name);
    if (r.file.remark.text[0] != '\0')
        notice("%s: %s", r.in->name, r.file.remark.text);
    if (r.failed > 0)
        notice("%s: %" PRId64 " of %" PRId64 " rows could not be solved: see the column error",
               r.in->name, r.failed, r.count);
    snprintf(where, sizeof where, "%.250s, in some rows: ", r.in->name);
    doubts_say(r.doubts, where);
    return r.failed > 0 && r.failed == r.count ? STATUS_FAILED : STATUS_DONE;
}
