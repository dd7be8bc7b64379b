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

static const char *const assumption[SHEARS] = {"mode I", "K_II while it is open",
                                               "K_II of free faces"};

static bool grows(const crack_growth *g)
{
    return !(isinf(g->cycles) && isfinite(g->end));
}

/* Adds what becomes of it between two lengths; of a law without C no cycles. */
static void add_end(const crack_plan *plan, const crack_growth *g, char *text, size_t size)
{
    const double first = plan->length[0], last = plan->length[plan->lengths - 1];
    if (!grows(g) && g->end == first)
        list_add(text, size, "", "does not grow: dK is %.3g of the threshold at %.4g %s", g->first,
                 first, plan->unit);
    else if (!grows(g))
        list_add(text, size, "", "arrests at %.4g %s", g->end, plan->unit);
    else if (isfinite(g->end))
        list_add(text, size, "", "breaks at %.4g %s, where K is K_c", g->end, plan->unit);
    else
        list_add(text, size, "", "grows through to %.4g %s", last, plan->unit);
    if (grows(g) && crack_has_rate(plan))
        list_add(text, size, "", ", in %.6g cycles", g->cycles);
}

static void write_sentence(const crack_plan *plan, int shear, const crack_growth *g, char *text,
                           size_t size)
{
    text[0] = '\0';
    list_add(text, size, "",
             shear == RWEDGE_FACES_MODE_I ? "By %s the crack " : "With %s the crack ",
             assumption[shear]);
    add_end(plan, g, text, size);
    if (grows(g) && crack_has_threshold(plan) && isfinite(g->least))
        list_add(text, size, "", "; closest to the threshold, %.3g, at %.4g %s", g->least,
                 g->least_at, plan->unit);
}

/* One sentence of all ways in which K_II counts. */
static void say_all(const crack_plan *plan, double angle, const crack_growth growth[SHEARS])
{
    char text[600] = "";
    int ways = 0;
    for (int shear = 0; shear < SHEARS; shear++) {
        if (!plan->is_wanted[shear])
            continue;
        list_add(text, sizeof text, "; ", "%s %s %s ",
                 shear == RWEDGE_FACES_MODE_I ? "By"
                 : ways == 0                  ? "With"
                                              : "with",
                 assumption[shear], ways == 0 ? "the crack" : "it");
        add_end(plan, &growth[shear], text, sizeof text);
        ways++;
    }
    if (ways < 2)
        return; /* the row says it */
    if (plan->has_angles)
        notice("at %.6g deg: %s.", angle, text);
    else
        notice("%s.", text);
}

/* ---- Rows ---- */

/* dK over the threshold at the first length. */
static double ratio_at_first(const crack_plan *plan, double angle, int shear)
{
    crack_plan of_first = *plan;
    of_first.lengths = 1;
    for (int k = 0; k < SHEARS; k++)
        of_first.is_wanted[k] = k == shear;
    const crack_ranges r = crack_ranges_of(&of_first, angle, NULL);
    const double dK = hypot(r.I[shear], r.II[shear]);
    free(r.I);
    return dK / crack_threshold(plan, plan->length[0]);
}

static void grow(void *of_plan, int64_t i)
{
    const crack_plan *plan = of_plan;
    const int shear = (int)(i % SHEARS);
    const double angle = range_value(&plan->angles, i / SHEARS), first = plan->length[0];
    if (!plan->is_wanted[shear])
        return;
    plan->growth[i] =
        crack_growth_of(plan, angle, true, shear, first, plan->length[plan->lengths - 1]);
    plan->growth[i].first = ratio_at_first(plan, angle, shear);
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
    char text[300];
    for (int64_t i = 0; i < SHEARS * plan->angles.count; i++)
        if (plan->is_wanted[i % SHEARS] &&
            (worst < 0 || is_worse(&plan->growth[i], &plan->growth[worst])))
            worst = i;
    write_sentence(plan, (int)(worst % SHEARS), &plan->growth[worst], text, sizeof text);
    notice("worst: at %.6g deg: %s", range_value(&plan->angles, worst / SHEARS), text);
}

static void write_row(const crack_plan *plan, double angle, int shear, const crack_growth *g,
                      records *rows)
{
    char text[300];
    const size_t first = plan->has_angles ? 0 : 1;
    write_sentence(plan, shear, g, text, sizeof text);
    const cell row[COLUMNS] = {cell_number(angle),
                               cell_text(shear_names[shear]),
                               cell_number(grows(g) ? NAN : g->end),
                               cell_number(crack_has_rate(plan) ? g->cycles : NAN),
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
        if (plan->is_wanted[i % SHEARS]) {
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

/* Under the largest K_I of a length faces overlap, or touch. */
static bool is_shared(const crack_plan *plan, const crack_K *K, size_t j)
{
    size_t largest = 0;
    for (size_t i = 1; i < plan->last->loads; i++)
        if (K->I[i * plan->lengths + j] > K->I[largest * plan->lengths + j])
            largest = i;
    return K->share[largest * plan->lengths + j] > 0;
}

static void say_overlap(const crack_plan *plan, double angle)
{
    const crack_K K = crack_K_of(plan, angle, false);
    double first = NAN, last = NAN;
    for (size_t j = 0; j < plan->lengths; j++)
        if (is_shared(plan, &K, j)) {
            first = fmin(first, plan->length[j]);
            last = plan->length[j];
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
    const double tenth = (plan->last->right - plan->last->left) / 20;
    for (int64_t i = 0; i < plan->angles.count; i++)
        say_overlap(plan, range_value(&plan->angles, i));
    if (plan->length[plan->lengths - 1] > tenth)
        notice(
            "the contact is taken as if there were no crack: beyond a length of %.4g, a tenth of "
            "its half-width, K is some per cent off",
            tenth);
}
