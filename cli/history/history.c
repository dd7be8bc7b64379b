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
    [LOAD] = {"load", "its number, from 1", NULL},
    [P] = {"P", "normal force", NULL},
    [M] = {"M", "moment", NULL},
    [Q] = {"Q", "tangential force", NULL},
    [SIGMA] = {"sigma", "bulk tension", NULL},
    [LEFT] = {"left", "left edge of the contact; empty when separated", NULL},
    [RIGHT] = {"right", "right edge of the contact", NULL},
    [STICK_LEFT] = {"stick_left", "left edge of the stick zone; empty in full sliding", NULL},
    [STICK_RIGHT] = {"stick_right", "right edge of the stick zone", NULL},
    [TILT] = {"tilt", "angle by which the moment tilts body 2, in radians", NULL},
    [PRESSURE] = {"peak_pressure", "largest pressure; empty where it is infinite", NULL},
    [TENSION_LEFT] = {"tension_left", "sxx at the left edge of the contact", NULL},
    [TENSION_RIGHT] = {"tension_right", "sxx at its right edge", NULL},
    [SLIP] = {"largest_slip", "largest magnitude of slip since the bodies touched", NULL},
    [ENERGY] = {"energy", "dissipated by friction so far, per unit thickness", NULL},
    [YIELD_FACTOR] = {"yield_factor", "k over the largest sqrt(J2); needs a yield stress", NULL},
    [YIELD_X] = {"yield_x", "where that is", NULL},
    [YIELD_Y] = {"yield_y", "and how deep", NULL},
    [WARNINGS] = {"warnings", "what makes these numbers doubtful", NULL},
    [ESTIMATE] = {"error", "estimated, of q over f p0, where it is computed; 0 is exact", NULL},
    [P0_X] = {"p0_x", "where the pressure is largest", NULL},
};

