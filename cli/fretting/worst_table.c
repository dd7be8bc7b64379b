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
    "measure",         "value",           "x",          "y",      "length", "at_length",
    "angle",           "out_of_plane",    "allowable",  "safety", "life",   "cycles",
    "shakedown_lower", "shakedown_upper", "load_factor"};
/* The two of shakedown, of verdicts alone, are of the cycle. */
enum { COLUMNS = sizeof columns / sizeof columns[0], SHAKEDOWN = 12, LOAD_FACTOR = 14 };

static bool is_written(const worst_table *worst, size_t column)
{
    return worst->is_verdict || column < SHAKEDOWN || column >= LOAD_FACTOR;
}

/* The verdict of a criterion: its plane, the allowable value, the life in passes of the loads. */
static void add_verdict(const worst_table *worst, int criterion, const worst_row *row,
                        cell cells[COLUMNS])
{
    worst_verdict its;
    status_check(worst_verdict_of(worst->last, &worst->below, row, criterion, &its),
                 isnan(worst->below.length) ? "the worst place" : "--length");
    const measured_place *at = &its.at;
    const criterion_verdict *judged = &its.judged;
    cells[4] = cell_number(its.is_below ? worst->below.length : NAN);
    cells[5] = cell_number(its.is_below ? judged->value : NAN);
    cells[6] = cell_number(measured_part(at, criterion, PART_ANGLE));
    cells[7] = cell_number(measured_part(at, criterion, PART_OUT_OF_PLANE));
    cells[8] = cell_number(judged->allowable);
    cells[9] = cell_number(judged->safety);
    cells[10] = isinf(judged->life) ? cell_text("inf") : cell_number(judged->life);
    cells[11] = cell_number(measured_part(at, measure_damage(criterion), PART_CYCLES));
    cells[LOAD_FACTOR] = cell_number(its.load_factor);
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
    cell of_cycle[2] = {cell_number(NAN), cell_number(NAN)};
    if (worst->is_verdict)
        add_shakedown(worst->last, of_cycle);
    for (size_t k = 0; k < COLUMNS; k++)
        if (is_written(worst, k))
            records_name(rows, columns[k]);
    records_end_header(rows);
    for (int i = 0; i < measure_count() && records_go_on(rows); i++) {
        const worst_row *row = &worst->row[i];
        const int criterion = measure_criterion(i);
        const bool has_verdict =
            criterion >= 0 && (!asked->is_listed || asked->is_wanted[criterion]);
        cell cells[COLUMNS] = {cell_text(measure_kind_of(i)->column), cell_number(row->value),
                               cell_number(row->x), cell_number(row->y)};
        if (isnan(row->value) || (worst->is_verdict && !has_verdict))
            continue;
        for (size_t k = 4; k < COLUMNS; k++)
            cells[k] = cell_number(NAN);
        if (criterion >= 0)
            add_verdict(worst, criterion, row, cells);
        cells[SHAKEDOWN] = of_cycle[0];
        cells[SHAKEDOWN + 1] = of_cycle[1];
        for (size_t k = 0; k < COLUMNS; k++)
            if (is_written(worst, k))
                records_value(rows, cells[k]);
        records_end_row(rows);
    }
}
