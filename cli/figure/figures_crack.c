/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The range of K of a crack over its length, beside its threshold. */
#include "figure.h"

#include <math.h>
#include <stdlib.h>

enum { LENGTHS = 81 };

/* Faces press, as the verdict has it. */
static void compute_crack(const figure_case *inputs, dataset *rows)
{
    crack_case crack = inputs->crack.crack;
    double length[LENGTHS], dK[SHEARS];
    crack_lengths(crack.length[0], crack.length[crack.lengths - 1], LENGTHS, length);
    crack.length = length;
    crack.lengths = LENGTHS;
    const crack_ranges r = crack_ranges_of(&crack, range_value(&inputs->crack.angles, 0), NULL);
    status_check(r.status, "the ranges of K");
    for (int i = 0; i < LENGTHS; i++) {
        for (int shear = 0; shear < SHEARS; shear++) {
            const int at = shear * LENGTHS + i;
            dK[shear] = crack.is_wanted[shear] ? hypot(r.I[at], r.II[at]) : NAN;
        }
        dataset_add(rows, (data_row){.number = {length[i], dK[0], dK[1], dK[2],
                                                crack_threshold(&crack.law, length[i])}});
    }
    free(r.I);
}

/* Where the crack stops by the first way that lets it start; 0 where none does. */
static double arrest_of(const crack_case *crack, double angle)
{
    const double first = crack->length[0], last = crack->length[crack->lengths - 1];
    for (int shear = 0; shear < SHEARS && crack_has_threshold(&crack->law); shear++) {
        const crack_growth g = crack->is_wanted[shear]
                                   ? crack_growth_of(crack, angle, true, shear, first, last)
                                   : (crack_growth){.end = first};
        if (g.status == RWEDGE_OK && g.end > first && !crack_grows(&g))
            return g.end;
    }
    return 0;
}

static void prepare_crack(const figure_case *inputs, const dataset *rows, FILE *script)
{
    (void)rows;
    script_number(script, "arrest",
                  arrest_of(&inputs->crack.crack, range_value(&inputs->crack.angles, 0)));
    script_number(script, "has_threshold", crack_has_threshold(&inputs->crack.crack.law));
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
