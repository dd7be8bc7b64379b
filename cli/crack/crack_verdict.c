/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "crack.h"

#include <math.h>
#include <stdlib.h>

const column_kind verdict_columns[] = {
    {"angle", "of the crack, with --angle-range", "degrees"},
    {"shear", "how K_II counts: none, locked, free", NULL},
    {"arrest_length", "where it stops; the first where it does not grow", "length"},
    {"cycles", "passes until it breaks, or to the last length; or empty", NULL},
    {"least_ratio", "smallest dK over the threshold", NULL},
    {"least_length", "the length at which it is", "length"},
    {"verdict", "in words", NULL},
};
enum { COLUMNS = sizeof verdict_columns / sizeof verdict_columns[0] };
const int verdict_column_count = COLUMNS;

/* One sentence of all ways in which K_II counts; of one way its row has it. */
static void say_all(const crack_plan *plan, double angle, const crack_growth growth[SHEARS])
{
    char text[CRACK_SENTENCE];
    if (crack_sentence_of_all(&plan->crack, growth, text) < 2)
        return;
    if (plan->has_angles)
        notice("at %.6g deg: %s.", angle, text);
    else
        notice("%s.", text);
}

/* ---- Rows ---- */

static void grow(void *of_plan, int64_t i)
{
    const crack_plan *plan = of_plan;
    const int shear = (int)(i % SHEARS);
    if (plan->crack.is_wanted[shear])
        plan->growth[i] =
            crack_verdict_of(&plan->crack, range_value(&plan->angles, i / SHEARS), shear);
}

/* Fewer cycles are worse; where it stops, a dK that is closer to the threshold. */
static bool is_worse(const crack_growth *one, const crack_growth *other)
{
    if (isfinite(one->cycles) || isfinite(other->cycles))
        return one->cycles < other->cycles;
    return one->end > other->end || (one->end == other->end && one->least > other->least);
}

static void name_worst(const crack_plan *plan)
{
    int64_t worst = -1;
    char text[CRACK_SENTENCE];
    for (int64_t i = 0; i < SHEARS * plan->angles.count; i++)
        if (plan->crack.is_wanted[i % SHEARS] &&
            (worst < 0 || is_worse(&plan->growth[i], &plan->growth[worst])))
            worst = i;
    crack_sentence(&plan->crack, (int)(worst % SHEARS), &plan->growth[worst], text);
    notice("worst: at %.6g deg: %s", range_value(&plan->angles, worst / SHEARS), text);
}

static void write_row(const crack_plan *plan, double angle, int shear, const crack_growth *g,
                      records *rows)
{
    char text[CRACK_SENTENCE];
    const size_t first = plan->has_angles ? 0 : 1;
    crack_sentence(&plan->crack, shear, g, text);
    const cell row[COLUMNS] = {cell_number(angle),
                               cell_text(shear_names[shear]),
                               cell_number(crack_grows(g) ? NAN : g->end),
                               cell_number(crack_has_rate(&plan->crack.law) ? g->cycles : NAN),
                               cell_number(g->least),
                               cell_number(g->least_at),
                               cell_text(text)};
    records_row(rows, COLUMNS - first, row + first);
}

void crack_verdict_write(void *of_plan, records *rows)
{
    crack_plan *plan = of_plan;
    const size_t count = SHEARS * (size_t)plan->angles.count;
    plan->growth = memory_zeroed(count, sizeof *plan->growth);
    threads_run(plan->threads, (int64_t)count, grow, plan);
    records_columns(rows, verdict_columns + (plan->has_angles ? 0 : 1),
                    COLUMNS - (plan->has_angles ? 0 : 1));
    for (size_t i = 0; i < count; i++)
        if (plan->crack.is_wanted[i % SHEARS]) {
            status_check(plan->growth[i].status, "the growth of the crack");
            write_row(plan, range_value(&plan->angles, (int64_t)(i / SHEARS)), (int)(i % SHEARS),
                      &plan->growth[i], rows);
        }
}

void crack_verdict_say(const crack_plan *plan)
{
    if (plan->growth == NULL)
        return;
    for (int64_t i = 0; i < plan->angles.count; i++)
        say_all(plan, range_value(&plan->angles, i), plan->growth + SHEARS * i);
    if (plan->has_angles)
        name_worst(plan);
}

/* ---- What the model leaves out ---- */

/* Under the largest K_I of a length faces overlap. */
static bool is_shared(const crack_case *crack, const crack_K *K, size_t j)
{
    size_t largest = 0;
    for (size_t i = 1; i < crack->last->loads; i++)
        if (K->I[i * crack->lengths + j] > K->I[largest * crack->lengths + j])
            largest = i;
    return K->share[largest * crack->lengths + j] > 0;
}

static void say_overlap(const crack_case *crack, double angle)
{
    const crack_K K = crack_K_of(crack, angle, false);
    double first = NAN, last = NAN;
    status_check(K.status, "the crack");
    for (size_t j = 0; j < crack->lengths; j++)
        if (is_shared(crack, &K, j)) {
            first = fmin(first, crack->length[j]);
            last = crack->length[j];
        }
    if (!isnan(first))
        notice(
            "at %.6g deg faces overlap under the largest K_I, lengths %.4g to %.4g: that K_I is "
            "too small; the verdict and the columns closing_... let them press, without friction",
            angle, first, last);
    free(K.I);
}

void crack_doubts_say(const crack_plan *plan)
{
    char text[CRACK_SENTENCE];
    for (int64_t i = 0; i < plan->angles.count; i++)
        say_overlap(&plan->crack, range_value(&plan->angles, i));
    crack_length_said(&plan->crack, text);
    notice("%s", text);
}
