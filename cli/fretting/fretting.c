/* SPDX-License-Identifier: GPL-3.0-or-later */
/* "rwedge fretting". */
#include "fretting.h"

#include <math.h>
#include <string.h>

enum { OPTION_WORST = OPTION_AFTER_SERIES, OPTION_AT_WORST, OPTION_FULL_WEAR };

static const struct poptOption options[] = {
    CONTACT_OPTIONS,
    {INCLUDED(criteria_option_table), "Criteria:", NULL},
    {INCLUDED(history_option_table), "Its loads:", NULL},
    {INCLUDED(place_option_table), "Places, by default along the surface from side to side:", NULL},
    {VALUE("worst", OPTION_WORST), "Write the worst place of each measure to FILE too", "FILE"},
    {FLAG("at-worst", OPTION_AT_WORST),
     "Write a verdict for each criterion at its worst place, in place of the rows", NULL},
    {INCLUDED(series_option_table), NULL, NULL},
    {VALUE("angle", OPTION_ANGLE),
     "Direction of the critical distance, from the surface's normal towards +x, -85 to 85 deg "
     "(default 0)",
     "NUMBER"},
    {FLAG("full-wear", OPTION_FULL_WEAR),
     "Add what is worn off where wear ends; of a cycle of Q alone", NULL},
    {THREADS_OPTION},
    {INCLUDED(grid_output_option_table), "Common options:", NULL},
    POPT_TABLEEND,
};

/* Describes the columns that are always there, with their angles; or the values of the others. */
static void describe_columns(bool are_always, FILE *stream)
{
    for (int i = 0; i < measure_count(); i++) {
        const measure_kind *kind = measure_kind_of(i);
        const bool is_always = kind->condition == COLUMN_ALWAYS;
        if (is_always == are_always &&
            (is_always || kind->part == PART_VALUE || kind->part == PART_MULTIPLE))
            fprintf(stream, "  %-15s %s\n", kind->column, kind->meaning);
    }
}

static void describe(FILE *stream)
{
    fputs("\nLOADS.csv is a cycle of loads, as for \"rwedge history\". It is gone through\n"
          "--cycles times (default 3), and the last time counts: stresses after each of its\n"
          "loads, slip on the way. Edges of contact and stick zone are always looked at.\n"
          "Beside a file, --load gives loads that are applied once, before the first cycle;\n"
          "without a file, the cycle.\n"
          "\nColumns:\n"
          "  x, y            the place, y the depth\n",
          stream);
    describe_columns(true, stream);
    fputs("and at the end, for --criteria, or where their constants are given:\n", stream);
    describe_columns(false, stream);
    fputs("with NAME_angle and NAME_out_of_plane: from the normal of its plane to the plane\n"
          "of x and y, 0 to 90 deg.\n",
          stream);
    fputs("With --full-wear, also at the end:\n"
          "  worn_depth      worn off there where wear ends: then nothing presses beside the\n"
          "                  zone that sticks\n"
          "  worn_to         as far as it wears, on this side\n"
          "  depth_max       the largest depth\n"
          "  worn_area       worn off on both sides\n",
          stream);
    fputs("\nThe last line, on standard error, names the worst place of each, also between\n"
          "the places. Slip, shear and energy are those of the surface in contact. F1 is\n"
          "shear * slip, F2 tension * shear * slip (Ruiz, Boddington and Chen, 1984).\n"
          "\nCriteria are the largest of all planes, also of those that do not contain z. A\n"
          "shear amplitude is the radius of the smallest circle around the path of the shear\n"
          "stress, that of sqrt(J2) of the smallest sphere. Nothing is a range but\n"
          "stress_range and slip_range.\n"
          "\nWith the constants of a curve of life, damage is that of a pass of the loads,\n"
          "which repeats. Its cycles are counted by rainflow (ASTM E1049). A life is a\n"
          "number of passes.\n",
          stream);
    fputs("\nTESTS.csv has a test in each row: the inputs of its contact by their names, if\n"
          "options do not give them, constants of the material where they differ, and\n",
          stream);
    for (int i = 0; i < TEST_COLUMNS; i++)
        fprintf(stream, "  %-15s %s\n", test_columns[i].name, test_columns[i].meaning);
    fputs("P comes first, then Q and sigma go together, between the largest and the\n"
          "smallest. Each row gets the contact, each criterion at its worst place and at the\n"
          "length, damage and life by the first that has a curve, tested over predicted.\n",
          stream);
}

