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
};

static double radians(double angle)
{
    return angle * PI / 180;
}

/* ---- K ---- */

/* Of an angle, after each load for each length; of loads times lengths numbers each. */
typedef struct {
    double *I, *II, *overlap;
} intensities;

static intensities intensities_of(const crack_plan *plan, double angle)
{
    const size_t all = plan->last->loads * plan->lengths;
    intensities K = {.I = memory_zeroed(3 * all, sizeof *K.I)};
    K.II = K.I + all;
    K.overlap = K.II + all;
    status_check(rwedge_cycle_crack(plan->last->cycle, plan->x, radians(angle), plan->last->loads,
                                    plan->lengths, plan->length, K.I, K.II, K.overlap),
                 "the crack");
    return K;
}

/* ---- Cycles ---- */

crack_growth crack_growth_of(const crack_plan *plan, double angle, int shear, double from,
                             double to)
{
    const crack_law *law = &plan->law;
    const double constants[] = {isnan(law->dK_th) ? 0 : law->dK_th,
                                isnan(law->ds0) ? HUGE_VAL : law->ds0, isnan(law->C) ? 1 : law->C,
                                isnan(law->m) ? 1 : law->m, isnan(law->K_c) ? HUGE_VAL : law->K_c};
    crack_growth g = {0};
    g.status = rwedge_cycle_growth(plan->last->cycle, plan->x, radians(angle), shear, 5, constants,
                                   from, to, &g.end, &g.cycles, &g.least, &g.least_at);
    return g;
}

/* The growth from each length to the next, of each way in which K_II counts. */
typedef struct {
    const crack_plan *plan;
    double angle;
    crack_growth *step; /* of the length i and the shear k at [SHEARS i + k] */
} steps;

static void grow(void *of_steps, int64_t i)
{
    steps *all = of_steps;
    const size_t from = (size_t)i / SHEARS;
    const int shear = (int)(i % SHEARS);
    if (all->plan->is_wanted[shear])
        all->step[i] = crack_growth_of(all->plan, all->angle, shear, all->plan->length[from],
                                       all->plan->length[from + 1]);
}

/* Summed up from the last length backwards: NAN where it stops on the way. */
static double *cycles_of(const crack_plan *plan, double angle)
{
    const size_t n = plan->lengths;
    double *cycles = memory_zeroed(SHEARS * n, sizeof *cycles);
    steps all = {plan, angle, memory_zeroed(SHEARS * n, sizeof *all.step)};
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
           : needs[column] == NEEDS_THRESHOLD ? crack_has_threshold(plan)
           : needs[column] == NEEDS_RATE      ? crack_has_rate(plan)
                                              : true;
}

/* The largest and smallest of a length, and the load of the largest. */
static void find_extremes(const crack_plan *plan, const double K[], size_t j, double *most,
                          double *least, size_t *of_most)
{
    *of_most = 0;
    *most = *least = K[j];
    for (size_t i = 1; i < plan->last->loads; i++) {
        const double here = K[i * plan->lengths + j];
        *of_most = here > *most ? i : *of_most;
        *most = fmax(*most, here);
        *least = fmin(*least, here);
    }
}

static void fill(const crack_plan *plan, const intensities *K, size_t j, int shear,
                 double value[COLUMNS])
{
    size_t largest, other;
    const size_t n = plan->lengths;
    double *of_length = memory_zeroed(2 * plan->last->loads, sizeof *of_length);
    for (size_t i = 0; i < plan->last->loads; i++) {
        of_length[i] = K->I[i * n + j];
        of_length[plan->last->loads + i] = K->II[i * n + j];
    }
    find_extremes(plan, K->II, j, &value[K_II_MAX], &value[K_II_MIN], &other);
    find_extremes(plan, K->I, j, &value[K_I_MAX], &value[K_I_MIN], &largest);
    status_check(rwedge_crack_ranges(plan->last->loads, 1, of_length, of_length + plan->last->loads,
                                     shear, &value[DK_I], &value[DK_II], &value[K_MAX],
                                     &value[RATIO]),
                 "the ranges of K");
    free(of_length);
    value[LENGTH] = plan->length[j];
    value[DK] = hypot(value[DK_I], value[DK_II]);
    value[OVERLAP] = K->overlap[largest * n + j];
    value[THRESHOLD] = crack_threshold(plan, plan->length[j]);
    value[DK_OVER_THRESHOLD] = value[DK] / value[THRESHOLD];
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
    const intensities K = intensities_of(plan, angle);
    double *cycles = crack_has_rate(plan) ? cycles_of(plan, angle) : NULL;
    for (size_t j = 0; j < plan->lengths && records_go_on(rows); j++)
        for (int shear = 0; shear < SHEARS; shear++) {
            double value[COLUMNS] = {angle};
            if (!plan->is_wanted[shear])
                continue;
            fill(plan, &K, j, shear, value);
            value[CYCLES] = cycles != NULL ? cycles[SHEARS * j + (size_t)shear] : NAN;
            write_row(plan, shear, value, rows);
        }
    free(cycles);
    free(K.I);
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
    static const char *const names[] = {"angle", "load", "length", "K_I", "K_II"};
    const crack_plan *plan = of_plan;
    const size_t first = plan->has_angles ? 0 : 1, n = plan->lengths;
    records_header(rows, 5 - first, names + first);
    for (int64_t k = 0; k < plan->angles.count; k++) {
        const double angle = range_value(&plan->angles, k);
        const intensities K = intensities_of(plan, angle);
        for (size_t i = 0; i < plan->last->loads * n && records_go_on(rows); i++) {
            const cell row[] = {cell_number(angle), cell_number((double)(i / n + 1)),
                                cell_number(plan->length[i % n]), cell_number(K.I[i]),
                                cell_number(K.II[i])};
            records_row(rows, 5 - first, row + first);
        }
        free(K.I);
    }
}
