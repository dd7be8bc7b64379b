/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "crack.h"

#include <math.h>
#include <stdlib.h>

enum {
    ANGLE,
    LENGTH,
    SHEAR,
    K_I_MAX,
    K_I_MIN,
    K_II_MAX,
    K_II_MIN,
    DK_I,
    DK_II,
    DK,
    K_MAX,
    RATIO,
    OVERLAP,
    THRESHOLD,
    DK_OVER_THRESHOLD,
    CYCLES,
    CLOSING, /* the columns from K_I_MAX to RATIO again, of faces that press */
    CLOSED = CLOSING + RATIO - K_I_MAX + 1,
    CLOSING_OVER_THRESHOLD,
    CLOSING_CYCLES,
    COLUMNS
};

const column_kind crack_columns[] = {
    [ANGLE] = {"angle", "of the crack, with --angle-range", "degrees"},
    [LENGTH] = {"length", "of the crack", "length"},
    [SHEAR] = {"shear", "how K_II counts: none, locked, free", NULL},
    [K_I_MAX] = {"K_I_max", "largest K_I after a load", "stress length^(1/2)"},
    [K_I_MIN] = {"K_I_min", "smallest K_I; below 0 it is formal", "stress length^(1/2)"},
    [K_II_MAX] = {"K_II_max", "largest K_II", "stress length^(1/2)"},
    [K_II_MIN] = {"K_II_min", "smallest K_II", "stress length^(1/2)"},
    [DK_I] = {"dK_I", "range of K_I above 0", "stress length^(1/2)"},
    [DK_II] = {"dK_II", "range of K_II, as shear says", "stress length^(1/2)"},
    [DK] = {"dK", "root of the sum of their squares", "stress length^(1/2)"},
    [K_MAX] = {"K_max", "largest root of K_I^2 + K_II^2 while open", "stress length^(1/2)"},
    [RATIO] = {"R", "K_I_min over K_I_max; 0 where K_I is never above 0", NULL},
    [OVERLAP] = {"overlap", "share of the line where faces overlap at K_I_max", NULL},
    [THRESHOLD] = {"threshold", "of dK, with --dK-th", "stress length^(1/2)"},
    [DK_OVER_THRESHOLD] = {"dK_over_threshold", "above 1 it grows", NULL},
    [CYCLES] = {"cycles", "to the last length, with --C and --m; empty where it stops", NULL},
    {"closing_K_I_max", "from here on faces press, without friction", "stress length^(1/2)"},
    {"closing_K_I_min", "never below 0", "stress length^(1/2)"},
    {"closing_K_II_max", "as above", "stress length^(1/2)"},
    {"closing_K_II_min", "as above", "stress length^(1/2)"},
    {"closing_dK_I", "as above", "stress length^(1/2)"},
    {"closing_dK_II", "as above", "stress length^(1/2)"},
    {"closing_dK", "as above", "stress length^(1/2)"},
    {"closing_K_max", "as above", "stress length^(1/2)"},
    {"closing_R", "as above", NULL},
    [CLOSED] = {"closed", "share of the line where faces touch at closing_K_I_max", NULL},
    [CLOSING_OVER_THRESHOLD] = {"closing_dK_over_threshold", "above 1 it grows", NULL},
    [CLOSING_CYCLES] = {"closing_cycles", "to the last length, as above", NULL},
};
const int crack_column_count = COLUMNS;

/* What a column needs to be there. */
static const enum {
    NEEDS_NOTHING,
    NEEDS_ANGLES,
    NEEDS_THRESHOLD,
    NEEDS_RATE
} needs[COLUMNS] = {
    [ANGLE] = NEEDS_ANGLES,
    [THRESHOLD] = NEEDS_THRESHOLD,
    [DK_OVER_THRESHOLD] = NEEDS_THRESHOLD,
    [CYCLES] = NEEDS_RATE,
    [CLOSING_OVER_THRESHOLD] = NEEDS_THRESHOLD,
    [CLOSING_CYCLES] = NEEDS_RATE,
};

static crack_K K_of(const crack_plan *plan, double angle, bool presses)
{
    const crack_K K = crack_K_of(&plan->crack, angle, presses);
    status_check(K.status, "the crack");
    return K;
}

