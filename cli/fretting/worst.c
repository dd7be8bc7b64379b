/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "worst.h"

#include "history/peak.h"

#include <math.h>

typedef struct {
    const last_cycle *of;
    double y;
    int measure;
} line_of_sight;

static double measure_at(const void *of_line, double x)
{
    const line_of_sight *line = of_line;
    measures found;
    return last_cycle_measure(line->of, 1, &x, &line->y, &found) == RWEDGE_OK
               ? found.value[line->measure]
               : NAN;
}

static size_t best_place(const measured *all, int measure)
{
    size_t best = 0;
    for (size_t i = 0; i < all->count; i++) {
        const double value = all->place[i].found.value[measure];
        if (isnan(all->place[best].found.value[measure]) ||
            value > all->place[best].found.value[measure])
            best = i;
    }
    return best;
}

/* Another top is worth a search if its place comes so near to the best one. */
static const double NEARLY = 0.97;
enum { SEARCHES = 8 }; /* enough for tops; a plateau has more */

/* Whether the place is a top of its line, the ends included; a NAN counts as lower. */
static bool is_top(const measured *all, size_t first, size_t i, int measure)
{
    const double value = all->place[i].found.value[measure];
    return (i == first || !(all->place[i - 1].found.value[measure] > value)) &&
           (i + 1 == first + all->line || !(all->place[i + 1].found.value[measure] > value));
}

worst_place worst_of(const last_cycle *of, const measured *all, int measure)
{
    const size_t best = best_place(all, measure);
    const measured_place *at = &all->place[best];
    const double value = at->found.value[measure];
    peak found = {at->x, value};
    if (!(value > 0))
        return (worst_place){at->x, at->y, NAN};
    if (all->line == 0)
        return (worst_place){at->x, at->y, value};
    const line_of_sight line = {of, at->y, measure};
    const size_t first = best - best % all->line, last = first + all->line - 1;
    int searches = 0;
    for (size_t i = first; i <= last && searches < SEARCHES; i++) {
        const double here = all->place[i].found.value[measure];
        if (!(here >= NEARLY * value) || !is_top(all, first, i, measure))
            continue;
        searches++;
        const peak top =
            peak_between(all->place[i > first ? i - 1 : i].x, all->place[i < last ? i + 1 : i].x,
                         (peak){all->place[i].x, here}, measure_at, &line);
        found = top.value > found.value ? top : found;
    }
    return (worst_place){found.x, at->y, found.value};
}
