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

/* As the verdict has it: faces press. */
static void compute_crack(const figure_case *inputs, dataset *rows)
{
    crack_plan plan = inputs->crack;
    double length[LENGTHS], dK[SHEARS];
    take_lengths(&inputs->crack, length);
    plan.length = length;
    plan.lengths = LENGTHS;
    const crack_ranges r = crack_ranges_of(&plan, range_value(&plan.angles, 0), NULL);
    for (int i = 0; i < LENGTHS; i++) {
        for (int shear = 0; shear < SHEARS; shear++) {
            const int at = shear * LENGTHS + i;
            dK[shear] = plan.is_wanted[shear] ? hypot(r.I[at], r.II[at]) : NAN;
        }
        dataset_add(rows, (data_row){.number = {length[i], dK[0], dK[1], dK[2],
                                                crack_threshold(&plan, length[i])}});
    }
    free(r.I);
}

/* Where the crack stops by the first way that lets it start; 0 where none does. */
static double arrest_of(const crack_plan *plan)
{
    const double first = plan->length[0], last = plan->length[plan->lengths - 1];
    for (int shear = 0; shear < SHEARS && crack_has_threshold(plan); shear++) {
        const crack_growth g =
            plan->is_wanted[shear]
                ? crack_growth_of(plan, range_value(&plan->angles, 0), true, shear, first, last)
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
