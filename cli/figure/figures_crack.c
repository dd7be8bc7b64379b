/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The range of K of a crack over its length, beside its threshold. */
#include "figure.h"

#include <math.h>
#include <stdlib.h>

enum { LENGTHS = 81 };

/* From the first length to the last, each longer by the same factor. */
static void take_lengths(const crack_plan *plan, double length[LENGTHS])
{
    const double first = plan->length[0], last = plan->length[plan->lengths - 1];
    for (int i = 0; i < LENGTHS; i++)
        length[i] = first * pow(last / first, (double)i / (LENGTHS - 1));
    length[LENGTHS - 1] = last;
}

static void compute_crack(const figure_case *inputs, dataset *rows)
{
    const crack_plan *plan = &inputs->crack;
    const size_t loads = plan->last->loads, all = loads * LENGTHS;
    double length[LENGTHS], I[LENGTHS], II[LENGTHS], K_max[LENGTHS], R[LENGTHS];
    double dK[SHEARS][LENGTHS], *K = memory_zeroed(3 * all, sizeof *K);
    rows->error = plan->last->error;
    take_lengths(plan, length);
    case_check(inputs, rwedge_cycle_crack(plan->last->cycle, plan->x,
                                          range_value(&plan->angles, 0) * PI / 180, loads, LENGTHS,
                                          length, K, K + all, K + 2 * all));
    for (int shear = 0; shear < SHEARS; shear++) {
        case_check(inputs, rwedge_crack_ranges(loads, LENGTHS, K, K + all, shear, I, II, K_max, R));
        for (int i = 0; i < LENGTHS; i++)
            dK[shear][i] = plan->is_wanted[shear] ? hypot(I[i], II[i]) : NAN;
    }
    for (int i = 0; i < LENGTHS; i++)
        dataset_add(rows, (data_row){.number = {length[i], dK[0][i], dK[1][i], dK[2][i],
                                                crack_threshold(plan, length[i])}});
    free(K);
}

/* Where the crack stops by the first way that lets it start; 0 where none does. */
static double arrest_of(const crack_plan *plan)
{
    const double first = plan->length[0], last = plan->length[plan->lengths - 1];
    for (int shear = 0; shear < SHEARS && crack_has_threshold(plan); shear++) {
        const crack_growth g =
            plan->is_wanted[shear]
                ? crack_growth_of(plan, range_value(&plan->angles, 0), shear, first, last)
                : (crack_growth){.end = first};
        if (g.status == RWEDGE_OK && g.end > first && isfinite(g.end) && isinf(g.cycles))
            return g.end;
    }
    return 0;
}

static void prepare_crack(const figure_case *inputs, const dataset *rows, FILE *script)
{
    (void)rows;
    script_number(script, "arrest", arrest_of(&inputs->crack));
    script_number(script, "has_threshold", crack_has_threshold(&inputs->crack));
}

const figure figure_crack = {
    .name = "crack",
    .summary = "range of K of a crack over its length, and its threshold, last cycle",
    .has_history = true,
    .cycles = 3,
    .column = (const char *const[]){"length", "dK_none", "dK_locked", "dK_free", "threshold", NULL},
    .compute = compute_crack,
    .drawn = 1 << 1 | 1 << 2 | 1 << 3,
    .nothing = "the crack is closed all the time",
    .prepare = prepare_crack,
    .script = crack_lines};
