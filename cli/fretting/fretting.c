/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fretting.h"

#include "surface.h"

#include "contact/notices.h"
#include "options/threads.h"
#include "rows/output_options.h"
#include "system/ahead.h"
#include "system/progress.h"
#include "text/list.h"
#include "text/message.h"

#include <math.h>
#include <stdlib.h>

enum { OPTION_FS_K = OPTION_AFTER_PLACES };

static const struct poptOption options[] = {
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, input_option_table, 0, "The contact:", NULL},
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, strength_option_table, 0, "Its strength:", NULL},
    {"fs-k", '\0', POPT_ARG_STRING, NULL, OPTION_FS_K,
     "Fatemi and Socie's k, beside a yield stress (default 1)", "NUMBER"},
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, course_option_table, 0, "Its loads:", NULL},
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, place_option_table, 0,
     "Places, by default along the surface from side to side:", NULL},
    {THREADS_OPTION},
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, output_option_table, 0, "Common options:", NULL},
    POPT_TABLEEND,
};

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
    for (int i = 0; i < MEASURE_COUNT; i++)
        fprintf(stream, "  %-15s %s\n", measure_kinds[i].column, measure_kinds[i].meaning);
    fputs("\nThe last line, on standard error, names the worst place of each, also between\n"
          "the places. Slip, shear and energy are those of the surface in contact. F1 is\n"
          "shear * slip, F2 tension * shear * slip (Ruiz, Boddington and Chen, 1984).\n"
          "\nSWT and Fatemi-Socie are searched over the planes that contain z alone: where\n"
          "szz is an extreme principal stress, Fatemi-Socie may be too low. For plane stress\n"
          "give E (1+2nu)/(1+nu)^2 as --E1 and nu/(1+nu) as --nu1; --nu1 0 is wrong here.\n",
          stream);
}

typedef struct {
    course whole;
    last_cycle last;
    measured all;
    worst_place worst[MEASURE_COUNT];
    size_t worst_line[MEASURE_COUNT]; /* the first place of its line */
    int threads;
} plan;

/* ---- Computing ---- */

enum { BATCH = 128 }; /* places; each batch goes through the cycle by itself */

typedef struct {
    measures at[BATCH];
    int32_t status;
} batch;

static void compute_batch(const void *of_plan, int64_t i, void *of_batch)
{
    const plan *job = of_plan;
    batch *result = of_batch;
    const size_t first = (size_t)i * BATCH, left = job->all.count - first;
    const size_t n = left < BATCH ? left : BATCH;
    double x[BATCH], y[BATCH];
    for (size_t k = 0; k < n; k++) {
        x[k] = job->all.place[first + k].x;
        y[k] = job->all.place[first + k].y;
    }
    result->status = last_cycle_measure(&job->last, n, x, y, result->at);
}

static void compute(plan *job)
{
    const int64_t batches = (int64_t)((job->all.count + BATCH - 1) / BATCH);
    ahead *work = ahead_start(job->threads, batches, sizeof(batch), compute_batch, job);
    int32_t status = work == NULL ? RWEDGE_ENOMEM : RWEDGE_OK;
    for (int64_t i = 0; i < batches && status == RWEDGE_OK; i++) {
        const batch *result = ahead_next(work);
        status = result->status;
        for (size_t k = (size_t)i * BATCH; k < job->all.count && k < (size_t)(i + 1) * BATCH; k++)
            job->all.place[k].at = result->at[k % BATCH];
    }
    ahead_stop(work);
    if (status != RWEDGE_OK)
        failure("%s", rwedge_strerror(status));
}

/* ---- The worst ---- */

static size_t best_place(const measured *all, int measure)
{
    size_t best = 0;
    for (size_t i = 0; i < all->count; i++) {
        const double value = all->place[i].at.value[measure];
        if (isnan(all->place[best].at.value[measure]) || value > all->place[best].at.value[measure])
            best = i;
    }
    return best;
}

/* On the line of the best place, between the places too. */
static worst_place search_line(const plan *job, int measure, size_t first)
{
    const measured *all = &job->all;
    double *x = malloc(2 * all->line * sizeof *x), *value = x + all->line;
    if (x == NULL)
        failure("out of memory");
    for (size_t i = 0; i < all->line; i++) {
        x[i] = all->place[first + i].x;
        value[i] = fmax(all->place[first + i].at.value[measure], 0);
    }
    const worst_place worst =
        last_cycle_worst(&job->last, measure, all->line, x, value, all->place[first].y);
    free(x);
    return worst;
}

static void find_worst(plan *job)
{
    const measured *all = &job->all;
    for (int i = 0; i < MEASURE_COUNT; i++) {
        const size_t best = best_place(all, i);
        const double value = all->place[best].at.value[i];
        job->worst_line[i] = all->line > 0 ? best - best % all->line : best;
        job->worst[i] = (worst_place){all->place[best].x,
                                      value > 0 && !measure_kinds[i].is_angle ? value : NAN};
        if (all->line > 0 && !isnan(job->worst[i].value))
            job->worst[i] = search_line(job, i, job->worst_line[i]);
    }
}

static double worst_depth(const plan *job, int measure)
{
    return job->all.place[job->worst_line[measure]].y;
}

