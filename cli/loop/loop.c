/* SPDX-License-Identifier: GPL-3.0-or-later */
/* "rwedge loop". */
#include "loop.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

enum { OPTION_BY_CYCLE = OPTION_AFTER_LOADS, OPTION_FITTED };

static const struct poptOption options[] = {
    CONTACT_OPTIONS,
    {INCLUDED(exactness_option_table), "Its loads:", NULL},
    {ENCODING_OPTION},
    {FLAG("by-cycle", OPTION_BY_CYCLE), "Fit each whole cycle for itself, as steady", NULL},
    {FLAG("fitted", OPTION_FITTED), "Write the loop, measured and fitted, in place of the results",
     NULL},
    {INCLUDED(output_option_table), "Common options:", NULL},
    POPT_TABLEEND,
};

enum { QUANTITY, VALUE_OF, UNCERTAINTY, MEANING, CYCLE, COLUMNS };
static const column_kind columns[COLUMNS] = {
    [QUANTITY] = {"quantity", "f, compliance, offset, energy, regime", NULL},
    [VALUE_OF] = {"value", "empty where the loop does not tell it", NULL},
    [UNCERTAINTY] = {"uncertainty", "its standard deviation, by the noise of Q", NULL},
    [MEANING] = {"meaning", "in words", NULL},
    [CYCLE] = {"cycle", "with --by-cycle its number, from 1", NULL},
};

enum { FITTED_COLUMNS = 4 };
static const char *const fitted_columns[FITTED_COLUMNS] = {"P", "displacement", "Q", "Q_fitted"};

static void describe(FILE *stream)
{
    fputs("\nLOG.csv has the columns P, Q and displacement, as a rig measured them, and M and\n"
          "sigma if there are any. A contact is driven by the displacements, and f, the\n"
          "compliance of the rig and the offset of its displacement are those that leave\n"
          "the least of Q, in squares. The compliance is what \"rwedge history\" takes as\n"
          "--compliance.\n"
          "\nResults, a row for each quantity:\n",
          stream);
    columns_describe(columns, COLUMNS, 12, stream);
    fputs("\nWith --fitted, a row for each of the log: P, displacement, Q, Q_fitted.\n", stream);
}

typedef struct {
    contact_case setup;
    load_history log;
    log_cycles cycles;
    bool is_by_cycle, is_fitted;
    log_fit *fit; /* of the log, or of each cycle */
    size_t fits;
} plan;

/* ---- Fits ---- */

/* The rows of a fit: of a cycle, or all. */
static size_t first_row(const plan *job, size_t i)
{
    return job->is_by_cycle ? job->cycles.at[i] : 0;
}

static size_t row_count(const plan *job, size_t i)
{
    return job->is_by_cycle ? job->cycles.at[i + 1] - job->cycles.at[i] : job->log.count;
}

static void compute(plan *job)
{
    complaint why;
    const size_t whole = job->cycles.count > 0 ? job->cycles.count - 1 : 0;
    if (job->is_by_cycle && whole == 0)
        failure("%s: no whole cycle: the displacement does not rise twice through the middle of "
                "its range, nor ends where it began",
                job->log.name);
    job->fits = job->is_by_cycle ? whole : 1;
    job->fit = memory_zeroed(job->fits, sizeof *job->fit);
    for (size_t i = 0; i < job->fits; i++)
        if (!log_fit_find(job->setup.contact, row_count(job, i), job->log.load + first_row(job, i),
                          &job->fit[i], &why))
            failure("%s: %s", job->log.name, why.text);
}

/* ---- Rows ---- */

static void write_row(const plan *job, size_t i, const char *quantity, cell value,
                      double uncertainty, const char *meaning, records *rows)
{
    records_row(rows, job->is_by_cycle ? COLUMNS : CYCLE,
                (cell[]){cell_text(quantity), value, cell_number(uncertainty), cell_text(meaning),
                         cell_number((double)(i + 1))});
}

/* The energy of a whole cycle, or the mean of those of the log. */
static void write_energy(const plan *job, size_t i, records *rows)
{
    const log_cycles *cycles = &job->cycles;
    const size_t first = job->is_by_cycle ? i : 0, end = job->is_by_cycle    ? i + 1
                                                         : cycles->count > 0 ? cycles->count - 1
                                                                             : 0;
    double area = 0, variance = 0;
    for (size_t k = first; k < end; k++) {
        const double noise =
            loop_area_noise(job->log.load, cycles->at[k], cycles->at[k + 1], job->fit[i].noise);
        area += loop_area(job->log.load, cycles->at[k], cycles->at[k + 1]);
        variance += noise * noise;
    }
    const double count = (double)(end - first);
    write_row(job, i, "energy", cell_number(end > first ? area / count : NAN),
              end > first ? sqrt(variance) / count : NAN,
              "dissipated per cycle: the area of the measured loop", rows);
}

