/* SPDX-License-Identifier: GPL-3.0-or-later */
/* "rwedge fretting --input": a table of tests, a row each. All are kept: a length may be fitted to
 * them, and a figure drawn. */
#include "fretting.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TESTS_MAX = 100000 };

struct poptOption series_option_table[] = {
    {"input", 'i', POPT_ARG_STRING, NULL, OPTION_TESTS,
     "A series of tests, a row each of a CSV file; - is standard input", "FILE"},
    {FLAG("fit-length", OPTION_FIT_LENGTH),
     "Of a series: find the length with which its tests scatter least", NULL},
    {VALUE("length", OPTION_LENGTH),
     "Verdicts by the theory of critical distances (default: that of the material, with --method)",
     "NUMBER"},
    {VALUE("method", OPTION_METHOD),
     "At half the length below the surface, or the mean over twice of it (default point)",
     "point|line"},
    POPT_TABLEEND,
};

/* ---- The critical distance ---- */

distance distance_read(const arguments *line, const material *constants)
{
    const char *text = line->value[OPTION_LENGTH], *method = line->value[OPTION_METHOD];
    const char *angle = line->value[OPTION_ANGLE];
    distance below = {NAN, 0, method != NULL && strcmp(method, "line") == 0};
    if (method != NULL && !below.is_line && strcmp(method, "point") != 0)
        usage_error("--method %s: must be point or line", method);
    if (text != NULL &&
        !(number_read(text, &below.length) && below.length >= 1e-60 && below.length <= 1e60))
        usage_error("--length %s: must be a number from 1e-60 to 1e60", text);
    if (angle != NULL && !(number_read(angle, &below.angle) && fabs(below.angle) <= 85))
        usage_error("--angle %s: must be a number from -85 to 85", angle);
    if (line->value[OPTION_FIT_LENGTH] != NULL && text != NULL)
        usage_error("--length %s: given together with --fit-length; allowed: one of the two", text);
    if (line->value[OPTION_FIT_LENGTH] != NULL)
        return below;
    if (text == NULL && (method != NULL || angle != NULL)) {
        below.length = rwedge_critical_distance(material_value(constants, "dK_th"),
                                                material_value(constants, "ds0"));
        units_say_of_K(line);
    }
    if (angle != NULL && isnan(below.length))
        usage_error("--angle %s: needs --length, or dK_th and ds0 of --material", angle);
    if (method != NULL && isnan(below.length))
        usage_error("--method %s: needs --length, or dK_th and ds0 of --material", method);
    return below;
}

/* ---- Files of loads ---- */

typedef struct {
    const char *name;
    double f; /* with which it is clipped */
    test_log log;
} named_log;

typedef struct {
    const arguments *line;
    reading how;
    const output_options *out; /* which none of them may be */
    named_log *list;
    size_t count;
} logs;

/* Who writes a table need not be who runs it: a pipe or a device is not waited for. */
static void read_log(const logs *all, named_log *to)
{
    load_history loads;
    if (all->out != NULL)
        output_options_spare(all->out, to->name, "file of a cell in column ", "loads");
    if (strcmp(to->name, "-") == 0 || file_kind_of(to->name) == FILE_OTHER) {
        complain(&to->log.why, "loads %.60s: a cell may name a regular file alone", to->name);
        return;
    }
    if (!load_history_read_file(to->name, &all->how, &loads, &to->log.why))
        return;
    if (loads_are_driven(loads.load, loads.count))
        load_history_give_compliance(all->line, &loads);
    loads_filter(all->line, to->f, &loads);
    to->log.to = loads.load;
    to->log.count = loads.count;
}

/* Its number, from 1; 0 for the name "". Each file is read once for a friction. */
static size_t log_named(logs *all, const char *name, double f)
{
    size_t i = 0;
    if (name[0] == '\0')
        return 0;
    while (i < all->count && (strcmp(all->list[i].name, name) != 0 || all->list[i].f != f))
        i++;
    if (i == all->count) {
        all->list = memory_for_one_more(all->list, all->count, sizeof *all->list);
        all->list[all->count++] = (named_log){.name = name, .f = f};
        read_log(all, &all->list[i]);
    }
    return i + 1;
}

/* ---- The columns ---- */

