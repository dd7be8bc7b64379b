/* SPDX-License-Identifier: GPL-3.0-or-later */
/* "rwedge history". */
#include "history.h"

#include <math.h>
#include <string.h>

/* ---- What a contact is after a load ---- */

/* The columns: the load and the zones, then what they lead to. */
enum { LOAD, P, M, Q, SIGMA, LEFT, RIGHT, STICK_LEFT, STICK_RIGHT, TILT, AFTER_ZONES };
enum { PRESSURE = AFTER_ZONES, TENSION_LEFT, TENSION_RIGHT, SLIP, ENERGY, AFTER_ENERGY };
enum { YIELD_FACTOR = AFTER_ENERGY, YIELD_X, YIELD_Y, WARNINGS, ESTIMATE, P0_X, AFTER_COUNT };

static const column_kind columns[AFTER_COUNT] = {
    {"load", "its number, from 1", NULL},
    {"P", "normal force", NULL},
    {"M", "moment", NULL},
    {"Q", "tangential force", NULL},
    {"sigma", "bulk tension", NULL},
    {"left", "left edge of the contact; empty when separated", NULL},
    {"right", "right edge of the contact", NULL},
    {"stick_left", "left edge of the stick zone; empty in full sliding", NULL},
    {"stick_right", "right edge of the stick zone", NULL},
    {"tilt", "angle by which the moment tilts body 2, in radians", NULL},
    {"peak_pressure", "largest pressure; empty where it is infinite", NULL},
    {"tension_left", "sxx at the left edge of the contact", NULL},
    {"tension_right", "sxx at its right edge", NULL},
    {"largest_slip", "largest magnitude of slip since the bodies touched", NULL},
    {"energy", "dissipated by friction so far, per unit thickness", NULL},
    {"yield_factor", "k over the largest sqrt(J2); needs a yield stress", NULL},
    {"yield_x", "where that is", NULL},
    {"yield_y", "and how deep", NULL},
    {"warnings", "what makes these numbers doubtful", NULL},
    {"error", "estimated, of q over f p0, where it is computed; 0 is exact", NULL},
    {"p0_x", "where the pressure is largest", NULL},
};

/* The row of a load. */
typedef struct {
    cell value[AFTER_COUNT];
    char warnings[512]; /* the text of their cell */
    doubts doubts;
} after_load;

/* What there is to tell of a contact that touches. */
static int32_t touch(const contact_case *setup, const rwedge_contact *contact, double value[])
{
    int32_t status = edge_tensions(contact, &value[LEFT], &value[TENSION_LEFT]);
    if (isnan(value[LEFT]))
        return RWEDGE_OK;
    rwedge_contact_stick_zone(contact, &value[STICK_LEFT], &value[STICK_RIGHT]);
    value[TILT] = rwedge_contact_tilt(contact);
    const int32_t peak = rwedge_contact_peak_pressure(contact, &value[PRESSURE], &value[P0_X]);
    if (status == RWEDGE_OK && peak != RWEDGE_EABSENT)
        status = peak;
    double x;
    rwedge_contact_largest_slip(contact, &value[SLIP], &x); /* or it is not known */
    if (status != RWEDGE_OK || isnan(setup->k))
        return status;
    status = rwedge_contact_yield_factor(contact, setup->nu1, setup->k, &value[YIELD_FACTOR],
                                         &value[YIELD_X], &value[YIELD_Y]);
    yield_place_settle(&value[YIELD_X], &value[YIELD_Y]);
    return status == RWEDGE_EABSENT ? RWEDGE_OK : status;
}

static void compute(const contact_case *setup, const rwedge_contact *contact, size_t number,
                    after_load *row)
{
    double value[AFTER_COUNT];
    for (int i = 0; i < AFTER_COUNT; i++)
        value[i] = NAN;
    value[LOAD] = (double)number;
    rwedge_contact_loads(contact, &value[P], &value[M], &value[Q], &value[SIGMA]);
    const int32_t status = touch(setup, contact, value);
    if (status != RWEDGE_OK)
        failure("load %zu: %s", number, rwedge_strerror(status));
    value[ENERGY] = rwedge_contact_dissipated_energy(contact);
    row->doubts = doubts_of_factor(setup, contact, value[YIELD_FACTOR]);
    row->doubts.bits |= doubt_of_sliding(contact);
    value[ESTIMATE] = row->doubts.error;
    for (int i = 0; i < AFTER_COUNT; i++)
        row->value[i] = cell_number(value[i]);
    row->warnings[0] = '\0';
    doubts_write(row->doubts, row->warnings, sizeof row->warnings);
    row->value[WARNINGS] = cell_text(row->warnings);
}

/* ---- The command ---- */

