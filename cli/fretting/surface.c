/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface.h"

#include "text/message.h"
#include "text/pi.h"

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
    size_t count, room;
    bool failed;
} stops;

static bool grow(stops *to)
{
    const size_t room = 2 * to->room + 512;
    stop *longer = realloc(to->stop, room * sizeof *longer);
    if (longer == NULL)
        return false;
    to->stop = longer;
    to->room = room;
    return true;
}

static void add(stops *to, double x, bool is_shown)
{
    if (isnan(x))
        return;
    if (to->count == to->room && !grow(to))
        to->failed = true;
    else
        to->stop[to->count++] = (stop){x, is_shown};
}

static int ascending(const void *one, const void *other)
{
    const stop *a = one, *b = other;
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

static void add_edges(const last_cycle *of, double from, double to, bool is_shown, stops *all)
{
    for (size_t i = 0; i < of->states; i++) {
        double edge[4] = {of->state[i].left, of->state[i].right, NAN, NAN};
        rwedge_contact_stick_zone(of->state[i].contact, &edge[2], &edge[3]);
        for (int e = 0; e < 4; e++)
            if (edge[e] >= from && edge[e] <= to)
                add(all, edge[e], is_shown);
    }
}

/* ---- By default ---- */

static int add_usual(const last_cycle *of, stops *all)
{
    double left = NAN, right = NAN;
    for (size_t i = 0; i < of->states; i++) {
        left = fmin(left, of->state[i].left);
        right = fmax(right, of->state[i].right);
    }
    if (isnan(left))
        return usage_error("--x: missing; there is no contact in the cycle to take places from");
    const double middle = (left + right) / 2, half = (right - left) / 2;
    for (int i = 1; i < INSIDE; i++)
        add(all, middle + half * sin(PI / 2 * (2 * i - INSIDE) / INSIDE), true);
    for (int i = 1; i <= OUTSIDE; i++) {
        const double part = (double)i / OUTSIDE, beyond = half * part * part;
        add(all, left - beyond, true);
        add(all, right + beyond, true);
    }
    add_edges(of, -HUGE_VAL, HUGE_VAL, true, all);
    sort(all, 1e-12 * half);
    return STATUS_DONE;
}

/* ---- --x ---- */

static int add_range(const char *text, const last_cycle *of, stops *all)
{
    range x = {0};
    const char *complaint = range_read(text, &x);
    if (complaint == NULL && x.count > PLACES_MAX)
        complaint = "must not have more than 1000000 values";
    if (complaint != NULL) {
        range_free(&x);
        return usage_error("--x %s: %s", text, complaint);
    }
    range_say_two_values("x", text);
    double from = HUGE_VAL, to = -HUGE_VAL;
    for (int64_t i = 0; i < x.count; i++) {
        const double value = range_value(&x, i);
        add(all, value, true);
        from = fmin(from, value);
        to = fmax(to, value);
    }
    range_free(&x);
    add_edges(of, from, to, false, all);
    sort(all, 0);
    return STATUS_DONE;
}

/* ---- All ---- */

static int fill_lines(const stops *along, const range *depth, measured *all)
{
    if ((double)along->count * (double)depth->count > PLACES_MAX)
        return usage_error("--depth: must not give more than %d places in all", PLACES_MAX);
    all->count = along->count * (size_t)depth->count;
    all->line = along->count;
    all->place = calloc(all->count + MEASURE_COUNT, sizeof *all->place);
    if (all->place == NULL)
        return failure("out of memory");
    for (size_t i = 0; i < all->count; i++)
        all->place[i] = (measured_place){.x = along->stop[i % all->line].x,
                                         .y = range_value(depth, (int64_t)(i / all->line)),
                                         .is_shown = along->stop[i % all->line].is_shown};
    return STATUS_DONE;
}

static int read_lines(const arguments *given, const last_cycle *of, measured *all)
{
    const char *x = given->value[OPTION_X];
    range depth = {0};
    stops along = {0};
    int status = places_read_depth(given, &depth);
    if (status == STATUS_DONE)
        status = x != NULL ? add_range(x, of, &along) : add_usual(of, &along);
    if (status == STATUS_DONE)
        status = along.failed ? failure("out of memory") : fill_lines(&along, &depth, all);
    free(along.stop);
    range_free(&depth);
    return status;
}

static int take_points(const places *points, measured *all)
{
    all->count = points->count;
    all->place = calloc(points->count + MEASURE_COUNT, sizeof *all->place);
    if (all->place == NULL)
        return failure("out of memory");
    for (size_t i = 0; i < points->count; i++)
        all->place[i] = (measured_place){.x = points->x[i], .y = points->y[i], .is_shown = true};
    return STATUS_DONE;
}

int surface_places(const arguments *given, char decimal_sign, const last_cycle *of, measured *all)
{
    places points = {0};
    *all = (measured){0};
    if (given->value[OPTION_AT] == NULL && given->value[OPTION_POINTS] == NULL)
        return read_lines(given, of, all);
    int status = places_read(given, decimal_sign, &points);
    if (status == STATUS_DONE)
        status = take_points(&points, all);
    places_free(&points);
    return status;
}

bool surface_usual(const last_cycle *of, measured *all)
{
    const range surface = {.count = 1};
    stops along = {0};
    *all = (measured){0};
    const bool done = add_usual(of, &along) == STATUS_DONE && !along.failed &&
                      fill_lines(&along, &surface, all) == STATUS_DONE;
    free(along.stop);
    return done;
}
