/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fretting.h"

#include "surface.h"
#include "worst.h"

#include "contact/notices.h"
#include "model/doubts.h"
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
          "shear * slip, F2 tension * shear * slip (Ruiz, Boddington and Chen, 1984).\n",
          stream);
}

typedef struct {
    course whole;
    last_cycle last;
    measured all;
    int threads;
} plan;

/* ---- Computing ---- */

enum { BATCH = 32 };

typedef struct {
    measures found[BATCH];
    int32_t status;
} batch;

static void compute_batch(const void *of_plan, int64_t i, void *of_batch)
{
    const plan *what = of_plan;
    batch *result = of_batch;
    const size_t first = (size_t)i * BATCH, left = what->all.count - first;
    const size_t n = left < BATCH ? left : BATCH;
    double x[BATCH], y[BATCH];
    for (size_t k = 0; k < n; k++) {
        x[k] = what->all.place[first + k].x;
        y[k] = what->all.place[first + k].y;
    }
    result->status = last_cycle_measure(&what->last, n, x, y, result->found);
}

static int compute(plan *what)
{
    const int64_t batches = (int64_t)((what->all.count + BATCH - 1) / BATCH);
    ahead *work = ahead_start(what->threads, batches, sizeof(batch), compute_batch, what);
    int32_t status = work == NULL ? RWEDGE_ENOMEM : RWEDGE_OK;
    for (int64_t i = 0; i < batches && status == RWEDGE_OK; i++) {
        const batch *result = ahead_next(work);
        status = result->status;
        for (size_t k = (size_t)i * BATCH; k < what->all.count && k < (size_t)(i + 1) * BATCH; k++)
            what->all.place[k].found = result->found[k % BATCH];
    }
    ahead_stop(work);
    return status == RWEDGE_OK ? STATUS_DONE : failure("%s", rwedge_strerror(status));
}

/* ---- The worst ---- */

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
static int add_rows(plan *what, const worst_place worst[MEASURE_COUNT])
{
    for (int i = 0; i < MEASURE_COUNT; i++) {
        measured_place row = {.x = worst[i].x, .y = worst[i].y, .is_shown = true};
        if (isnan(worst[i].value) || is_there(&what->all, row.x, row.y))
            continue;
        const int32_t status = last_cycle_measure(&what->last, 1, &row.x, &row.y, &row.found);
        if (status != RWEDGE_OK)
            return failure("%s", rwedge_strerror(status));
        what->all.place[what->all.count++] = row; /* there is room */
    }
    qsort(what->all.place, what->all.count, sizeof *what->all.place, in_order);
    return STATUS_DONE;
}

static void write_worst(const plan *what, const worst_place worst[MEASURE_COUNT], char *text,
                        size_t size)
{
    bool deep = false;
    text[0] = '\0';
    for (size_t i = 0; i < what->all.count; i++)
        deep = deep || what->all.place[i].y > 0;
    for (int i = 0; i < MEASURE_COUNT; i++) {
        char value[NUMBER_SIZE], x[NUMBER_SIZE], y[NUMBER_SIZE];
        if (measure_kinds[i].is_angle || isnan(worst[i].value))
            continue;
        number_write(worst[i].value, 6, '.', value);
        number_write(worst[i].x, 6, '.', x);
        number_write(worst[i].y, 6, '.', y);
        list_add(text, size, "; ", "%s %s at x = %s%s%s", measure_kinds[i].column, value, x,
                 deep ? ", y = " : "", deep ? y : "");
    }
}

/* ---- Rows ---- */

static void write_row(const measured_place *at, records *rows)
{
    rows->format->value(rows, "x", cell_number(at->x));
    rows->format->value(rows, "y", cell_number(at->y));
    for (int i = 0; i < MEASURE_COUNT; i++)
        rows->format->value(rows, measure_kinds[i].column, cell_number(at->found.value[i]));
    rows->format->end_row(rows);
    progress_step();
}

static bool write_rows(void *of_plan, records *rows, bool show_progress)
{
    const plan *what = of_plan;
    progress_start(show_progress, (int64_t)what->all.count, "rows");
    rows->format->begin(rows);
    rows->format->name(rows, "x");
    rows->format->name(rows, "y");
    for (int i = 0; i < MEASURE_COUNT; i++)
        rows->format->name(rows, measure_kinds[i].column);
    rows->format->end_header(rows);
    for (size_t i = 0; i < what->all.count && records_go_on(rows); i++)
        if (what->all.place[i].is_shown)
            write_row(&what->all.place[i], rows);
    rows->format->end(rows);
    progress_erase();
    return records_are_sound(rows);
}

