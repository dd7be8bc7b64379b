/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The end of wear: the pressure before and after, and what is worn off. */
#include "figure.h"

#include "fretting/fretting.h"

#include <math.h>

enum { STUCK_STEPS = 160, WORN_STEPS = 60 };

/* Dense at both ends. */
static double between(double left, double right, int i, int n)
{
    return left / 2 + right / 2 - (right / 2 - left / 2) * cos(PI * i / n);
}

static void add_place(const full_wear *wear, double x, dataset *rows)
{
    double before = NAN, q, depth = 0, after = NAN;
    if (rwedge_contact_tractions(wear->before, 1, &x, &before, &q) != RWEDGE_OK)
        before = NAN;
    if (rwedge_contact_full_wear(wear->before, wear->Q_a, 1, &x, &depth, &after) != RWEDGE_OK)
        after = NAN; /* at an edge, where it is infinite and nothing is worn */
    dataset_add(rows, (data_row){.number = {x, depth, before, after}});
}

static void compute_wear(const figure_case *inputs, dataset *rows)
{
    last_cycle last;
    full_wear wear;
    const criteria usual = criteria_usual(&inputs->history.setup);
    history_cycle(&inputs->history, &usual, &last, NULL);
    rows->error = last.error;
    full_wear_find(&last, &wear);
    for (int i = 0; i < WORN_STEPS; i++)
        add_place(&wear, between(wear.worn_left, wear.left, i, WORN_STEPS), rows);
    for (int i = 0; i < STUCK_STEPS; i++)
        add_place(&wear, between(wear.left, wear.right, i, STUCK_STEPS), rows);
    for (int i = 0; i <= WORN_STEPS; i++)
        add_place(&wear, between(wear.right, wear.worn_right, i, WORN_STEPS), rows);
}

const figure figure_wear = {
    .name = "wear",
    .summary = "where wear ends: pressure before and after, depth; of a cycle of Q",
    .has_history = true,
    .cycles = 3,
    .column = (const char *const[]){"x", "worn_depth", "p_before", "p_after", NULL},
    .compute = compute_wear,
    .drawn = 1 << 1,
    .nothing = "nothing is worn",
    .script = wear_lines};
