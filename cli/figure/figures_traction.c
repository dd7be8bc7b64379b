/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Figs. 2, 6 and 7: pressure, maximum tension, shear tractions. */
#include "figures_traction.h"

#include <math.h>
#include <stdio.h>

#include <rwedge.h>

static const double PI = 3.14159265358979323846;

/* x = sin t in equal steps of t: dense at the edges, where the tractions fall to 0 with a
 * vertical tangent. */
enum { TRACTION_STEPS = 200 };
static double traction_x(int i)
{
    return i == 0 ? 0 : sin(0.5 * PI * i / TRACTION_STEPS);
}

/* ---- Fig. 2 ---- */

static int32_t compute_pressure(const figure_case *of, dataset *rows)
{
    for (int n = 0; n < of->value[A_OVER_B].count; n++) {
        const double alpha = range_value(&of->value[A_OVER_B], n);
        for (int i = -TRACTION_STEPS; i <= TRACTION_STEPS; i++) {
            const double x = i < 0 ? -traction_x(-i) : traction_x(i);
            dataset_add(rows, (data_row){.curve = n,
                                         .number = {alpha, x, -PI * rwedge_pressure(alpha, x)}});
        }
    }
    return RWEDGE_OK;
}

/* Where the curves lie farthest apart, next to the axis; left and right in turn, as they are
 * closer than a text is high. A steep peak has its label beside it. */
static void label_pressure(double alpha, int n, drawing *on)
{
    char text[NUMBER_SIZE];
    const bool beside = alpha < 0.15;
    const double x = n % 2 == 0 ? 0.13 : -0.13,
                 y = -PI * rwedge_pressure(alpha, beside && alpha > 0 ? 0 : x);
    drawing_number(alpha, text);
    label *one = drawing_label(on,
                               !beside      ? x
                               : alpha == 0 ? 0.06
                                            : -0.07,
                               alpha == 0 ? 0.96 * on->y.to : y, "%s", text);
    one->align = !beside ? ALIGN_CENTRE : alpha == 0 ? ALIGN_LEFT : ALIGN_RIGHT;
    one->boxed = !beside;
    one->colour = on->curve[n].colour;
}

/* Of the finite peaks; the sharp wedge's is cut. */
static double top_of_pressures(const figure_case *of)
{
    enum { SHARP = 10 };
    double top = 0;
    for (int n = 0; n < of->value[A_OVER_B].count; n++) {
        const double alpha = range_value(&of->value[A_OVER_B], n);
        top = fmax(top, alpha == 0 ? SHARP : ceil(PI * rwedge_peak_pressure(alpha)));
    }
    return top;
}

static void draw_pressure(const figure_case *of, const dataset *rows, drawing *on)
{
    const double top = top_of_pressures(of);
    snprintf(on->title, sizeof on->title, "Contact pressure, by *a*/*b*");
    on->x = (axis){"*x*/*b*", -1, 1, 0.5, 0};
    on->y = (axis){"−*pA*π/θ", 0, top, top > 5 ? 2 : top > 2 ? 1 : 0.5, 0};
    on->height = 0.9;
    for (int n = 0; n < dataset_curves(rows); n++) {
        style_of_family(drawing_curve(on, rows, n, 1, 2), n);
        label_pressure(range_value(&of->value[A_OVER_B], n), n, on);
    }
}

static const char *const pressure_columns[] = {"a_over_b", "x_over_b", "minus_pi_A_p_over_theta",
                                               NULL};

const figure figure_pressure = {.name = "2",
                                .summary = "contact pressure over x/b",
                                .use = {[A_OVER_B] = {"0:1:0.1", FIGURE_CURVES_MAX}},
                                .column = pressure_columns,
                                .compute = compute_pressure,
                                .draw = draw_pressure};

/* ---- Fig. 6 ---- */

static int32_t compute_tension(const figure_case *of, dataset *rows)
{
    enum { STEPS = 200 };
    (void)of;
    for (int i = 0; i <= STEPS; i++) {
        const double alpha = (double)i / STEPS;
        dataset_add(rows, (data_row){.number = {alpha, rwedge_max_tension(alpha)}});
    }
    return RWEDGE_OK;
}