static void write_fit(const plan *job, size_t i, records *rows)
{
    static const char *const
        names[LOOP_PARTS] = {"f", "compliance", "offset"},
        *const meanings[LOOP_PARTS] = {"coefficient of friction",
                                       "how far the rig gives way under Q = 1 per unit length",
                                       "displacement at which there is no shear"},
        *const regimes[] = {[RWEDGE_LOOP_STICK] = "stick",
                            [RWEDGE_LOOP_PARTIAL_SLIP] = "partial slip",
                            [RWEDGE_LOOP_GROSS_SLIP] = "gross slip"},
        *const words[] = {[RWEDGE_LOOP_STICK] =
                              "the loop is a line within its noise: f is not told",
                          [RWEDGE_LOOP_PARTIAL_SLIP] = "Q does not reach f P",
                          [RWEDGE_LOOP_GROSS_SLIP] = "Q reaches f P: the contact slides"};
    const log_fit *fit = &job->fit[i];
    for (int j = 0; j < LOOP_PARTS; j++)
        write_row(job, i, names[j], cell_number(fit->value[j]), fit->uncertainty[j], meanings[j],
                  rows);
    write_energy(job, i, rows);
    write_row(job, i, "regime", cell_text(regimes[fit->regime]), NAN, words[fit->regime], rows);
}

static void write_fitted(const plan *job, size_t i, records *rows)
{
    for (size_t k = 0; k < row_count(job, i) && records_go_on(rows); k++) {
        const load *at = &job->log.load[first_row(job, i) + k];
        records_row(rows, FITTED_COLUMNS,
                    (cell[]){cell_number(at->P), cell_number(at->displacement), cell_number(at->Q),
                             cell_number(job->fit[i].Q[k])});
    }
}

static void write_rows(void *of_plan, records *rows)
{
    const plan *job = of_plan;
    rows->mark = job->log.has_mark;
    if (job->is_fitted)
        records_header(rows, FITTED_COLUMNS, fitted_columns);
    else
        records_columns(rows, columns, job->is_by_cycle ? COLUMNS : CYCLE);
    for (size_t i = 0; i < job->fits && records_go_on(rows); i++)
        (job->is_fitted ? write_fitted : write_fit)(job, i, rows);
}

/* ---- The command ---- */

static void read_plan(const arguments *line, output_options *how, plan *job)
{
    input_texts texts;
    complaint why;
    output_options_read(line, how);
    if (line->operand == NULL || line->operand[0] == NULL)
        usage_error("a log must follow, a file with the columns P, Q and displacement");
    if (line->operand[1] != NULL)
        usage_error("%s: unexpected; allowed: one log", line->operand[1]);
    for (int i = INPUT_P; i <= INPUT_F; i++)
        if (line->value[OPTION_INPUT + i] != NULL)
            usage_error("%s %s: the log has the loads, and tells the friction", input_kinds[i].flag,
                        line->value[OPTION_INPUT + i]);
    input_options_check_hull(line);
    input_texts_from_options(line, &texts);
    if (!case_read(&texts, CASE_LOADS_APART, &job->setup, &why))
        usage_error("%s", why.text);
    load_history_read_measured(line, how->decimal_sign, &job->log);
    if (loads_are_guided(job->log.load, job->log.count))
        failure("%s: column tilt: a log of a loop has none; allowed: --tilt", job->log.name);
    job->is_by_cycle = line->value[OPTION_BY_CYCLE] != NULL;
    job->is_fitted = line->value[OPTION_FITTED] != NULL;
    job->cycles = log_cycles_find(job->log.count, job->log.load, load_displacement);
}

/* The largest |Q| in the rows of the first fit. */
static double largest_Q(const plan *job)
{
    double largest = 0;
    for (size_t i = 0; i < row_count(job, 0); i++)
        largest = fmax(largest, fabs(job->log.load[first_row(job, 0) + i].Q));
    return largest;
}

static int loop(const arguments *line)
{
    plan job = {.fits = 0};
    output_options how;
    read_plan(line, &how, &job);
    compute(&job);
    output_options_write(&how, write_rows, &job);
    unused_say(&job.log.names, job.log.name);
    notice("%s: left of Q: %.4g, the root of its mean square, %.3g %% of its largest", job.log.name,
           job.fit[0].noise, 100 * job.fit[0].noise / fmax(DBL_MIN, largest_Q(&job)));
    for (size_t i = 0; i < job.fits; i++)
        free(job.fit[i].Q);
    free(job.fit);
    free(job.cycles.at);
    rwedge_contact_destroy(job.setup.contact);
    return STATUS_DONE;
}

const command loop_command = {
    .name = "loop",
    .summary = "a measured loop of Q over displacement: friction, the rig's compliance, energy",
    .grammar = {options, "LOG.csv [OPTION...]", describe, OPTION_LOAD},
    .run = loop};