static const struct poptOption options[] = {
    {INCLUDED(input_option_table), "The contact:", NULL},
    {INCLUDED(strength_option_table), "Its strength:", NULL},
    {INCLUDED(history_option_table), "Its loads:", NULL},
    {INCLUDED(place_option_table), "Stresses at points in place of a row for each load:", NULL},
    {NO_FORMULAS_OPTION},
    {INCLUDED(output_option_table), "Common options:", NULL},
    POPT_TABLEEND,
};

static void describe(FILE *stream)
{
    fputs("\nLOADS.csv has the columns P and Q, and M and sigma if there are any. Others\n"
          "pass through. Loads run in straight steps from row to row; --cycles goes through\n"
          "the rows again and again (default once). Beside a file, --load gives loads that\n"
          "are applied once, before it. Any consistent units.\n"
          "\nResults, a row for each load:\n",
          stream);
    columns_describe(columns, AFTER_COUNT, 13, stream);
    fputs("\nWith points, a row for each load and point: load, x, y (the depth), sxx, syy,\n"
          "szz, txy, s1, s2, von_mises, tau_max.\n"
          "\nLoads that have no closed form are computed. With --exact they are an error that\n"
          "names the line; nothing is then written, unless --until is given.\n",
          stream);
}

/* The contact, its loads and the points to write. */
typedef struct {
    contact_history history;
    places at;
    doubts doubts;    /* of any load */
    double energy[2]; /* at the end, and a cycle before */
} plan;

static void write_load(plan *job, size_t step, const rwedge_contact *contact, records *rows)
{
    after_load row;
    const load_history *loads = &job->history.loads;
    const size_t place = contact_history_row(&job->history, step);
    compute(&job->history.setup, contact, step + 1, &row);
    doubts_add(&job->doubts, row.doubts);
    passed_cells(loads, place, rows);
    records_row(rows, AFTER_COUNT, row.value);
    if (place + 1 == loads->count) {
        job->energy[0] = job->energy[1];
        job->energy[1] = rwedge_contact_dissipated_energy(contact);
    }
    progress_step();
}

static void write_rows(void *of_plan, records *rows)
{
    plan *job = of_plan;
    const point_rows points = {&job->history, &job->at};
    const size_t count = job->history.steps * (job->at.count > 0 ? job->at.count : 1);
    progress_start(rows->show_progress, (int64_t)count, "rows");
    rows->mark = job->history.loads.has_mark;
    if (job->at.count > 0) {
        point_rows_write(&points, rows);
        return;
    }
    rwedge_contact *contact = contact_history_begin(&job->history);
    passed_names(&job->history.loads, rows);
    records_columns(rows, columns, AFTER_COUNT);
    for (size_t step = 0; step < job->history.steps && records_go_on(rows); step++) {
        contact_history_go_on(&job->history, step, contact);
        write_load(job, step, contact, rows);
    }
}

static void say_doubts(const plan *job)
{
    char where[LOAD_PLACE_SIZE];
    snprintf(where, sizeof where, "%.250s, in some rows: ",
             job->history.loads.name != NULL ? job->history.loads.name : "--load");
    doubts all = job->doubts;
    doubts_add(&all, (doubts){.error = job->history.error}); /* with points no row says it */
    doubts_say(all, where);
    unused_say(&job->history.loads.names, job->history.loads.name);
    const double energy = job->energy[1] - job->energy[0]; /* NAN where it is not known */
    if (job->history.cycles > 1 && job->at.count == 0 && !isnan(energy))
        notice("dissipated in the last cycle: %.6g", energy);
}

static int history(const arguments *line)
{
    plan job = {.at = {0}};
    output_options how;
    input_texts texts;
    output_options_read(line, &how);
    if (line->value[OPTION_X] == NULL && line->value[OPTION_DEPTH] != NULL)
        usage_error("--depth %s: needs --x", line->value[OPTION_DEPTH]);
    places_read(line, how.decimal_sign, &job.at);
    input_texts_from_options(line, &texts);
    contact_history_read(line, &texts, how.decimal_sign, 1, 1, &job.history);
    const bool has_points = job.at.count > 0;
    for (int i = 0; i < (has_points ? (int)POINT_COLUMNS : (int)AFTER_COUNT); i++)
        passed_check(&job.history.loads, has_points ? point_columns[i] : columns[i].name);
    output_options_write(&how, write_rows, &job);
    say_doubts(&job);
    return STATUS_DONE;
}

const command history_command = {
    .name = "history",
    .summary = "a table of loads: what the contact is after each, or its stresses",
    .grammar = {options, "LOADS.csv [OPTION...]", describe, OPTION_LOAD},
    .run = history};