static bool find_columns(void *of_table, header *names, complaint *why)
{
    series_table *table = of_table;
    return series_find(&table->all, names, why);
}

/* An input is a column, or an option for all. */
static void refuse_twice(const arguments *line, const series_table *table)
{
    const input_texts *options = &table->all.constants;
    const char *file = table->file.in->name;
    for (int i = 0; i < INPUT_COUNT; i++)
        if (options->text[i] != NULL && header_has_input(&table->all.names, i))
            usage_error("%s %s: %s has a column for it; allowed: one of the two",
                        input_name(options, i), options->text[i], file);
    for (int i = 0; i < material_count(); i++)
        if (line->value[OPTION_CONSTANT + i] != NULL &&
            table->all.constant[i] < table->all.names.count)
            usage_error("--%s %s: %s has a column for it; allowed: one of the two",
                        arguments_name(line, OPTION_CONSTANT + i), line->value[OPTION_CONSTANT + i],
                        file);
}

/* Which criteria are asked for, by any contact with what the table gives. */
static void read_criteria(const arguments *line, series_table *table)
{
    const input_texts *options = &table->all.constants;
    const header *names = &table->all.names;
    const bool has_strength =
        header_has_input(names, INPUT_K) || header_has_input(names, INPUT_YIELD_STRESS) ||
        input_is_given(options, INPUT_K) || input_is_given(options, INPUT_YIELD_STRESS);
    const contact_case any = {.E1 = 1, .nu1 = 0, .k = has_strength ? 1 : NAN};
    const material *given = material_of(line), known = series_constants(&table->all, given);
    criteria_read(line, &known, options, &table->all.asked);
    criteria_read_strength(line, &any, &table->all.asked);
}

static void open_table(const arguments *line, const char *path, char decimal_sign,
                       series_table *table)
{
    const table_wanted wanted = {.find = find_columns, .context = table, .takes_malformed = true};
    const reading how = reading_of(line, decimal_sign);
    table->all.constants.cell_decimal_sign = decimal_sign;
    table_open(path, &how, &wanted, &table->file);
    csv_input_check(table->file.in);
    table->all.separator = table->file.in->separator;
    refuse_twice(line, table);
    read_criteria(line, table);
}

/* ---- The rows ---- */

static void add_row(series_table *table)
{
    test_row next = {.why = {""}};
    csv_row_keep(table->file.in, &next.row);
    table->row = memory_for_one_more(table->row, table->count, sizeof *table->row);
    table->row[table->count++] = next;
    if (table->count > TESTS_MAX)
        failure("%s: more than %d tests", table->file.in->name, TESTS_MAX);
}

/* A job of threads: its files have been read. */
typedef struct {
    series_table *table;
    const logs *files;
    size_t first;
} part_of_rows;

static void run_row(void *of_part, int64_t i)
{
    const part_of_rows *part = of_part;
    test_row *row = &part->table->row[part->first + (size_t)i];
    test_run *run = &part->table->run[part->first + (size_t)i];
    const csv_row *cells = &row->row;
    const test_log *log = row->log > 0 ? &part->files->list[row->log - 1].log : NULL;
    if (cells->malformed)
        complain(&row->why, "misplaced quotes in the row of line %" PRId64, cells->line);
    else if (test_read(&part->table->all, cells->cell, cells->count, log, &run->test, &row->why))
        test_go(&part->table->all, run, &row->why);
}

static void read_profile(const series_table *table, const logs *files, const csv_row *row)
{
    const size_t column = table->all.names.column[INPUT_PROFILE];
    if (!header_has_input(&table->all.names, INPUT_PROFILE) || column >= row->count)
        return;
    const char *name = row->cell[column];
    const profile_making making = profile_making_of(files->line);
    if (name[0] == '\0' || strcmp(name, "-") == 0 || file_kind_of(name) == FILE_OTHER)
        return;
    output_options_spare(files->out, name, "file of a cell in column ", "profile");
    notice("%s", profiles_read(name, &files->how, &making));
}

/* Reads the files that a row names, before threads run it. */
static void read_files(logs *files, const series_table *table, test_row *row)
{
    const series *all = &table->all;
    const csv_row *cells = &row->row;
    read_profile(table, files, cells);
    if (!cells->malformed)
        row->log = log_named(files, test_log_name(all, cells->cell, cells->count),
                             test_friction(all, cells->cell, cells->count));
}

