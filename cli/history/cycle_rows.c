/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Each whole cycle of a log for itself, from the contact before it. */
#include "history.h"

#include <math.h>
#include <stdlib.h>

enum { CYCLE, LINE, LOADS, ENERGY, NEVER_LEFT, NEVER_RIGHT, SLIP, Q_LEAST, Q_MOST };

const column_kind cycle_columns[CYCLE_COLUMNS] = {
    [CYCLE] = {"cycle", "its number, from 1; then the mean", NULL},
    [LINE] = {"first_load", "the number of its first load", NULL},
    [LOADS] = {"loads", "how many it has", NULL},
    [ENERGY] = {"energy_per_cycle", "dissipated in it, per unit thickness", NULL},
    [NEVER_LEFT] = {"never_left", "left edge of the zone that never slips in it; or empty", NULL},
    [NEVER_RIGHT] = {"never_right", "its right edge", NULL},
    [SLIP] = {"slip_range", "the largest range of slip of a place", NULL},
    [Q_LEAST] = {"Q_min", "the smallest Q", NULL},
    [Q_MOST] = {"Q_max", "the largest Q", NULL},
};

typedef struct {
    double value[CYCLE_COLUMNS];
} cycle_row;

struct cycle_table {
    const contact_history *history;
    log_cycles cycles;
    criteria asked;
    last_cycle now; /* the cycle at hand */
    double energy;  /* before it */
    cycle_row *row;
    size_t count, all;
};

/* ---- A cycle ---- */

/* The largest at its places; NAN where slip is not known. */
static double largest_slip(const contact_case *setup, const last_cycle *now)
{
    const size_t n = rwedge_cycle_place_count(now->cycle);
    double *x = memory_zeroed(5 * n + 1, sizeof *x), *slip = x + n, most = 0;
    size_t known = 0;
    status_check(rwedge_cycle_places(now->cycle, n, x), "the places");
    for (size_t i = 0; i < n; i++)
        if (!pad_is_kink(&setup->shape, x[i]))
            x[known++] = x[i];
    if (!now->slip_known || rwedge_cycle_friction(now->cycle, known, x, slip, slip + n,
                                                  slip + 2 * n, slip + 3 * n) != RWEDGE_OK)
        most = NAN;
    for (size_t i = 0; i < known && !isnan(most); i++)
        most = fmax(most, slip[i]);
    free(x);
    return most;
}

static void end_cycle(cycle_table *table, const rwedge_contact *contact)
{
    double *value = table->row[table->count].value;
    last_cycle *now = &table->now;
    status_check(last_cycle_end(now), "the cycle");
    value[CYCLE] = (double)++table->count;
    value[LOADS] = (double)now->loads;
    value[ENERGY] = rwedge_contact_dissipated_energy(contact) - table->energy;
    value[NEVER_LEFT] = value[NEVER_RIGHT] = NAN;
    rwedge_cycle_permanent_stick(now->cycle, &value[NEVER_LEFT], &value[NEVER_RIGHT]);
    value[SLIP] = largest_slip(&table->history->setup, now);
    value[Q_LEAST] = HUGE_VAL;
    value[Q_MOST] = -HUGE_VAL;
    for (size_t i = 0; i < now->loads; i++) {
        value[Q_LEAST] = fmin(value[Q_LEAST], now->Q[i]);
        value[Q_MOST] = fmax(value[Q_MOST], now->Q[i]);
    }
    last_cycle_free(now);
}

static void see_load(void *of_table, size_t loads, const rwedge_contact *contact)
{
    cycle_table *table = of_table;
    const contact_history *history = table->history;
    const size_t *at = table->cycles.at + table->count;
    if (loads == 0 || table->count == table->all || loads - 1 < at[0])
        return;
    if (loads - 1 > at[0])
        last_cycle_add(history->loads.load[loads - 1], contact, &table->now);
    if (loads - 1 == at[1]) {
        end_cycle(table, contact);
        at++;
    }
    if (loads - 1 != at[0] || table->count == table->all)
        return;
    table->row[table->count].value[LINE] = (double)(loads + 1);
    table->energy = rwedge_contact_dissipated_energy(contact);
    last_cycle_begin(&history->setup, &table->asked, contact, at[1] - at[0], &table->now);
}

cycle_table *cycle_table_compute(const contact_history *history)
{
    const load_history *loads = &history->loads;
    cycle_table *table = memory_zeroed(1, sizeof *table);
    if (history->steps != loads->count)
        usage_error("--per-cycle: the cycles are those of the log; allowed: --cycles 1");
    table->history = history;
    table->cycles =
        log_cycles_find(loads->count, loads->load, load_part_of_cycles(loads->count, loads->load));
    if (table->cycles.count < 2)
        failure("%s: no whole cycle: Q does not rise twice through the middle of its range, nor "
                "ends where it began",
                loads->name != NULL ? loads->name : "--load");
    table->asked = criteria_usual(&history->setup);
    table->all = table->cycles.count - 1;
    table->row = memory_zeroed(table->all, sizeof *table->row);
    contact_history_go(history, see_load, table);
    return table;
}

void cycle_table_free(cycle_table *table)
{
    free(table->cycles.at);
    free(table->row);
    free(table);
}

/* ---- Rows ---- */

/* The loads of the mean have no number; a zone that is not there in one cycle has none. */
static void write_mean(const cycle_table *table, records *rows)
{
    cell cells[CYCLE_COLUMNS];
    for (int k = 0; k < CYCLE_COLUMNS; k++) {
        double sum = 0;
        for (size_t i = 0; i < table->count; i++)
            sum += table->row[i].value[k];
        cells[k] = cell_number(sum / (double)table->count);
    }
    cells[CYCLE] = cell_text("mean");
    cells[LINE] = cell_number(NAN);
    records_row(rows, CYCLE_COLUMNS, cells);
}

void cycle_table_write(void *of_table, records *rows)
{
    const cycle_table *table = of_table;
    records_columns(rows, cycle_columns, CYCLE_COLUMNS);
    for (size_t i = 0; i < table->count && records_go_on(rows); i++) {
        cell cells[CYCLE_COLUMNS];
        for (int k = 0; k < CYCLE_COLUMNS; k++)
            cells[k] = cell_number(table->row[i].value[k]);
        records_row(rows, CYCLE_COLUMNS, cells);
    }
    if (table->count > 0)
        write_mean(table, rows);
}
