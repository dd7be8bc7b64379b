/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fretting.h"

#include <math.h>
#include <stdlib.h>

void worst_find(const measured *result, worst_table *worst)
{
    status_check(worst_places(worst->last, result, worst->row), "the worst place");
}

/* ---- Among the places ---- */

static int in_order(const void *left, const void *right)
{
    const measured_place *a = left, *b = right;
    if (a->y != b->y)
        return a->y < b->y ? -1 : 1;
    return a->x < b->x ? -1 : a->x > b->x ? 1 : 0;
}

void worst_add_places(const worst_table *worst, measured *result)
{
    const size_t count = result->count;
    for (int i = 0; i < measure_count(); i++) {
        const worst_row *row = &worst->row[i];
        bool is_there = isnan(row->value);
        for (size_t k = 0; k < result->count && !is_there; k++) {
            const measured_place *place = &result->place[k];
            is_there = place->x == row->x && place->y == row->y && place->is_shown;
        }
        if (is_there)
            continue;
        result->place[result->count++] = /* there is room */
            (measured_place){.x = row->x, .y = row->y, .is_shown = true};
    }
    if (result->count == count)
        return;
    status_check(last_cycle_measure(worst->last, result->count - count, result->place + count),
                 "the worst places");
    qsort(result->place, result->count, sizeof *result->place, in_order);
}

/* ---- In words ---- */

void worst_write(const worst_table *worst, bool is_deep, char *text, size_t size)
{
    text[0] = '\0';
    for (int i = 0; i < measure_count(); i++) {
        const worst_row *row = &worst->row[i];
        if (isnan(row->value))
            continue;
        list_add(text, size, "; ", "%s %.6g at x = %.6g", measure_kind_of(i)->column, row->value,
                 row->x + 0);
        if (is_deep)
            list_add(text, size, "", ", y = %.6g", row->y + 0);
        if (!isnan(row->cycles))
            list_add(text, size, "", " (%.0f cycle%s)", row->cycles, row->cycles == 1 ? "" : "s");
    }
}

/* ---- As rows ---- */

static const char *const columns[] = {
    "measure",      "value",     "x",      "y",    "length", "at_length",       "angle",
    "out_of_plane", "allowable", "safety", "life", "cycles", "shakedown_lower", "shakedown_upper"};
/* The last two, of verdicts alone, are of the cycle. */
enum { VERDICT_COLUMNS = sizeof columns / sizeof columns[0], COLUMNS = VERDICT_COLUMNS - 2 };

/* The criteria below the worst place of the surface, of the stresses of each load there; the means
 * may not settle to 1e-10 of the stresses. */
static measured_place measures_below(const last_cycle *cycle, const distance *below, double x)
{
    const size_t n = cycle->loads;
    measured_place at;
    double *stress = memory_zeroed(3 * n, sizeof *stress);
    status_check(rwedge_cycle_below(cycle->cycle, n, x, below->angle * PI / 180, below->length,
                                    below->is_line, stress, stress + n, stress + 2 * n),
                 "--length");
    status_check(last_cycle_criteria(cycle, 1, stress, &at), "--length");
    return at;
}

/* The verdict of a criterion: its plane, the allowable value, the life in passes of the loads. */
static void add_verdict(const worst_table *worst, int criterion, const worst_row *row,
                        cell cells[COLUMNS])
{
    const bool is_below = !isnan(worst->below.length) && row->y == 0;
    measured_place at = {.x = row->x, .y = row->y};
    if (is_below)
        at = measures_below(worst->last, &worst->below, row->x);
    else
        status_check(last_cycle_measure(worst->last, 1, &at), "the worst place");
    const criterion_verdict judged = criterion_verdict_at(&worst->last->asked, &at, criterion);
    cells[4] = cell_number(is_below ? worst->below.length : NAN);
    cells[5] = cell_number(is_below ? judged.value : NAN);
    cells[6] = cell_number(measured_part(&at, criterion, PART_ANGLE));
    cells[7] = cell_number(measured_part(&at, criterion, PART_OUT_OF_PLANE));
    cells[8] = cell_number(judged.allowable);
    cells[9] = cell_number(judged.safety);
    cells[10] = isinf(judged.life) ? cell_text("inf") : cell_number(judged.life);
    cells[11] = cell_number(measured_part(&at, measure_damage(criterion), PART_CYCLES));
}

/* The factors on the stresses between which the shakedown of the cycle is; empty without a yield
 * stress, and where the library has none. */
static void add_shakedown(const last_cycle *last, cell cells[2])
{
    double lower, upper, x, y;
    cells[0] = cells[1] = cell_number(NAN);
    if (isnan(last->setup->k) || last->cycle == NULL ||
        rwedge_cycle_shakedown(last->cycle, last->asked.nu, last->setup->k, &lower, &upper, &x,
                               &y) != RWEDGE_OK)
        return;
    cells[0] = cell_number(lower);
    cells[1] = cell_number(upper);
}

void worst_write_rows(void *of_worst, records *rows)
{
    const worst_table *worst = of_worst;
    const criteria *asked = &worst->last->asked;
    const size_t count = worst->is_verdict ? VERDICT_COLUMNS : COLUMNS;
    cell of_cycle[2];
    if (worst->is_verdict)
        add_shakedown(worst->last, of_cycle);
    records_header(rows, count, columns);
    for (int i = 0; i < measure_count() && records_go_on(rows); i++) {
        const worst_row *row = &worst->row[i];
        const int criterion = measure_criterion(i);
        const bool has_verdict =
            criterion >= 0 && (!asked->is_listed || asked->is_wanted[criterion]);
        cell cells[VERDICT_COLUMNS] = {cell_text(measure_kind_of(i)->column),
                                       cell_number(row->value), cell_number(row->x),
                                       cell_number(row->y)};
        if (isnan(row->value) || (worst->is_verdict && !has_verdict))
            continue;
        for (int k = 4; k < COLUMNS; k++)
            cells[k] = cell_number(NAN);
        if (criterion >= 0)
            add_verdict(worst, criterion, row, cells);
        for (size_t k = COLUMNS; k < count; k++)
            cells[k] = of_cycle[k - COLUMNS];
        records_row(rows, count, cells);
    }
}