typedef struct {
    contact_history history;
    last_cycle last;
    doubts doubts;
    measured result;
    material constants;
    worst_table worst;
    bool has_full_wear;
    full_wear wear;
    int threads;
    int32_t *status; /* of each batch of places */
} plan;

/* ---- Computing ---- */

enum { BATCH = 128 }; /* places */

/* Each batch goes through the cycle by itself; loads that are computed take long: then as few as
 * can be. */
static size_t batch_size(const plan *job)
{
    const size_t share = job->result.count / (size_t)job->threads + 1;
    return rwedge_contact_error(job->last.before) > 0 && share > BATCH ? share : BATCH;
}

static void compute_batch(void *of_plan, int64_t i)
{
    plan *job = of_plan;
    const size_t size = batch_size(job), first = (size_t)i * size, left = job->result.count - first;
    job->status[i] =
        last_cycle_measure(&job->last, left < size ? left : size, job->result.place + first);
}

static void compute(plan *job)
{
    const size_t size = batch_size(job), batches = (job->result.count + size - 1) / size;
    job->status = memory_zeroed(batches, sizeof *job->status);
    threads_run(job->threads, (int64_t)batches, compute_batch, job);
    for (size_t i = 0; i < batches; i++)
        status_check(job->status[i], "the places");
}

/* ---- Rows ---- */

static void write_rows(void *of_plan, records *rows)
{
    const plan *job = of_plan;
    const measured *result = &job->result;
    progress_start(rows->show_progress, (int64_t)result->count, "rows");
    rows->title = "rwedge fretting: y is the depth below the surface";
    for (size_t i = 0; i < result->line; i++)
        rows->across += result->place[i].is_shown;
    records_name(rows, "x");
    records_name(rows, "y");
    for (int i = 0; i < measure_count(); i++)
        if (column_is_wanted(&job->last.asked, i))
            records_name(rows, measure_kind_of(i)->column);
    for (int i = 0; i < FULL_WEAR_COLUMNS && job->has_full_wear; i++)
        records_name(rows, full_wear_columns[i]);
    records_end_header(rows);
    for (size_t i = 0; i < result->count && records_go_on(rows); i++) {
        const measured_place *place = &result->place[i];
        if (!place->is_shown)
            continue;
        records_value(rows, cell_number(place->x));
        records_value(rows, cell_number(place->y));
        for (int k = 0; k < measure_count(); k++)
            if (column_is_wanted(&job->last.asked, k))
                records_value(rows, cell_number(place->value[k]));
        if (job->has_full_wear)
            full_wear_write(&job->wear, place->x, place->y, rows);
        records_end_row(rows);
        progress_step();
    }
}

/* ---- The command ---- */

/* A length is of verdicts. */
static void check_distance(const arguments *line)
{
    static const int of_length[] = {OPTION_LENGTH, OPTION_METHOD, OPTION_ANGLE};
    for (int i = 0; i < 3; i++)
        if (line->value[of_length[i]] != NULL && line->value[OPTION_AT_WORST] == NULL &&
            line->value[OPTION_WORST] == NULL)
            usage_error("--%s %s: needs --at-worst or --worst", arguments_name(line, of_length[i]),
                        line->value[of_length[i]]);
}

/* The output options of --worst: those of the rows, with its own file and the format of its
 * ending. */
static void read_worst(const arguments *line, output_options *worst)
{
    arguments its = *line;
    if (line->value[OPTION_WORST] == NULL)
        return;
    its.output = OPTION_WORST;
    its.value[OPTION_FORMAT] = NULL;
    output_options_read(&its, worst);
}