static void run_rows(const arguments *line, const output_options *out, char decimal_sign,
                     series_table *table)
{
    enum { AT_ONCE = 64 };
    logs files = {.line = line, .how = reading_of(line, decimal_sign), .out = out};
    const bool shows = line->value[OPTION_QUIET] == NULL && stream_is_terminal(stderr);
    const int threads = threads_read(line);
    table->run = memory_zeroed(table->count, sizeof *table->run);
    for (size_t i = 0; i < table->count; i++)
        read_files(&files, table, &table->row[i]);
    measure_count(); /* before the threads */
    progress_start(shows, (int64_t)table->count, "tests");
    for (size_t i = 0; i < table->count; i += AT_ONCE) {
        const size_t left = table->count - i, n = left < AT_ONCE ? left : AT_ONCE;
        threads_run(threads, (int64_t)n, run_row, &(part_of_rows){table, &files, i});
        for (size_t k = 0; k < n; k++)
            progress_step();
    }
    progress_erase();
}

/* ---- The length ---- */

static void say_length(const series_table *table)
{
    const series *all = &table->all;
    const test_run *run = table->run;
    bool is_of_lives;
    const int criterion = series_leading(all, table->count, run, &is_of_lives);
    const double at = series_scatter(all, table->count, run, all->below.length),
                 surface = series_scatter(all, table->count, run, NAN);
    if (is_of_lives)
        notice("length %.6g: tested over predicted lives by %s scatter by a factor of %.3g, at the "
               "surface of %.3g (standard deviation)",
               all->below.length, criterion_name(criterion), pow(10, at), pow(10, surface));
    else
        notice("length %.6g: %s scatters by %.3g %%, at the surface by %.3g %% (standard deviation "
               "over mean)",
               all->below.length, criterion_name(criterion), 100 * at, 100 * surface);
}

static void find_length(const arguments *line, series_table *table)
{
    complaint why;
    distance *below = &table->all.below;
    if (line->value[OPTION_FIT_LENGTH] != NULL) {
        below->length = series_fit_length(&table->all, table->count, table->run, &why);
        if (isnan(below->length))
            notice("--fit-length: none: %s", why.text);
    }
    if (!isnan(below->length) &&
        !isnan(series_scatter(&table->all, table->count, table->run, below->length)))
        say_length(table);
}

/* The table has the loads and places. */
static void refuse_others(const arguments *line)
{
    static const int others[] = {
        OPTION_HISTORY,  OPTION_LOAD,    OPTION_UNTIL,           OPTION_SPECIMEN_THICKNESS,
        OPTION_OPPOSITE, OPTION_AT,      OPTION_POINTS,          OPTION_X,
        OPTION_DEPTH,    OPTION_ARCHARD, OPTION_INPUT + INPUT_Q, OPTION_INPUT + INPUT_SIGMA};
    if (line->operand != NULL && line->operand[0] != NULL)
        usage_error("%s: given together with --input; a row names its file of loads in the column "
                    "loads",
                    line->operand[0]);
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++)
        if (line->value[others[i]] != NULL)
            usage_error("--%s: not with --input, whose rows have their own loads",
                        arguments_name(line, others[i]));
}

void series_table_read(const arguments *line, const output_options *out, char decimal_sign,
                       series_table *table)
{
    const char *path = line->value[OPTION_TESTS];
    refuse_others(line);
    *table = (series_table){.all = {.below = distance_read(line, material_of(line)),
                                    .cycles = contact_history_cycles(line, 3)}};
    input_texts_from_options(line, &table->all.constants);
    input_options_check_hull(line);
    open_table(line, path, decimal_sign, table);
    while (table_next(&table->file))
        add_row(table);
    csv_input_check(table->file.in);
    run_rows(line, out, decimal_sign, table);
    find_length(line, table);
    for (size_t i = 0; i < table->count; i++) {
        test_run *run = &table->run[i];
        if (run->is_run)
            run->is_run = test_judge(&table->all, run, &table->row[i].why);
        table->failed += run->is_run ? 0 : 1;
    }
}