static void draw_tension(const figure_case *of, const dataset *rows, drawing *on)
{
    (void)of;
    snprintf(on->title, sizeof on->title, "Maximum tension in full sliding");
    on->x = (axis){"*a*/*b*", 0, 1, 0.2, 0};
    on->y = (axis){"*b*σ_1/(*fP*)", 0.95, 1.3, 0.05, 0};
    on->height = 0.75;
    drawing_curve(on, rows, 0, 0, 1)->width = 1.5;
    drawing_label(on, 0.03, 1.046, "1, sharp wedge");
    drawing_label(on, 0.965, 4 / PI, "4/π, Hertz")->align = ALIGN_RIGHT;
}

static const char *const tension_columns[] = {"a_over_b", "b_sigma_over_fP", NULL};

const figure figure_tension = {.name = "6",
                               .summary = "maximum tension at the trailing edge over a/b",
                               .column = tension_columns,
                               .compute = compute_tension,
                               .draw = draw_tension};

/* ---- Fig. 7 ---- */

/* The edges of the stick zone are points of their own: the traction has a kink there. */
static void add_shear(const figure_case *of, double c, int n, dataset *rows)
{
    const double alpha = case_value(of, A_OVER_B);
    double edge = -c;
    for (int i = -TRACTION_STEPS; i <= TRACTION_STEPS; i++) {
        const double x = i < 0 ? -traction_x(-i) : traction_x(i);
        for (; edge <= c && edge < x && c > 0; edge += 2 * c)
            dataset_add(rows, (data_row){.curve = n,
                                         .number = {c, edge, -PI * rwedge_shear(alpha, c, edge)}});
        dataset_add(rows,
                    (data_row){.curve = n, .number = {c, x, -PI * rwedge_shear(alpha, c, x)}});
        if (edge == x)
            edge += 2 * c;
    }
}

static int32_t compute_shear(const figure_case *of, dataset *rows)
{
    for (int n = 0; n < of->value[C_OVER_B].count; n++)
        add_shear(of, range_value(&of->value[C_OVER_B], n), n, rows);
    return RWEDGE_OK;
}

/* Each below its curve, at the axis; above where there is no room, aside where the last one is. */
static void label_shear(const figure_case *of, int n, const label *last, drawing *on)
{
    char text[NUMBER_SIZE];
    const double c = range_value(&of->value[C_OVER_B], n),
                 q = -PI * rwedge_shear(case_value(of, A_OVER_B), c, 0);
    const double lift = 0.045 * on->y.to, y = c > 0 && q > 2 * lift ? q - lift : q + lift;
    drawing_number(c, text);
    label *one =
        drawing_label(on, 0, isfinite(y) ? y : 0.95 * on->y.to,
                      c > 0 ? "*c*/*b* = %s" : "*c*/*b* = %s, and the pressure −*pA*π/θ", text);
    one->align = ALIGN_CENTRE;
    one->boxed = c > 0;
    one->colour = on->curve[n].colour;
    if (last != NULL && fabs(one->y - last->y) < 1.5 * lift)
        one->x = last->x < 0 ? 0 : -0.45;
}

static double top_of(const dataset *rows, int column)
{
    double top = 0;
    for (size_t i = 0; i < rows->count; i++)
        if (rows->row[i].number[column] > top)
            top = rows->row[i].number[column];
    return top;
}

static void draw_shear(const figure_case *of, const dataset *rows, drawing *on)
{
    char text[NUMBER_SIZE];
    drawing_number(case_value(of, A_OVER_B), text);
    snprintf(on->title, sizeof on->title, "Shear traction in partial slip, *a*/*b* = %s", text);
    const double top = top_of(rows, 2);
    on->x = (axis){"*x*/*b*", -1, 1, 0.5, 0};
    on->y = (axis){"−*qA*π/(*f*θ)", 0, top > 0 ? 1.1 * top : 1, top > 4 ? 2 : top > 2 ? 1 : 0.5, 0};
    on->y.to = ceil(2 * on->y.to / on->y.tic) * 0.5 * on->y.tic;
    on->height = 0.85;
    for (int n = 0; n < dataset_curves(rows); n++) {
        curve *one = drawing_curve(on, rows, n, 1, 2);
        style_of_family(one, n);
        one->width = 1.4;
        label_shear(of, n, n > 0 ? &on->label[n - 1] : NULL, on);
    }
}

static const char *const shear_columns[] = {"c_over_b", "x_over_b", "minus_pi_A_q_over_f_theta",
                                            NULL};

const figure figure_shear = {
    .name = "7",
    .summary = "shear tractions in partial slip over x/b",
    .use = {[A_OVER_B] = {"0.25", 1}, [C_OVER_B] = {"0,0.16666666666666666,0.5", 6}},
    .column = shear_columns,
    .compute = compute_shear,
    .draw = draw_shear};