static int in_order(const void *one, const void *other)
{
    const measured_place *a = one, *b = other;
    if (a->y != b->y)
        return a->y < b->y ? -1 : 1;
    return a->x < b->x ? -1 : a->x > b->x ? 1 : 0;
}

static bool is_there(const measured *all, double x, double y)
{
    for (size_t i = 0; i < all->count; i++)
        if (all->place[i].x == x && all->place[i].y == y && all->place[i].is_shown)
            return true;
    return false;
}

/* Worst places that were found between the others become rows too. */
static void add_rows(plan *job)
{
    const size_t count = job->all.count;
    for (int i = 0; i < MEASURE_COUNT; i++) {
        measured_place row = {.x = job->worst[i].x, .y = worst_depth(job, i), .is_shown = true};
        if (isnan(job->worst[i].value) || is_there(&job->all, row.x, row.y))
            continue;
        const int32_t status = last_cycle_measure(&job->last, 1, &row.x, &row.y, &row.at);
        if (status != RWEDGE_OK)
            failure("%s", rwedge_strerror(status));
        job->all.place[job->all.count++] = row; /* there is room */
    }
    if (job->all.count > count)
        qsort(job->all.place, job->all.count, sizeof *job->all.place, in_order);
}

static void write_worst(const plan *job, char *text, size_t size)
{
    bool deep = false;
    text[0] = '\0';
    for (size_t i = 0; i < job->all.count; i++)
        deep = deep || job->all.place[i].y > 0;
    for (int i = 0; i < MEASURE_COUNT; i++) {
        char value[NUMBER_SIZE], x[NUMBER_SIZE], y[NUMBER_SIZE];
        if (isnan(job->worst[i].value))
            continue;
        number_write(job->worst[i].value, 6, '.', value);
        number_write(job->worst[i].x, 6, '.', x);
        number_write(worst_depth(job, i), 6, '.', y);
        list_add(text, size, "; ", "%s %s at x = %s%s%s", measure_kinds[i].column, value, x,
                 deep ? ", y = " : "", deep ? y : "");
    }
}

/* ---- Rows ---- */

static void write_row(const measured_place *place, records *rows)
{
    rows->format->value(rows, "x", cell_number(place->x));
    rows->format->value(rows, "y", cell_number(place->y));
    for (int i = 0; i < MEASURE_COUNT; i++)
        rows->format->value(rows, measure_kinds[i].column, cell_number(place->at.value[i]));
    rows->format->end_row(rows);
    progress_step();
}

static bool write_rows(void *of_plan, records *rows, bool show_progress)
{
    const plan *job = of_plan;
    progress_start(show_progress, (int64_t)job->all.count, "rows");
    rows->format->begin(rows);
    rows->format->name(rows, "x");
    rows->format->name(rows, "y");
    for (int i = 0; i < MEASURE_COUNT; i++)
        rows->format->name(rows, measure_kinds[i].column);
    rows->format->end_header(rows);
    for (size_t i = 0; i < job->all.count && records_go_on(rows); i++)
        if (job->all.place[i].is_shown)
            write_row(&job->all.place[i], rows);
    rows->format->end(rows);
    progress_erase();
    return records_are_sound(rows);
}

/* ---- The command ---- */

static const double SQRT_3 = 1.7320508075688772;

static double read_k_over_sy(const arguments *given, const contact_case *setup)
{
    const char *text = given->value[OPTION_FS_K];
    double k = 1;
    if (text != NULL && !(number_read(text, &k) && k >= 0 && k <= 1e6))
        usage_error("--fs-k %s: must be a number from 0 to 1000000", text);
    if (text != NULL && isnan(setup->k))
        usage_error("--fs-k %s: needs --k or --yield-stress", text);
    return k / (SQRT_3 * setup->k);
}

static void read_plan(const arguments *given, plan *job, output_options *how)
{
    output_options_read(given, how);
    places_spare_files(given, how);
    job->threads = threads_read(given);
    course_read(given, how->decimal_sign, (course_usage){.cycles = 3}, &job->whole);
    last_cycle_begin(&job->whole, read_k_over_sy(given, &job->whole.what), &job->last);
    surface_places(given, how->decimal_sign, &job->last, &job->all);
}

static void say_what_is_doubtful(const plan *job)
{
    doubts_say(job->last.doubts, "");
    if (!job->last.slip_known)
        notice("the slip has no closed form after these loads: slip_range, ruiz_f1, ruiz_f2 and "
               "energy_per_area are empty");
    load_table_say_unused(&job->whole.loads);
}

static int fretting(const arguments *given)
{
    plan job = {.threads = 1};
    output_options how;
    char line[1200];
    read_plan(given, &job, &how);
    compute(&job);
    find_worst(&job);
    write_worst(&job, line, sizeof line);
    if (job.all.line > 0 && given->value[OPTION_X] == NULL)
        add_rows(&job);
    output_options_write(&how, write_rows, &job);
    say_what_is_doubtful(&job);
    notice("worst: %s",
           line[0] != '\0' ? line : "none; every measure is 0 or empty at these places");
    return STATUS_DONE;
}

static const syntax grammar = {options, "LOADS.csv [OPTION...]", describe, OPTION_LOAD};

const command fretting_command = {
    "fretting",
    "rwedge fretting",
    "a cycle of loads: stress range, SWT, slip, energy, the worst place",
    &grammar,
    NULL,
    fretting};