/* The row of a load; its warnings are the doubts. */
typedef struct {
    double value[AFTER_COUNT];
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

/* How far a rig that drives the contact slides it is known. */
static void compute(const contact_case *setup, const rwedge_contact *contact, size_t number,
                    bool is_driven, after_load *row)
{
    double *value = row->value;
    for (int i = 0; i < AFTER_COUNT; i++)
        value[i] = NAN;
    value[LOAD] = (double)number;
    rwedge_contact_loads(contact, &value[P], &value[M], &value[Q], &value[SIGMA]);
    const int32_t status = touch(setup, contact, value);
    if (status != RWEDGE_OK)
        failure("load %zu: %s", number, rwedge_strerror(status));
    value[ENERGY] = rwedge_contact_dissipated_energy(contact);
    row->doubts = doubts_of_factor(setup, contact, value[YIELD_FACTOR]);
    row->doubts.bits |= is_driven ? doubt_of_way(contact) : doubt_of_sliding(contact);
    value[ESTIMATE] = row->doubts.error;
}

static void write_after(const after_load *row, records *rows)
{
    cell cells[AFTER_COUNT];
    char warnings[512] = "";
    doubts_write(row->doubts, warnings, sizeof warnings);
    for (int i = 0; i < AFTER_COUNT; i++)
        cells[i] = cell_number(row->value[i]);
    cells[WARNINGS] = cell_text(warnings);
    records_row(rows, AFTER_COUNT, cells);
}

/* ---- The command ---- */

enum { OPTION_PER_CYCLE = OPTION_AFTER_PLACES };

static const struct poptOption options[] = {
    CONTACT_OPTIONS,
    {INCLUDED(history_option_table), "Its loads:", NULL},
    {FLAG("per-cycle", OPTION_PER_CYCLE), "A row for each whole cycle of the log, and their mean",
     NULL},
    {INCLUDED(place_option_table), "Stresses at points in place of a row for each load:", NULL},
    {NO_FORMULAS_OPTION},
    {INCLUDED(output_option_table), "Common options:", NULL},
    POPT_TABLEEND,
};

static void describe(FILE *stream)
{
    fputs("\nLOADS.csv has the columns P and Q, and M and sigma if there are any; or tilt in\n"
          "place of M, the angles at which a rig holds the pad: M is then a result. With\n"
          "--compliance the column displacement, which a rig prescribes, stands in place of\n"
          "Q, a result: that of remote points beyond a contact that is bonded over its\n"
          "half-width under the first load, plus the compliance times Q. Others pass\n"
          "through. Loads run in straight steps from row to row; --cycles goes\n"
          "through the rows again and again (default once). Beside a file, --load gives\n"
          "loads that are applied once, before it. Any consistent units.\n"
          "\nResults, a row for each load:\n",
          stream);
    columns_describe(columns, AFTER_COUNT, 13, stream);
    fputs("\nWith --per-cycle, a row for each whole cycle of the log, which begins where Q (or\n"
          "the displacement, or sigma) rises through the middle of its range:\n",
          stream);
    columns_describe(cycle_columns, CYCLE_COLUMNS, 16, stream);
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
    after_load *row; /* of each load; NULL with points */
    doubts doubts;   /* of any load */
} plan;

/* Nothing is written before the last load is applied. The stresses at points are too many to be
 * kept: then the loads are tried first, and gone through again. */
static void keep_row(void *of_plan, size_t loads, const rwedge_contact *contact)
{
    plan *job = of_plan;
    if (job->row == NULL) {
        doubts_add(&job->doubts, doubts_of_error(contact));
        return;
    }
    if (loads == 0)
        return;
    after_load *row = &job->row[loads - 1];
    const load_history *all = &job->history.loads;
    compute(&job->history.setup, contact, loads, loads_are_driven(all->load, all->count), row);
    doubts_add(&job->doubts, row->doubts);
}

static void write_rows(void *of_plan, records *rows)
{
    const plan *job = of_plan;
    const contact_history *history = &job->history;
    rows->mark = history->loads.has_mark;
    if (job->row == NULL) {
        point_rows_write(history, &job->at, rows);
        return;
    }
    passed_names(&history->loads, rows);
    records_columns(rows, columns, AFTER_COUNT);
    for (size_t step = 0; step < history->steps && records_go_on(rows); step++) {
        passed_cells(&history->loads, contact_history_row(history, step), rows);
        write_after(&job->row[step], rows);
    }
}

/* Dissipated in the last whole cycle of several; NAN where it is not known. */
static double energy_of_cycle(const plan *job)
{
    const size_t loads = job->history.loads.count, cycles = job->history.steps / loads;
    if (job->row == NULL || cycles < 2)
        return NAN;
    return job->row[cycles * loads - 1].value[ENERGY] -
           job->row[(cycles - 1) * loads - 1].value[ENERGY];
}

static void say_doubts(const plan *job)
{
    char where[LOAD_PLACE_SIZE];
    snprintf(where, sizeof where, "%.250s, in some rows: ",
             job->history.loads.name != NULL ? job->history.loads.name : "--load");
    doubts_say(job->doubts, where);
    unused_say(&job->history.loads.names, job->history.loads.name);
    const double energy = energy_of_cycle(job);
    if (!isnan(energy))
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
    if (line->value[OPTION_PER_CYCLE] != NULL) {
        if (has_points)
            usage_error("--per-cycle: not with points");
        cycle_table *table = cycle_table_compute(&job.history);
        output_options_write(&how, cycle_table_write, table);
        cycle_table_free(table);
        unused_say(&job.history.loads.names, job.history.loads.name);
        return STATUS_DONE;
    }
    for (int i = 0; i < (has_points ? (int)POINT_COLUMNS : (int)AFTER_COUNT); i++)
        passed_check(&job.history.loads, has_points ? point_columns[i] : columns[i].name);
    if (!has_points)
        job.row = memory_zeroed(job.history.steps, sizeof *job.row);
    job.history.steps = contact_history_go(&job.history, keep_row, &job);
    output_options_write(&how, write_rows, &job);
    say_doubts(&job);
    return STATUS_DONE;
}

const command history_command = {
    .name = "history",
    .summary = "a table of loads: what the contact is after each, or its stresses",
    .grammar = {options, "LOADS.csv [OPTION...]", describe, OPTION_LOAD},
    .run = history};
