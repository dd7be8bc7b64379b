/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cycle.h"

#include <math.h>

double measured_part(const measured_place *at, int criterion, measure_part part)
{
    const int column = measure_column(criterion, part);
    return column >= 0 ? at->value[column] : NAN;
}

/* ---- The places ---- */

/* The best of the places or, on its line, a place between them. Damage is not smooth: the best of
 * the places stands. */
static int32_t find(const last_cycle *cycle, const measured *result, int column, worst_row *row)
{
    const measure_kind *kind = measure_kind_of(column);
    const size_t best = measured_best(result, column);
    const measured_place *place = &result->place[best];
    const bool is_worst = place->value[column] > 0 && kind->part == PART_VALUE &&
                          column_is_wanted(&cycle->asked, column);
    *row = (worst_row){place->x, place->y, is_worst ? place->value[column] : NAN,
                       kind->is_damage ? measured_part(place, kind->criterion, PART_CYCLES) : NAN};
    if (result->line == 0 || !is_worst || kind->is_damage)
        return RWEDGE_OK;
    return last_cycle_worst(cycle, column, result->line, place - best % result->line, &row->x,
                            &row->value);
}

int32_t worst_places(const last_cycle *cycle, const measured *result, worst_row row[COLUMN_MAX])
{
    int32_t status = RWEDGE_OK;
    for (int i = 0; i < measure_count() && status == RWEDGE_OK; i++) {
        const measure_kind *kind = measure_kind_of(i);
        if (kind->part != PART_MULTIPLE) {
            status = find(cycle, result, i, &row[i]);
            continue;
        }
        row[i] = row[measure_column_of(kind->number, false, PART_VALUE)];
        row[i].value *= kind->times(&cycle->asked);
    }
    return status;
}

/* ---- A criterion ---- */

criterion_verdict criterion_verdict_at(const criteria *asked, const measured_place *at,
                                       int criterion)
{
    const int damage = measure_damage(criterion);
    const double value = measured_part(at, criterion, PART_VALUE),
                 allowable = material_allowable(&asked->given, criterion);
    return (criterion_verdict){
        value, allowable, value > 0 ? allowable / value : NAN,
        criterion_is_damage(damage) ? 1 / measured_part(at, damage, PART_VALUE) : NAN};
}