/* ---- Cycles ---- */

/* The growth from each length to the next, of each way in which K_II counts. */
typedef struct {
    const crack_plan *plan;
    double angle;
    bool presses;
    crack_growth *step; /* of the length i and the shear k at [SHEARS i + k] */
} steps;

static void grow(void *of_steps, int64_t i)
{
    steps *all = of_steps;
    const size_t from = (size_t)i / SHEARS;
    const int shear = (int)(i % SHEARS);
    if (all->plan->crack.is_wanted[shear])
        all->step[i] =
            crack_growth_of(&all->plan->crack, all->angle, all->presses, shear,
                            all->plan->crack.length[from], all->plan->crack.length[from + 1]);
}

/* Summed up from the last length backwards: NAN where it stops on the way. */
static double *cycles_of(const crack_plan *plan, double angle, bool presses)
{
    const size_t n = plan->crack.lengths;
    double *cycles = memory_zeroed(SHEARS * n, sizeof *cycles);
    steps all = {plan, angle, presses, memory_zeroed(SHEARS * n, sizeof *all.step)};
    threads_run(plan->threads, (int64_t)(SHEARS * (n - 1)), grow, &all);
    for (size_t i = SHEARS * (n - 1); i-- > 0;) {
        const crack_growth *step = &all.step[i];
        status_check(step->status, "the growth of the crack");
        const double rest = isinf(step->end) ? cycles[i + SHEARS] : 0; /* else it breaks there */
        cycles[i] = isinf(step->cycles) ? NAN : step->cycles + rest;
    }
    free(all.step);
    return cycles;
}

/* ---- Rows ---- */

static bool is_written(const crack_plan *plan, int column)
{
    return needs[column] == NEEDS_ANGLES      ? plan->has_angles
           : needs[column] == NEEDS_THRESHOLD ? crack_has_threshold(&plan->crack.law)
           : needs[column] == NEEDS_RATE      ? crack_has_rate(&plan->crack.law)
                                              : true;
}

/* The largest and smallest of a length, and the load of the largest. */
static void find_extremes(const crack_plan *plan, const double K[], size_t j, double *most,
                          double *least, size_t *of_most)
{
    *of_most = 0;
    *most = *least = K[j];
    for (size_t i = 1; i < plan->crack.last->loads; i++) {
        const double here = K[i * plan->crack.lengths + j];
        *of_most = here > *most ? i : *of_most;
        *most = fmax(*most, here);
        *least = fmin(*least, here);
    }
}

/* Results of faces that pass through each other, and of faces that press. */
enum { WAYS = 2 };
typedef struct {
    crack_K K[WAYS];
    crack_ranges ranges[WAYS];
    double *cycles[WAYS];
} crack_results;

static crack_results results_of(const crack_plan *plan, double angle)
{
    crack_results all = {.cycles = {NULL}};
    for (int way = 0; way < WAYS; way++) {
        all.K[way] = K_of(plan, angle, way == 1);
        all.ranges[way] = crack_ranges_of(&plan->crack, angle, way == 1 ? NULL : &all.K[way]);
        status_check(all.ranges[way].status, "the ranges of K");
        if (crack_has_rate(&plan->crack.law))
            all.cycles[way] = cycles_of(plan, angle, way == 1);
    }
    return all;
}

static void free_results(crack_results *all)
{
    for (int way = 0; way < WAYS; way++) {
        free(all->K[way].I);
        free(all->ranges[way].I);
        free(all->cycles[way]);
    }
}

/* The columns from K_I_max to R, and the share of the line at the largest K_I. */
static void fill(const crack_plan *plan, const crack_K *K, const crack_ranges *ranges, size_t j,
                 int shear, double from_K_I_max[], double *share)
{
    size_t largest, other;
    const size_t at = (size_t)shear * plan->crack.lengths + j;
    double value[COLUMNS];
    find_extremes(plan, K->II, j, &value[K_II_MAX], &value[K_II_MIN], &other);
    find_extremes(plan, K->I, j, &value[K_I_MAX], &value[K_I_MIN], &largest);
    value[DK_I] = ranges->I[at];
    value[DK_II] = ranges->II[at];
    value[DK] = hypot(value[DK_I], value[DK_II]);
    value[K_MAX] = ranges->K_max[at];
    value[RATIO] = ranges->R[at];
    for (int k = K_I_MAX; k <= RATIO; k++)
        from_K_I_max[k - K_I_MAX] = value[k];
    *share = K->share[largest * plan->crack.lengths + j];
}

