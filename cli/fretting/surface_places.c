/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fretting.h"

#include <math.h>

/* ---- The last cycle ---- */

typedef struct {
    const contact_history *history;
    const criteria *asked;
    last_cycle *cycle;
    doubts *all; /* or NULL */
} course;

static void note_load(void *of_course, size_t loads, const rwedge_contact *contact)
{
    const course *to = of_course;
    const size_t rows = to->history->loads.count, before = to->history->steps - rows;
    if (loads == before)
        last_cycle_begin(&to->history->setup, to->asked, contact, rows, to->cycle);
    if (loads <= before)
        return;
    const load at = to->history->loads.load[contact_history_row(to->history, loads - 1)];
    last_cycle_add(at, contact, to->cycle);
    if (to->all == NULL)
        return;
    doubts_add(to->all, doubts_of_state(&to->history->setup, contact));
    to->all->bits |= at.is_driven ? doubt_of_way(contact) : doubt_of_sliding(contact);
}

void history_cycle(const contact_history *history, const criteria *asked, last_cycle *cycle,
                   doubts *all)
{
    course to = {history, asked, cycle, all};
    if (all != NULL)
        doubts_add(all, history->doubts_before);
    if (contact_history_go(history, note_load, &to) < history->steps)
        usage_error("--until: the loads end before the last one; a cycle needs all of them: leave "
                    "it out, and mend or remove the line that is named");
    status_check(last_cycle_end(cycle), "the cycle");
}

/* ---- Its places ---- */

enum { PLACES_MAX = 1000000 };

/* The places of --x. */
static measured stops_of_range(const char *text, const last_cycle *cycle)
{
    range x;
    range_option("x", text, &x);
    if (x.count > PLACES_MAX)
        usage_error("--x %s: must not have more than %d values", text, PLACES_MAX);
    double *value = memory_zeroed((size_t)x.count, sizeof *value);
    for (int64_t i = 0; i < x.count; i++)
        value[i] = range_value(&x, i);
    return stops_at(cycle, (size_t)x.count, value);
}

static void make_room(size_t count, measured *result)
{
    result->place = memory_resized(result->place, (count + COLUMN_MAX) * sizeof *result->place);
    result->count = count;
}

/* The line at each depth; or the points. */
void surface_places(const arguments *line, char decimal_sign, const last_cycle *cycle,
                    measured *result)
{
    const char *x = line->value[OPTION_X];
    range depth = {0};
    if (line->value[OPTION_AT] != NULL || line->value[OPTION_POINTS] != NULL) {
        places points;
        places_read(line, decimal_sign, &points);
        make_room(points.count, result);
        for (size_t i = 0; i < points.count; i++)
            result->place[i] =
                (measured_place){.x = points.x[i], .y = points.y[i], .is_shown = true};
        return;
    }
    places_read_depth(line, &depth);
    if (x == NULL && isnan(cycle->left))
        usage_error("--x: missing; there is no contact in the cycle to take places from");
    *result = x != NULL ? stops_of_range(x, cycle) : stops_usual(cycle);
    if ((double)result->count * (double)depth.count > PLACES_MAX)
        usage_error("--depth: must not give more than %d places in all", PLACES_MAX);
    make_room(result->count * (size_t)depth.count, result);
    for (size_t i = 0; i < result->count; i++) {
        result->place[i] = result->place[i % result->line];
        result->place[i].y = range_value(&depth, (int64_t)(i / result->line));
    }
}