/* ---- The command ---- */

static const double SQRT_3 = 1.7320508075688772;

static int read_k_over_sy(const arguments *given, const contact_case *what, double *k_over_sy)
{
    const char *text = given->value[OPTION_FS_K];
    double k = 1;
    if (text != NULL && !(number_read(text, &k) && k >= 0 && k <= 1e6))
        return usage_error("--fs-k %s: must be a number from 0 to 1000000", text);
    if (text != NULL && isnan(what->k))
        return usage_error("--fs-k %s: needs --k or --yield-stress", text);
    *k_over_sy = k / (SQRT_3 * what->k);
    return STATUS_DONE;
}

static int read_plan(const arguments *given, plan *what, output_options *how)
{
    double k_over_sy = NAN;
    int status = output_options_read(given, how);
    if (status == STATUS_DONE)
        status = places_spare_files(given, how);
    if (status == STATUS_DONE)
        status = threads_read(given, &what->threads);
    if (status == STATUS_DONE)
        status = course_read(given, how->decimal_sign,
                             (course_usage){.cycles = 3, .loads_before = true}, &what->whole);
    if (status == STATUS_DONE)
        status = read_k_over_sy(given, &what->whole.what, &k_over_sy);
    if (status == STATUS_DONE &&
        !last_cycle_begin(&what->whole, k_over_sy, CYCLE_PARTS, &what->last))
        status = STATUS_FAILED;
    if (status == STATUS_DONE)
        status = surface_places(given, how->decimal_sign, &what->last, &what->all);
    return status;
}

static int32_t doubts_now(const contact_case *what, const rwedge_contact *contact)
{
    double factor = NAN;
    if (!isnan(what->k))
        rwedge_contact_yield_factor(contact, what->nu1, what->k, &factor, NULL, NULL);
    return doubts_of(what, rwedge_contact_half_width(contact), factor);
}

/* Of the loads before the first cycle. */
static int32_t doubts_before(const course *whole)
{
    char complaint[COMPLAINT_SIZE];
    rwedge_contact *contact;
    int32_t doubts = 0;
    bool going = case_contact(&whole->what, &contact) == RWEDGE_OK;
    for (size_t i = 0; i < whole->before.count && going; i++) {
        going = load_table_apply(&whole->before, i, whole->what.f, contact, complaint);
        doubts |= doubts_now(&whole->what, contact);
    }
    rwedge_contact_destroy(contact);
    return doubts;
}

static void say_what_is_doubtful(const plan *what)
{
    int32_t doubts = doubts_before(&what->whole);
    for (size_t i = 1; i < what->last.states; i++)
        doubts |= doubts_now(&what->whole.what, what->last.state[i].contact);
    doubts_say(doubts, "");
    if (!what->last.slip_known)
        notice("the slip has no closed form after these loads: slip_range, ruiz_f1, ruiz_f2 and "
               "energy_per_area are empty");
    load_table_say_unused(&what->whole.loads);
}

static int run(const arguments *given, plan *what)
{
    output_options how;
    worst_place worst[MEASURE_COUNT];
    char line[1200];
    int status = read_plan(given, what, &how);
    if (status == STATUS_DONE)
        status = compute(what);
    if (status != STATUS_DONE)
        return status;
    for (int i = 0; i < MEASURE_COUNT; i++)
        worst[i] = measure_kinds[i].is_angle ? (worst_place){0, 0, NAN}
                                             : worst_of(&what->last, &what->all, i);
    if (what->all.line > 0 && given->value[OPTION_X] == NULL)
        status = add_rows(what, worst);
    if (status == STATUS_DONE)
        status = output_options_write(&how, write_rows, what);
    if (status != STATUS_DONE)
        return status;
    say_what_is_doubtful(what);
    write_worst(what, worst, line, sizeof line);
    notice("worst: %s",
           line[0] != '\0' ? line : "none; every measure is 0 or empty at these places");
    return status;
}

static int fretting(const arguments *given)
{
    plan what = {.threads = 1};
    const int status = run(given, &what);
    free(what.all.place);
    last_cycle_free(&what.last);
    course_free(&what.whole);
    return status;
}

static const syntax grammar = {options, "LOADS.csv [OPTION...]", describe, OPTION_LOAD};

const command fretting_command = {
    "fretting",
    "rwedge fretting",
    "a cycle of loads: stress range, SWT, slip, energy, the worst place",
    &grammar,
    NULL,
    fretting};