static void fill_row(const crack_plan *plan, const crack_results *all, size_t j, int shear,
                     double value[COLUMNS])
{
    const size_t at = SHEARS * j + (size_t)shear;
    value[LENGTH] = plan->crack.length[j];
    value[THRESHOLD] = crack_threshold(&plan->crack.law, plan->crack.length[j]);
    fill(plan, &all->K[0], &all->ranges[0], j, shear, &value[K_I_MAX], &value[OVERLAP]);
    fill(plan, &all->K[1], &all->ranges[1], j, shear, &value[CLOSING], &value[CLOSED]);
    value[DK_OVER_THRESHOLD] = value[DK] / value[THRESHOLD];
    value[CLOSING_OVER_THRESHOLD] = value[CLOSING + DK - K_I_MAX] / value[THRESHOLD];
    value[CYCLES] = crack_has_rate(&plan->crack.law) ? all->cycles[0][at] : NAN;
    value[CLOSING_CYCLES] = crack_has_rate(&plan->crack.law) ? all->cycles[1][at] : NAN;
}

static void write_row(const crack_plan *plan, int shear, const double value[COLUMNS], records *rows)
{
    for (int k = 0; k < COLUMNS; k++)
        if (is_written(plan, k))
            records_value(rows, k == SHEAR ? cell_text(shear_names[shear]) : cell_number(value[k]));
    records_end_row(rows);
}

static void write_angle(const crack_plan *plan, double angle, records *rows)
{
    crack_results all = results_of(plan, angle);
    for (size_t j = 0; j < plan->crack.lengths && records_go_on(rows); j++)
        for (int shear = 0; shear < SHEARS; shear++) {
            double value[COLUMNS] = {angle};
            if (!plan->crack.is_wanted[shear])
                continue;
            fill_row(plan, &all, j, shear, value);
            write_row(plan, shear, value, rows);
        }
    free_results(&all);
}

void crack_rows_write(void *of_plan, records *rows)
{
    const crack_plan *plan = of_plan;
    records_describe(rows, crack_columns, COLUMNS);
    for (int k = 0; k < COLUMNS; k++)
        if (is_written(plan, k))
            records_name(rows, crack_columns[k].name);
    records_end_header(rows);
    for (int64_t i = 0; i < plan->angles.count && records_go_on(rows); i++)
        write_angle(plan, range_value(&plan->angles, i), rows);
}

void crack_loads_write(void *of_plan, records *rows)
{
    static const char *const names[] = {"angle",       "load",         "length",  "K_I",   "K_II",
                                        "closing_K_I", "closing_K_II", "overlap", "closed"};
    enum { CELLS = sizeof names / sizeof names[0] };
    const crack_plan *plan = of_plan;
    const size_t first = plan->has_angles ? 0 : 1, n = plan->crack.lengths;
    records_header(rows, CELLS - first, names + first);
    for (int64_t k = 0; k < plan->angles.count; k++) {
        const double angle = range_value(&plan->angles, k);
        const crack_K K = K_of(plan, angle, false), closing = K_of(plan, angle, true);
        for (size_t i = 0; i < plan->crack.last->loads * n && records_go_on(rows); i++) {
            const double value[CELLS] = {angle,
                                         (double)(i / n + 1),
                                         plan->crack.length[i % n],
                                         K.I[i],
                                         K.II[i],
                                         closing.I[i],
                                         closing.II[i],
                                         K.share[i],
                                         closing.share[i]};
            cell row[CELLS];
            for (int c = 0; c < CELLS; c++)
                row[c] = cell_number(value[c]);
            records_row(rows, CELLS - first, row + first);
        }
        free(K.I);
        free(closing.I);
    }
}