static void read_plan(const arguments *line, plan *job, output_options *how, output_options *worst)
{
    criteria asked;
    input_texts texts;
    output_options_read_of(line, grid_formats, "", how);
    if (how->format == &vtk_format && line->value[OPTION_AT_WORST] != NULL)
        usage_error("--at-worst: a verdict has no format vtk; allowed: csv, tsv, json, xlsx");
    job->has_full_wear = line->value[OPTION_FULL_WEAR] != NULL;
    if (job->has_full_wear && line->value[OPTION_AT_WORST] != NULL)
        usage_error("--full-wear: adds columns to the rows, not with --at-worst");
    read_worst(line, worst);
    job->threads = threads_read(line);
    input_texts_from_options(line, &texts);
    job->constants = *material_of(line);
    criteria_read(line, &job->constants, &texts, &asked);
    job->worst = (worst_table){.last = &job->last, .below = distance_read(line, &job->constants)};
    check_distance(line);
    contact_history_read(line, &texts, how->decimal_sign, 3, 3, &job->history);
    criteria_read_strength(line, &job->history.setup, &asked);
    history_cycle(&job->history, &asked, &job->last, &job->doubts);
    if (job->has_full_wear)
        full_wear_find(&job->last, &job->wear);
    surface_places(line, how->decimal_sign, &job->last, &job->result);
}

static void write_output(const arguments *line, const output_options *how, plan *job)
{
    worst_table verdicts = job->worst;
    verdicts.is_verdict = true;
    if (line->value[OPTION_AT_WORST] != NULL)
        output_options_write(how, worst_write_rows, &verdicts);
    else
        output_options_write(how, write_rows, job);
}

/* A series has rows of its own. */
static void refuse_beside_tests(const arguments *line)
{
    static const int others[] = {OPTION_WORST, OPTION_AT_WORST, OPTION_FULL_WEAR};
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++)
        if (line->value[others[i]] != NULL)
            usage_error("--%s: not with --input, whose rows are verdicts at their worst places",
                        arguments_name(line, others[i]));
}

static int series_of_tests(const arguments *line)
{
    static series_table table; /* it must not move */
    output_options how;
    refuse_beside_tests(line);
    output_options_read(line, &how);
    series_table_read(line, &how, how.decimal_sign, &table);
    return series_table_write(&table, &how);
}

static int fretting(const arguments *line)
{
    if (line->value[OPTION_TESTS] != NULL)
        return series_of_tests(line);
    if (line->value[OPTION_FIT_LENGTH] != NULL)
        usage_error("--fit-length: needs --input, a series of tests");
    plan job = {.threads = 1};
    output_options how, how_worst = {.path = NULL};
    char worst[2400];
    bool is_deep = false;
    read_plan(line, &job, &how, &how_worst);
    compute(&job);
    worst_find(&job.result, &job.worst);
    for (size_t i = 0; i < job.result.count; i++)
        is_deep = is_deep || job.result.place[i].y > 0;
    worst_write(&job.worst, is_deep, worst, sizeof worst);
    if (job.result.line > 0 && line->value[OPTION_X] == NULL && how.format != &vtk_format)
        worst_add_places(&job.worst, &job.result);
    write_output(line, &how, &job);
    if (how_worst.path != NULL)
        output_options_write(&how_worst, worst_write_rows, &job.worst);
    doubts_say(job.doubts, "");
    if (!job.last.slip_known)
        notice("the slip has no closed form after these loads: slip_range, ruiz_f1, ruiz_f2 and "
               "energy_per_area are empty");
    unused_say(&job.history.loads.names, job.history.loads.name);
    notice("worst: %s",
           worst[0] != '\0' ? worst : "none; every measure is 0 or empty at these places");
    return STATUS_DONE;
}

const command fretting_command = {
    .name = "fretting",
    .summary = "a cycle of loads: stress range, SWT, slip, energy, the worst place",
    .grammar = {options, "LOADS.csv | --input TESTS.csv [OPTION...]", describe, OPTION_LOAD},
    .run = fretting};
