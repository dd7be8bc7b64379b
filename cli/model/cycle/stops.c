/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cycle.h"

#include <math.h>
#include <stdlib.h>

static void add(measured *to, double x, bool is_shown)
{
    to->place[to->count++] = (measured_place){.x = x, .is_shown = is_shown};
}

static int ascending(const void *left, const void *right)
{
    const measured_place *a = left, *b = right;
    if (a->x != b->x)
        return a->x < b->x ? -1 : 1;
    return (int)b->is_shown - (int)a->is_shown;
}

/* Ascending, each once. Of two, one that is shown stays. */
static void sort(measured *all)
{
    size_t kept = 0;
    qsort(all->place, all->count, sizeof *all->place, ascending);
    for (size_t i = 0; i < all->count; i++)
        if (kept == 0 || all->place[i].x > all->place[kept - 1].x)
            all->place[kept++] = all->place[i];
    all->count = all->line = kept;
}

bool stops_find(const last_cycle *cycle, measured *all)
{
    const size_t n = rwedge_cycle_place_count(cycle->cycle);
    double *x = malloc((n + 1) * sizeof *x);
    *all = (measured){.place = malloc((n + 1) * sizeof *all->place), .line = n};
    const bool is_found = x != NULL && all->place != NULL;
    if (is_found)
        rwedge_cycle_places(cycle->cycle, n, x);
    for (size_t i = 0; i < n && is_found; i++)
        add(all, x[i], true);
    free(x);
    return is_found;
}

measured stops_usual(const last_cycle *cycle)
{
    measured all;
    if (!stops_find(cycle, &all))
        memory_checked(NULL);
    return all;
}

static void add_edges(const last_cycle *cycle, double from, double to, measured *all)
{
    const size_t n = rwedge_cycle_edge_count(cycle->cycle);
    double *edge = memory_zeroed(n, sizeof *edge);
    rwedge_cycle_edges(cycle->cycle, n, edge);
    for (size_t i = 0; i < n; i++)
        if (edge[i] >= from && edge[i] <= to)
            add(all, edge[i], false);
    free(edge);
}

measured stops_at(const last_cycle *cycle, size_t n, const double x[])
{
    const size_t most = n + rwedge_cycle_edge_count(cycle->cycle);
    measured all = {.place = memory_zeroed(most, sizeof *all.place)};
    double from = HUGE_VAL, to = -HUGE_VAL;
    for (size_t i = 0; i < n; i++) {
        add(&all, x[i], true);
        from = fmin(from, x[i]);
        to = fmax(to, x[i]);
    }
    add_edges(cycle, from, to, &all);
    sort(&all);
    return all;
}

/* A place cycles, as in rwedge_cycle_worst(), if its amplitude is at least this part of the
 * largest. */
static const double CYCLES = 1e-3;

size_t measured_best(const measured *result, int column)
{
    const bool is_of_fatigue = measure_kind_of(column)->criterion != NO_CRITERION;
    double largest = 0, most = NAN;
    size_t best = 0;
    for (size_t i = 0; i < result->count && is_of_fatigue; i++)
        largest = fmax(largest, result->place[i].amplitude);
    for (size_t i = 0; i < result->count; i++) {
        const double value = result->place[i].value[column];
        if (result->place[i].amplitude < CYCLES * largest || isnan(value))
            continue;
        if (isnan(most) || value > most)
            best = i, most = value;
    }
    return best;
}
