/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The hysteresis loop of a cycle of Q under constant P: Q over the displacement by slip. Its area
 * is the energy dissipated: the part of the displacement in proportion to Q encloses none. */
#include "figure.h"

#include <math.h>
#include <stdio.h>

typedef struct {
    const figure_case *inputs;
    double alpha, amplitude;
    rwedge_contact *contact; /* theta, A, f and b are 1 */
    int number;
    dataset *rows;
} loop_case;

enum { LOOP_STEPS = 100 };

/* Adds the loop from one turning point, or the origin, to the next. */
static void add_part(const loop_case *loop, double from, double to, const char *part)
{
    const double normal = rwedge_load(loop->alpha);
    for (int i = 0; i <= LOOP_STEPS; i++) {
        const double Q = from + (to - from) * sin(0.5 * PI * i / LOOP_STEPS);
        case_check(loop->inputs, rwedge_contact_load(loop->contact, normal, Q * normal));
        dataset_add(loop->rows,
                    (data_row){.curve = loop->number,
                               .text = part,
                               .number = {loop->alpha, loop->amplitude, Q,
                                          rwedge_contact_displacement(loop->contact, 1),
                                          rwedge_contact_stick_half_width(loop->contact),
                                          rwedge_contact_dissipated_energy(loop->contact)}});
    }
}

static void compute_loop(const figure_case *inputs, dataset *rows)
{
    const double alpha = case_value(inputs, A_OVER_B);
    for (int n = 0; n < inputs->value[Q_OVER_FP].count; n++) {
        const double amplitude = range_value(&inputs->value[Q_OVER_FP], n);
        loop_case loop = {inputs, alpha, amplitude, NULL, n, rows};
        case_check(inputs, rwedge_contact_create(1, alpha, 1, 1, &loop.contact));
        add_part(&loop, 0, amplitude, "first loading");
        add_part(&loop, amplitude, -amplitude, "unloading");
        add_part(&loop, -amplitude, amplitude, "reloading");
        rwedge_contact_destroy(loop.contact);
    }
}

/* Dissipated from the first turn to the end: a whole cycle. */
static double energy_of_cycle(const curve *line)
{
    const data_row *first = &line->from->row[line->first];
    return first[line->count - 1].number[5] - first[LOOP_STEPS].number[5];
}

static const char *draw_loop(const figure_case *inputs, const dataset *rows, drawing *on)
{
    char text[NUMBER_SIZE];
    double reach = 0;
    case_text(inputs, A_OVER_B, 0, text);
    snprintf(on->title, sizeof on->title, "Cycles of *Q* under constant *P*, *a*/*b* = %s", text);
    for (size_t i = 0; i < rows->count; i++)
        reach = fmax(reach, rows->row[i].number[3]);
    if (reach == 0)
        return "without an amplitude nothing slips";
    on->x = (axis){"displacement by slip / (*f*θ*b*)", -1.05 * reach, 1.05 * reach,
                   drawing_tic(2.1 * reach), 0};
    on->y = (axis){"*Q*/(*fP*)", -1.1, 1.1, 0.5, 0};
    on->height = 0.85;
    snprintf(on->caption, sizeof on->caption, "amplitude: *W*, energy per cycle in (*f*θ*b*)²/*A*");
    for (int n = 0; n < inputs->value[Q_OVER_FP].count; n++) {
        curve *line = drawing_curve(on, rows, n, 3, 2);
        style_of_family(line, n);
        line->width = 1.3;
        case_text(inputs, Q_OVER_FP, n, text);
        snprintf(line->legend, sizeof line->legend, "%s: *W* = %#.3g", text, energy_of_cycle(line));
    }
    return NULL;
}

static const char *const loop_columns[] = {
    "a_over_b", "amplitude_over_fP",          "Q_over_fP", "displacement_over_f_theta_b",
    "c_over_b", "A_energy_over_f2_theta2_b2", NULL};

const figure figure_loop = {
    .name = "loop",
    .summary = "hysteresis loops of a cycle of Q under constant P",
    .use = {[A_OVER_B] = {"0.25", 1}, [Q_OVER_FP] = {"0.5,0.7,0.9", FIGURE_CURVES_MAX}},
    .column = loop_columns,
    .text_column = "part",
    .compute = compute_loop,
    .draw = draw_loop};
