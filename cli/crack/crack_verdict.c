/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "crack.h"

#include <math.h>
#include <stdlib.h>

const column_kind verdict_columns[] = {
    {"angle", "of the crack, with --angle-range", "degrees"},
    {"shear", "how K_II counts: none, locked, free", NULL},
    {"arrest_length", "where it stops; the first where it does not grow", "length"},
    {"cycles", "to the last length, or until it breaks; empty where it stops", NULL},
    {"least_ratio", "smallest dK over the threshold", NULL},
    {"least_length", "the length at which it is", "length"},
    {"verdict", "in words", NULL},
};
enum { COLUMNS = sizeof verdict_columns / sizeof verdict_columns[0] };
const int verdict_column_count = COLUMNS;

/* ---- In words ---- */

static const char *const assumption[SHEARS] = {"By mode I the crack",
                                               "With K_II while it is open the crack",
                                               "With K_II of free faces the crack"};

/* A sentence on the growth between two lengths; of a law without C no cycles. */
static void write_sentence(const crack_plan *plan, int shear, const crack_growth *g, char *text,
                           size_t size)
{
    const double first = plan->length[0], last = plan->length[plan->lengths - 1];
    text[0] = '\0';
    list_add(text, size, "", "%s ", assumption[shear]);
    if (isinf(g->cycles) && g->end == first) {
        list_add(text, size, "", "does not grow: dK is %.3g of the threshold at %.4g", g->first,
                 first);
    } else if (isinf(g->cycles) && isfinite(g->end)) {
        list_add(text, size, "", "stops at %.4g", g->end);
    } else {
        list_add(text, size, "",
                 isfinite(g->end) ? "breaks at %.4g, where K is K_c" : "grows through to %.4g",
                 isfinite(g->end) ? g->end : last);
        if (crack_has_rate(plan))
            list_add(text, size, "", ", in %.6g cycles", g->cycles);
        if (crack_has_threshold(plan) && isfinite(g->least))
            list_add(text, size, "", "; closest to the threshold, %.3g, at %.4g", g->least,
                     g->least_at);
    }
}

/* ---- Rows ---- */

/* Growth at all angles and shears, [SHEARS i + k]. */
typedef struct {
    const crack_plan *plan;
    crack_growth *growth;
} growths;

static void grow(void *of_growths, int64_t i)
{
    growths *all = of_growths;
    const crack_plan *plan = all->plan;
    const int shear = (int)(i % SHEARS);
    const double angle = range_value(&plan->angles, i / SHEARS), first = plan->length[0];
    if (!plan->is_wanted[shear])
        return;
    all->growth[i] = crack_growth_of(plan, angle, shear, first, plan->length[plan->lengths - 1]);
    all->growth[i].first = crack_growth_of(plan, angle, shear, first, first * (1 + 1e-9)).least;
}

/* Fewer cycles are worse; where it stops, a dK that is closer to the threshold. */
static bool is_worse(const crack_growth *one, const crack_growth *other)
{
    if (isfinite(one->cycles) || isfinite(other->cycles))
        return one->cycles < other->cycles;
    return one->end > other->end || (one->end == other->end && one->least > other->least);
}

static void name_worst(const growths *all)
{
    int64_t worst = -1;
    char text[300];
    for (int64_t i = 0; i < SHEARS * all->plan->angles.count; i++)
        if (all->plan->is_wanted[i % SHEARS] &&
            (worst < 0 || is_worse(&all->growth[i], &all->growth[worst])))
            worst = i;
    write_sentence(all->plan, (int)(worst % SHEARS), &all->growth[worst], text, sizeof text);
    notice("worst: at %.6g deg: %s", range_value(&all->plan->angles, worst / SHEARS), text);
}

static void write_row(const crack_plan *plan, double angle, int shear, const crack_growth *g,
                      records *rows)
{
    char text[300];
    const bool stops = isinf(g->cycles) && isfinite(g->end);
    const size_t first = plan->has_angles ? 0 : 1;
    write_sentence(plan, shear, g, text, sizeof text);
    const cell row[COLUMNS] = {cell_number(angle),
                               cell_text(shear_names[shear]),
                               cell_number(stops ? g->end : NAN),
                               cell_number(crack_has_rate(plan) ? g->cycles : NAN),
                               cell_number(g->least),
                               cell_number(g->least_at),
                               cell_text(text)};
    records_row(rows, COLUMNS - first, row + first);
}

void crack_verdict_write(void *of_plan, records *rows)
{
    const crack_plan *plan = of_plan;
    const size_t count = SHEARS * (size_t)plan->angles.count;
    growths all = {plan, memory_zeroed(count, sizeof *all.growth)};
    threads_run(plan->threads, (int64_t)count, grow, &all);
    records_columns(rows, verdict_columns + (plan->has_angles ? 0 : 1),
                    COLUMNS - (plan->has_angles ? 0 : 1));
    for (size_t i = 0; i < count; i++)
        if (plan->is_wanted[i % SHEARS]) {
            status_check(all.growth[i].status, "the growth of the crack");
            write_row(plan, range_value(&plan->angles, (int64_t)(i / SHEARS)), (int)(i % SHEARS),
                      &all.growth[i], rows);
        }
    if (plan->has_angles)
        name_worst(&all);
    free(all.growth);
}

/* ---- What the model leaves out ---- */

/* The largest K_I of a length has its faces overlapping. */
static bool overlaps(const crack_plan *plan, const double K_I[], const double overlap[], size_t j)
{
    size_t largest = 0;
    for (size_t i = 1; i < plan->last->loads; i++)
        if (K_I[i * plan->lengths + j] > K_I[largest * plan->lengths + j])
            largest = i;
    return overlap[largest * plan->lengths + j] > 0;
}

static void say_overlap(const crack_plan *plan, double angle)
{
    const size_t all = plan->last->loads * plan->lengths;
    double *K = memory_zeroed(3 * all, sizeof *K), first = NAN, last = NAN;
    status_check(rwedge_cycle_crack(plan->last->cycle, plan->x, angle * PI / 180, plan->last->loads,
                                    plan->lengths, plan->length, K, K + all, K + 2 * all),
                 "the crack");
    for (size_t j = 0; j < plan->lengths; j++)
        if (overlaps(plan, K, K + 2 * all, j)) {
            first = fmin(first, plan->length[j]);
            last = plan->length[j];
        }
    if (!isnan(first))
        notice("at %.6g deg faces overlap under the largest K_I, lengths %.4g to %.4g: that K_I is "
               "too small",
               angle, first, last);
    free(K);
}

void crack_doubts_say(const crack_plan *plan)
{
    const double tenth = (plan->last->right - plan->last->left) / 20;
    for (int64_t i = 0; i < plan->angles.count; i++)
        say_overlap(plan, range_value(&plan->angles, i));
    if (plan->length[plan->lengths - 1] > tenth)
        notice(
            "the contact is taken as if there were no crack: beyond a length of %.4g, a tenth of "
            "its half-width, K is some per cent off",
            tenth);
}
