/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface.h"

#include "text/memory.h"
#include "text/message.h"
#include "number/pi.h"

#include <math.h>
#include <stdlib.h>

/* By default: so many steps across the contact, dense at its edges, and so many beyond each edge,
 * as far as its half-width. */
enum { INSIDE = 200, OUTSIDE = 40, PLACES_MAX = 1000000 };

typedef struct {
    double x;
    bool is_shown;
} stop;

typedef struct {
    stop *stop;
    size_t count;
} stops;

static void add(stops *to, double x, bool is_shown)
{
    to->stop[to->count++] = (stop){x, is_shown};
}

static int ascending(const void *left, const void *right)
{
    const stop *a = left, *b = right;
    if (a->x != b->x)
        return a->x < b->x ? -1 : 1;
    return (int)b->is_shown - (int)a->is_shown;
}

/* Ascending, each once: edges of several loads are one but for rounding. Of two, one that is shown
 * stays. */
static void sort(stops *all, double rounding)
{
    size_t kept = 0;
    qsort(all->stop, all->count, sizeof *all->stop, ascending);
    for (size_t i = 0; i < all->count; i++)
        if (kept == 0 || all->stop[i].x - all->stop[kept - 1].x > rounding)
            all->stop[kept++] = all->stop[i];
        else if (all->stop[i].is_shown)
            all->stop[kept - 1] = all->stop[i];
    all->count = kept;
}

/* Many loads have edges everywhere. Then those that are close to another are left out: tops are
 * searched between the places too. */
static void add_edges(const last_cycle *cycle, double from, double to, bool is_shown, stops *all)
{
    enum { EDGES_MAX = 200 };
    stops edges = {all->stop + all->count, 0};
    for (size_t i = 0; i < cycle->edge_count; i++)
        if (cycle->edges[i] >= from && cycle->edges[i] <= to)
            add(&edges, cycle->edges[i], is_shown);
    const double width = cycle->right - cycle->left;
    sort(&edges, 1e-12 * width);
    if (edges.count > EDGES_MAX)
        sort(&edges, width / EDGES_MAX);
    all->count += edges.count;
}

/* ---- By default ---- */

static void add_usual(const last_cycle *cycle, stops *all)
{
    const double left = cycle->left, right = cycle->right;
    const double middle = (left + right) / 2, half = (right - left) / 2;
    all->stop = memory_zeroed(INSIDE + 2 * OUTSIDE + cycle->edge_count, sizeof *all->stop);
    for (int i = 1; i < INSIDE; i++)
        add(all, middle + half * sin(PI / 2 * (2 * i - INSIDE) / INSIDE), true);
    for (int i = 1; i <= OUTSIDE; i++) {
        const double part = (double)i / OUTSIDE, beyond = half * part * part;
        add(all, left - beyond, true);
        add(all, right + beyond, true);
    }
    add_edges(cycle, -HUGE_VAL, HUGE_VAL, true, all);
    sort(all, 1e-12 * half);
}

/* ---- --x ---- */

static void add_range(const char *text, const last_cycle *cycle, stops *all)
{
    range x = {0};
    const char *complaint = range_read(text, &x);
    if (complaint == NULL && x.count > PLACES_MAX)
        complaint = "must not have more than 1000000 values";
    if (complaint != NULL)
        usage_error("--x %s: %s", text, complaint);
    range_say_two_values("x", text);
    all->stop = memory_zeroed((size_t)x.count + cycle->edge_count, sizeof *all->stop);
    double from = HUGE_VAL, to = -HUGE_VAL;
    for (int64_t i = 0; i < x.count; i++) {
        const double value = range_value(&x, i);
        add(all, value, true);
        from = fmin(from, value);
        to = fmax(to, value);
    }
    range_free(&x);
    add_edges(cycle, from, to, false, all);
    sort(all, 0);
}

/* ---- All ---- */

static measured *begin(size_t count, size_t line, measured *all)
{
    *all = (measured){.count = count, .line = line};
    all->place = memory_zeroed(count + COLUMN_COUNT, sizeof *all->place);
    return all;
}

static void fill_lines(const stops *along, const range *depth, measured *all)
{
    if ((double)along->count * (double)depth->count > PLACES_MAX)
        usage_error("--depth: must not give more than %d places in all", PLACES_MAX);
    begin(along->count * (size_t)depth->count, along->count, all);
    for (size_t i = 0; i < all->count; i++)
        all->place[i] = (measured_place){.x = along->stop[i % all->line].x,
                                         .y = range_value(depth, (int64_t)(i / all->line)),
                                         .is_shown = along->stop[i % all->line].is_shown};
}

static void read_lines(const arguments *line, const last_cycle *cycle, measured *all)
{
    const char *x = line->value[OPTION_X];
    range depth = {0};
    stops along = {0};
    places_read_depth(line, &depth);
    if (x == NULL && isnan(cycle->left))
        usage_error("--x: missing; there is no contact in the cycle to take places from");
    if (x != NULL)
        add_range(x, cycle, &along);
    else
        add_usual(cycle, &along);
    fill_lines(&along, &depth, all);
    free(along.stop);
    range_free(&depth);
}

void surface_places(const arguments *line, char decimal_sign, const last_cycle *cycle,
                    measured *all)
{
    places points = {0};
    if (line->value[OPTION_AT] == NULL && line->value[OPTION_POINTS] == NULL) {
        read_lines(line, cycle, all);
        return;
    }
    places_read(line, decimal_sign, &points);
    begin(points.count, 0, all);
    for (size_t i = 0; i < points.count; i++)
        all->place[i] = (measured_place){.x = points.x[i], .y = points.y[i], .is_shown = true};
    places_free(&points);
}

bool surface_usual(const last_cycle *cycle, measured *all)
{
    const range surface = {.count = 1};
    stops along = {0};
    if (isnan(cycle->left))
        return false;
    add_usual(cycle, &along);
    fill_lines(&along, &surface, all);
    free(along.stop);
    return true;
}

int32_t surface_measure(const last_cycle *cycle, measured *all)
{
    const size_t n = all->count;
    double *x = memory_zeroed(2 * n, sizeof *x), *y = x + n;
    measures *at = memory_zeroed(n, sizeof *at);
    for (size_t i = 0; i < n; i++) {
        x[i] = all->place[i].x;
        y[i] = all->place[i].y;
    }
    const int32_t status = last_cycle_measure(cycle, n, x, y, at);
    for (size_t i = 0; i < n; i++)
        all->place[i].at = at[i];
    free(x);
    free(at);
    return status;
}
