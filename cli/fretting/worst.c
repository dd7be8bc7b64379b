/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "worst.h"

#include "text/list.h"
#include "text/message.h"

#include <math.h>
#include <stdlib.h>

/* ---- The search ---- */

static size_t best_place(const measured *all, int column)
{
    size_t best = 0;
    for (size_t i = 0; i < all->count; i++) {
        const double value = all->place[i].at.value[column];
        if (isnan(all->place[best].at.value[column]) || value > all->place[best].at.value[column])
            best = i;
    }
    return best;
}

/* On the line of the best place, between the places too. */
static void search_line(const last_cycle *last, const measured *all, int column, size_t first,
                        worst_row *row)
{
    double *x = malloc(2 * all->line * sizeof *x), *value = x + all->line;
    if (x == NULL)
        failure("out of memory");
    for (size_t i = 0; i < all->line; i++) {
        x[i] = all->place[first + i].x;
        value[i] = fmax(all->place[first + i].at.value[column], 0);
    }
    const worst_place worst = last_cycle_worst(last, column, all->line, x, value, row->y);
    row->x = worst.x;
    row->value = worst.value;
    free(x);
}

void worst_find(const last_cycle *last, const measured *all, worst_table *worst)
{
    worst->last = last;
    for (int i = 0; i < COLUMN_COUNT; i++) {
        const size_t best = best_place(all, i);
        const double value = all->place[best].at.value[i];
        const bool is_worst =
            value > 0 && !column_kind_of(i)->is_angle && column_is_wanted(&last->asked, i);
        worst->row[i] = (worst_row){all->place[best].x, all->place[best].y, is_worst ? value : NAN};
        if (all->line > 0 && is_worst)
            search_line(last, all, i, best - best % all->line, &worst->row[i]);
    }
}

/* ---- Among the places ---- */

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

static measures measures_at(const last_cycle *last, double x, double y)
{
    measures at;
    const int32_t status = last_cycle_measure(last, 1, &x, &y, &at);
    if (status != RWEDGE_OK)
        failure("%s", rwedge_strerror(status));
    return at;
}

void worst_add_places(const worst_table *worst, measured *all)
{
    const size_t count = all->count;
    for (int i = 0; i < COLUMN_COUNT; i++) {
        const worst_row *row = &worst->row[i];
        if (isnan(row->value) || is_there(all, row->x, row->y))
            continue;
        all->place[all->count++] = /* there is room */
            (measured_place){row->x, row->y, measures_at(worst->last, row->x, row->y), true};
    }
    if (all->count > count)
        qsort(all->place, all->count, sizeof *all->place, in_order);
}

/* ---- In words ---- */

void worst_write(const worst_table *worst, bool is_deep, char *text, size_t size)
{
    text[0] = '\0';
    for (int i = 0; i < COLUMN_COUNT; i++) {
        const worst_row *row = &worst->row[i];
        char value[NUMBER_SIZE], x[NUMBER_SIZE], y[NUMBER_SIZE];
        if (isnan(row->value))
            continue;
        number_write(row->value, 6, '.', value);
        number_write(row->x, 6, '.', x);
        number_write(row->y, 6, '.', y);
        list_add(text, size, "; ", "%s %s at x = %s%s%s", column_kind_of(i)->column, value, x,
                 is_deep ? ", y = " : "", is_deep ? y : "");
    }
}

/* ---- As rows ---- */

static const char *const columns[] = {"measure", "value", "x", "y", "angle", "out_of_plane"};
enum { COLUMNS = sizeof columns / sizeof columns[0] };

static void write_row(const worst_table *worst, int column, records *rows)
{
    const worst_row *row = &worst->row[column];
    const int criterion = column_criterion(column);
    double angle = NAN, out_of_plane = NAN;
    if (criterion >= 0 && criterion_kinds[criterion].angle > 0) {
        const measures at = measures_at(worst->last, row->x, row->y);
        angle = at.value[criterion_kinds[criterion].angle];
        out_of_plane = at.value[criterion_kinds[criterion].out_of_plane];
    }
    const cell cells[COLUMNS] = {cell_text(column_kind_of(column)->column),
                                 cell_number(row->value),
                                 cell_number(row->x),
                                 cell_number(row->y),
                                 cell_number(angle),
                                 cell_number(out_of_plane)};
    for (int i = 0; i < COLUMNS; i++)
        rows->format->value(rows, columns[i], cells[i]);
    rows->format->end_row(rows);
}

bool worst_write_rows(void *of_worst, records *rows, bool show_progress)
{
    const worst_table *worst = of_worst;
    (void)show_progress;
    rows->format->begin(rows);
    for (int i = 0; i < COLUMNS; i++)
        rows->format->name(rows, columns[i]);
    rows->format->end_header(rows);
    for (int i = 0; i < COLUMN_COUNT && records_go_on(rows); i++)
        if (!isnan(worst->row[i].value))
            write_row(worst, i, rows);
    rows->format->end(rows);
    return records_are_sound(rows);
}
