/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The hysteresis loop of a cycle of Q under constant P: Q over the displacement by slip. Its area
 * is the energy dissipated: the part of the displacement in proportion to Q encloses none. */
#include "figure.h"

#include <math.h>

typedef struct {
    const figure_case *inputs;
    double alpha, amplitude;
    rwedge_contact *contact; /* theta, A, f and b are 1 */
    int number;
    dataset *rows;
} loop_case;

enum { LOOP_STEPS = 100 }; /* as its script has it */

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
    }
}

const figure figure_loop = {
    .name = "loop",
    .summary = "hysteresis loops of a cycle of Q under constant P",
    .use = {[A_OVER_B] = {"0.25", 1}, [Q_OVER_FP] = {"0.5,0.7,0.9", FIGURE_CURVES_MAX}},
    .column = (const char *const[]){"a_over_b", "amplitude_over_fP", "Q_over_fP",
                                    "displacement_over_f_theta_b", "c_over_b",
                                    "A_energy_over_f2_theta2_b2", NULL},
    .text_column = "part",
    .compute = compute_loop,
    .drawn = 1 << 3,
    .nothing = "without an amplitude nothing slips",
    .script = loop_lines};

/* ---- Shear tractions under a bulk tension ---- */

/* ---- The numbers ---- */

/* theta, A, f and b are 1. */
typedef struct {
    const figure_case *inputs;
    rwedge_contact *contact;
    double sigma_over_max, left, right; /* edges of the stick zone, NAN where all slides */
    int number;
    dataset *rows;
} tension_case;

/* The traction at a point; infinite at the apex of the sharp wedge. */
static void add_point(const tension_case *tension, double x)
{
    double p, q = -HUGE_VAL;
    const int32_t status = rwedge_contact_tractions(tension->contact, 1, &x, &p, &q);
    dataset_add(tension->rows, (data_row){.curve = tension->number,
                                          .number = {tension->sigma_over_max, x, -PI * q,
                                                     tension->left, tension->right}});
    if (x != 0 || status != RWEDGE_EDOMAIN)
        case_check(tension->inputs, status);
}

/* Dense at both ends, where the traction is steep; the last point is left out. */
static void add_zone(const tension_case *tension, double from, double to)
{
    enum { STEPS = 100 };
    for (int i = -STEPS; i < STEPS; i++)
        add_point(tension, 0.5 * (from + to) + 0.5 * (to - from) * sin(0.5 * PI * i / STEPS));
}

/* P is applied first, then Q and sigma together. */
static void apply(const tension_case *tension)
{
    load to = {.P = rwedge_load(case_value(tension->inputs, A_OVER_B))};
    to.Q = case_value(tension->inputs, Q_OVER_FP) * to.P;
    case_check(tension->inputs, loads_apply_monotonic((load){.P = to.P}, tension->contact));
    to.sigma =
        tension->sigma_over_max * rwedge_contact_largest_tension_step(tension->contact, to.Q);
    case_check(tension->inputs, loads_apply_monotonic(to, tension->contact));
}

/* The slip zones, and the stick zone where there is one: the edges are kinks. */
static void compute_eccentric(const figure_case *inputs, dataset *rows)
{
    for (int n = 0; n < inputs->value[SIGMA_OVER_MAX].count; n++) {
        tension_case tension = {.inputs = inputs,
                                .sigma_over_max = range_value(&inputs->value[SIGMA_OVER_MAX], n),
                                .left = NAN,
                                .right = NAN,
                                .number = n,
                                .rows = rows};
        case_check(inputs,
                   rwedge_contact_create(1, case_value(inputs, A_OVER_B), 1, 1, &tension.contact));
        apply(&tension);
        rwedge_contact_stick_zone(tension.contact, &tension.left, &tension.right);
        const bool sticks =
            isfinite(tension.left) && tension.left > -1 && tension.right > tension.left;
        add_zone(&tension, -1, sticks ? tension.left : 0);
        if (sticks)
            add_zone(&tension, tension.left, tension.right);
        add_zone(&tension, sticks ? tension.right : 0, 1);
        add_point(&tension, 1);
    }
}

/* ---- The picture ---- */

/* Gives the script the limit of friction, f p. */
static void prepare_eccentric(const figure_case *inputs, const dataset *rows, FILE *script)
{
    enum { STEPS = 200 };
    const double alpha = case_value(inputs, A_OVER_B);
    (void)rows;
    dataset limit = {.column = (const char *const[]){"x", "limit", NULL}};
    for (int i = -STEPS; i <= STEPS; i++) {
        const double x = i == 0 ? 0 : sin(0.5 * PI * i / STEPS);
        dataset_add(&limit, (data_row){.number = {x, -PI * rwedge_pressure(alpha, x)}});
    }
    script_rows(script, "$limit", &limit);
}

const figure figure_eccentric = {
    .name = "eccentric",
    .summary = "shear tractions and stick zones where a bulk tension grows with Q",
    .use = {[A_OVER_B] = {"0.25", 1}, [Q_OVER_FP] = {"0.5", 1}, [SIGMA_OVER_MAX] = {"0,0.5,1", 6}},
    .column = (const char *const[]){"sigma_over_max", "x_over_b", "minus_pi_A_q_over_f_theta",
                                    "stick_left_over_b", "stick_right_over_b", NULL},
    .compute = compute_eccentric,
    .drawn = 1 << 2,
    .nothing = "without Q there is no shear traction",
    .prepare = prepare_eccentric,
    .script = eccentric_lines};
