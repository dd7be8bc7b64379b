/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cycle.h"

#include <math.h>
#include <stdlib.h>

/* By default: so many steps across the contact, dense at its edges, and so many beyond each edge,
 * as far as its half-width. */
enum { INSIDE = 200, OUTSIDE = 40 };

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

/* Ascending, each once: edges of several loads are one but for rounding. Of two, one that is shown
 * stays. */
static void sort(measured *all, double rounding)
{
    size_t kept = 0;
    qsort(all->place, all->count, sizeof *all->place, ascending);
    for (size_t i = 0; i < all->count; i++)
        if (kept == 0 || all->place[i].x - all->place[kept - 1].x > rounding)
            all->place[kept++] = all->place[i];
        else if (all->place[i].is_shown)
            all->place[kept - 1] = all->place[i];
    all->count = all->line = kept;
}

/* Many loads have edges everywhere. Then those that are close to another are left out: tops are
 * searched between the places too. */
static void add_edges(const last_cycle *cycle, double from, double to, bool is_shown, measured *all)
{
    enum { EDGES_MAX = 200 };
    measured edges = {.place = all->place + all->count};
    for (size_t i = 0; i < cycle->edge_count; i++)
        if (cycle->edges[i] >= from && cycle->edges[i] <= to)
            add(&edges, cycle->edges[i], is_shown);
    const double width = cycle->right - cycle->left;
    sort(&edges, 1e-12 * width);
    if (edges.count > EDGES_MAX)
        sort(&edges, width / EDGES_MAX);
    all->count += edges.count;
}

static measured with_room(size_t count, const last_cycle *cycle)
{
    return (measured){.place = memory_zeroed(count + cycle->edge_count, sizeof(measured_place))};
}

measured stops_usual(const last_cycle *cycle)
{
    measured all = with_room(INSIDE + 2 * OUTSIDE, cycle);
    const double left = cycle->left, right = cycle->right;
    const double middle = (left + right) / 2, half = (right - left) / 2;
    if (isnan(left))
        return all;
    for (int i = 1; i < INSIDE; i++)
        add(&all, middle + half * sin(PI / 2 * (2 * i - INSIDE) / INSIDE), true);
    for (int i = 1; i <= OUTSIDE; i++) {
        const double part = (double)i / OUTSIDE, beyond = half * part * part;
        add(&all, left - beyond, true);
        add(&all, right + beyond, true);
    }
    add_edges(cycle, -HUGE_VAL, HUGE_VAL, true, &all);
    sort(&all, 1e-12 * half);
    return all;
}

measured stops_at(const last_cycle *cycle, size_t n, const double x[])
{
    measured all = with_room(n, cycle);
    double from = HUGE_VAL, to = -HUGE_VAL;
    for (size_t i = 0; i < n; i++) {
        add(&all, x[i], true);
        from = fmin(from, x[i]);
        to = fmax(to, x[i]);
    }
    add_edges(cycle, from, to, false, &all);
    sort(&all, 0);
    return all;
}

/* As in rwedge_contact_cycle_worst(): a place cycles if its amplitude is at least this part of the
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
