/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Figs. 2, 6 and 7: pressure, maximum tension, shear tractions. */
#include "figure.h"

#include <math.h>

/* x = sin t in equal steps of t: dense at the edges, where the tractions fall to 0 with a
 * vertical tangent. Below the first step there are eight places a decade, so many as the smallest
 * rounding or stick zone of the figure needs. They go on within it: the pressure of a sharp wedge
 * is drawn as high as that of any rounded one. */
enum { TRACTION_STEPS = 200, FINE_PER_DECADE = 8, FINE_MAX = 20 * FINE_PER_DECADE };

static double coarse_x(int i)
{
    return sin(0.5 * PI * i / TRACTION_STEPS);
}

static double smallest(const range *values, double least)
{
    for (int64_t i = 0; i < values->count; i++)
        if (range_value(values, i) > 0)
            least = fmin(least, range_value(values, i));
    return least;
}

static int fine_places(const figure_case *inputs)
{
    static const double WITHIN = 8;
    enum { FARTHER = 2 * FINE_PER_DECADE };
    const double scale = smallest(&inputs->value[A_OVER_B], smallest(&inputs->value[C_OVER_B], 1));
    const double wanted = ceil(FINE_PER_DECADE * log10(WITHIN * coarse_x(1) / scale));
    return wanted > 0 ? (int)fmin(wanted + FARTHER, FINE_MAX) : 0;
}

/* The place i, -fine - TRACTION_STEPS <= i <= fine + TRACTION_STEPS. */
static double traction_x(int i, int fine)
{
    if (i <= 0)
        return i < 0 ? -traction_x(-i, fine) : 0;
    return i <= fine ? coarse_x(1) * pow(10, (double)(i - fine - 1) / FINE_PER_DECADE)
                     : coarse_x(i - fine);
}

/* ---- Fig. 2 ---- */

static void compute_pressure(const figure_case *inputs, dataset *rows)
{
    const int fine = fine_places(inputs), last = fine + TRACTION_STEPS;
    for (int n = 0; n < inputs->value[A_OVER_B].count; n++) {
        const double alpha = range_value(&inputs->value[A_OVER_B], n);
        for (int i = -last; i <= last; i++) {
            const double x = traction_x(i, fine);
            dataset_add(rows, (data_row){.curve = n,
                                         .number = {alpha, x, -PI * rwedge_pressure(alpha, x)}});
        }
    }
}

const figure figure_pressure = {
    .name = "2",
    .summary = "contact pressure over x/b",
    .use = {[A_OVER_B] = {"0:1:0.1", FIGURE_CURVES_MAX}},
    .column = (const char *const[]){"a_over_b", "x_over_b", "minus_pi_A_p_over_theta", NULL},
    .compute = compute_pressure,
    .script = pressure_lines};

/* ---- Fig. 6 ---- */

static void compute_tension(const figure_case *inputs, dataset *rows)
{
    enum { STEPS = 200 };
    (void)inputs;
    for (int i = 0; i <= STEPS; i++) {
        const double alpha = (double)i / STEPS;
        dataset_add(rows, (data_row){.number = {alpha, rwedge_max_tension(alpha)}});
    }
}

const figure figure_tension = {.name = "6",
                               .summary = "maximum tension at the trailing edge over a/b",
                               .column = (const char *const[]){"a_over_b", "b_sigma_over_fP", NULL},
                               .compute = compute_tension,
                               .script = tension_lines};

/* ---- Fig. 7 ---- */

/* The edges of the stick zone are points of their own: the traction has a kink there. */
static void compute_shear(const figure_case *inputs, dataset *rows)
{
    const double alpha = case_value(inputs, A_OVER_B);
    const int fine = fine_places(inputs), last = fine + TRACTION_STEPS;
    for (int n = 0; n < inputs->value[C_OVER_B].count; n++) {
        const double c = range_value(&inputs->value[C_OVER_B], n);
        double edge = -c;
        for (int i = -last; i <= last; i++) {
            const double x = traction_x(i, fine);
            for (; edge <= c && edge < x && c > 0; edge += 2 * c)
                dataset_add(rows,
                            (data_row){.curve = n,
                                       .number = {c, edge, -PI * rwedge_shear(alpha, c, edge)}});
            dataset_add(rows,
                        (data_row){.curve = n, .number = {c, x, -PI * rwedge_shear(alpha, c, x)}});
            if (edge == x)
                edge += 2 * c;
        }
    }
}

const figure figure_shear = {
    .name = "7",
    .summary = "shear tractions in partial slip over x/b",
    .use =
        {[A_OVER_B] = {"0.25", 1}, [C_OVER_B] = {"0,0.16666666666666666,0.5", FIGURE_CURVES_MAX}},
    .column = (const char *const[]){"c_over_b", "x_over_b", "minus_pi_A_q_over_f_theta", NULL},
    .compute = compute_shear,
    .drawn = 1 << 2,
    .nothing = "without slip there is no shear traction",
    .script = shear_lines};
