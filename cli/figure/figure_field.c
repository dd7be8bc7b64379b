/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contours of von Mises' stress below the contact. */
#include "figure.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Rows are closer to each other near the surface, where the stress changes most. */
enum { FIELD_COLUMNS = 241, FIELD_ROWS = 97 };
static const double FIELD_HALF_WIDTH = 1.5, FIELD_DEPTH = 1.5, STRIP = -0.16;

static double field_x(int i)
{
    return FIELD_HALF_WIDTH * (2 * i - (FIELD_COLUMNS - 1)) / (FIELD_COLUMNS - 1);
}

static double field_y(int j)
{
    return FIELD_DEPTH * pow((double)j / (FIELD_ROWS - 1), 1.5);
}

static double stick_width(const figure_case *inputs)
{
    if (inputs->value[C_OVER_B].count > 0)
        return case_value(inputs, C_OVER_B);
    return inputs->value[Q_OVER_FP].count > 0
               ? rwedge_stick_width(case_value(inputs, A_OVER_B), case_value(inputs, Q_OVER_FP))
               : 0;
}

static double sqrt_J2(double nu, double sxx, double syy, double txy)
{
    return rwedge_von_mises(sxx, syy, txy, nu) / sqrt(3);
}

static void compute_field(const figure_case *inputs, dataset *rows)
{
    const double alpha = case_value(inputs, A_OVER_B), f = case_value(inputs, FRICTION),
                 nu = case_value(inputs, NU);
    const double c = stick_width(inputs);
    for (int j = 0; j < FIELD_ROWS; j++)
        for (int i = 0; i < FIELD_COLUMNS; i++) {
            const double x = field_x(i), y = field_y(j);
            double sxx, syy, txy;
            const int32_t status = rwedge_stress(alpha, f, c, x, y, &sxx, &syy, &txy);
            if (alpha == 0 && x == 0 && y == 0) /* infinite at the sharp apex */
                sxx = syy = txy = NAN;
            else
                case_check(inputs, status);
            dataset_add(rows,
                        (data_row){.number = {x, y, sxx, syy, txy, sqrt_J2(nu, sxx, syy, txy)}});
        }
}

/* ---- Contours ---- */

/* Rows and columns of the grid without numbers of contours: none stands on the edges of the
 * picture. */
enum { MARGIN = 14, FIRST_ROW = 18 };

/* The number of a level where the way from one place of the grid to the next crosses it, unless
 * another number is next to it, or the same one near. */
static void name_level(const data_row *from, const data_row *to, double step, drawing *plot)
{
    const double a = from->number[5], b = to->number[5];
    const double level = step * ceil(fmin(a, b) / step), part = (level - a) / (b - a);
    char text[NUMBER_SIZE];
    if (!(level <= fmax(a, b)) || !(level > 0) || a == b)
        return;
    const double x = from->number[0] + part * (to->number[0] - from->number[0]),
                 y = from->number[1] + part * (to->number[1] - from->number[1]);
    number_write(level, DRAWING_DIGITS, '.', text);
    for (int i = 0; i < plot->label_count; i++)
        if (fabs(x - plot->label[i].x) < 0.32 &&
            fabs(y - plot->label[i].y) < (strcmp(text, plot->label[i].text) == 0 ? 0.6 : 0.12))
            return;
    label *number = drawing_label(plot, x, y, "%s", text);
    number->align = ALIGN_CENTRE;
    number->boxed = true;
}

/* Downwards from the place nearest to x, and along a row both ways from there. */
static void name_levels(const dataset *rows, double x, double step, drawing *plot)
{
    enum { ROW = FIELD_ROWS - 12 };
    const double nearest = (FIELD_COLUMNS - 1) * (0.5 + 0.5 * x / FIELD_HALF_WIDTH);
    const int column = (int)fmin(fmax(nearest, MARGIN), FIELD_COLUMNS - 1 - MARGIN);
    const data_row *top = &rows->row[column], *row = &rows->row[ROW * FIELD_COLUMNS];
    for (int j = FIRST_ROW; j < ROW; j++)
        name_level(&top[j * FIELD_COLUMNS], &top[(j + 1) * FIELD_COLUMNS], step, plot);
    for (int i = column; i > MARGIN; i--)
        name_level(&row[i], &row[i - 1], step, plot);
    for (int i = column; i < FIELD_COLUMNS - 1 - MARGIN; i++)
        name_level(&row[i], &row[i + 1], step, plot);
}

/* ---- What stands on them ---- */

/* Above the surface: the contact as an empty bar, the stick zone filled. */
static void draw_zones(double c, drawing *plot)
{
    if (c > 0)
        drawing_bar(plot, -c, c, -0.09, -0.03)->style = STYLE_AREA;
    drawing_bar(plot, -1, 1, -0.09, -0.03)->width = 0.8;
}

/* Where it yields first, and sqrt(J2) there; false where the stress is infinite. */
static bool find_yield(const figure_case *inputs, double *x, double *y, double *top)
{
    const double alpha = case_value(inputs, A_OVER_B), f = case_value(inputs, FRICTION),
                 c = stick_width(inputs);
    const double P = rwedge_load(alpha), Q = c > 0 ? f * rwedge_shear_ratio(alpha, c) * P : f * P;
    rwedge_contact *contact = NULL;
    double factor = 0;
    int32_t status = rwedge_contact_create(1, alpha, 1, f, &contact);
    if (status == RWEDGE_OK)
        status = loads_apply_monotonic((load){.P = P, .Q = Q}, contact);
    if (status == RWEDGE_OK)
        status = rwedge_contact_yield_factor(contact, case_value(inputs, NU), 1, &factor, x, y);
    rwedge_contact_destroy(contact);
    if (status == RWEDGE_ENOMEM)
        failure("out of memory");
    *top = factor > 0 ? 1 / factor : 0;
    return status == RWEDGE_OK && factor > 0;
}

static void mark_yield(double x, double y, drawing *plot)
{
    const int number = dataset_curves(&plot->outlines);
    dataset_add(&plot->outlines, (data_row){.curve = number, .number = {x, y}});
    curve *circle = drawing_curve(plot, &plot->outlines, number, 0, 1);
    circle->style = STYLE_CIRCLES;
    circle->colour = VERMILLION;
}

static void draw_surface(drawing *plot)
{
    const int number = dataset_curves(&plot->outlines);
    dataset_add(&plot->outlines, (data_row){.curve = number, .number = {-FIELD_HALF_WIDTH, 0}});
    dataset_add(&plot->outlines, (data_row){.curve = number, .number = {FIELD_HALF_WIDTH, 0}});
    drawing_curve(plot, &plot->outlines, number, 0, 1);
}

/* How far it slips is said as it was asked for. */
static void write_title(const figure_case *inputs, drawing *plot)
{
    char alpha[NUMBER_SIZE], f[NUMBER_SIZE], nu[NUMBER_SIZE], slip[NUMBER_SIZE] = "0";
    const bool by_force = inputs->value[Q_OVER_FP].count > 0;
    const int slips = by_force ? Q_OVER_FP : C_OVER_B;
    if (inputs->value[slips].count > 0)
        case_text(inputs, slips, 0, slip);
    const bool normal = case_value(inputs, FRICTION) == 0;
    snprintf(plot->title, sizeof plot->title,
             "√*J*_2 in θ/*A*: *a*/*b* = %s, *f* = %s,\n%s%s%sν = %s",
             case_text(inputs, A_OVER_B, 0, alpha), case_text(inputs, FRICTION, 0, f),
             normal     ? ""
             : by_force ? "*Q*/(*fP*) = "
                        : "*c*/*b* = ",
             normal ? "" : slip, normal ? "" : ", ", case_text(inputs, NU, 0, nu));
}

static void write_caption(const figure_case *inputs, double step, bool has_yield, double top,
                          drawing *plot)
{
    const char *zones = stick_width(inputs) > 0            ? ", black: stick"
                        : case_value(inputs, FRICTION) > 0 ? ", sliding"
                                                           : "";
    snprintf(plot->caption, sizeof plot->caption, "bar: contact%s; lines: every %.3g", zones, step);
    if (has_yield)
        list_add(plot->caption, sizeof plot->caption, ";\n", "circle: first yield, %.3g", top);
}

static const char *draw_field(const figure_case *inputs, const dataset *rows, drawing *plot)
{
    const double seen = dataset_largest(rows, 5, 1), step = step_of_levels(seen);
    double x = 0, y = 0, top = 0;
    const bool has_yield = find_yield(inputs, &x, &y, &top);
    write_title(inputs, plot);
    write_caption(inputs, step, has_yield, top, plot);
    plot->x = (axis){"*x*/*b*", -FIELD_HALF_WIDTH, FIELD_HALF_WIDTH, 0.5, 0};
    plot->y = (axis){"*y*/*b*", FIELD_DEPTH, STRIP, 0.5, FIELD_DEPTH};
    plot->field = (contours){rows, FIELD_COLUMNS, 0, 1, 5, step, seen};
    name_levels(rows, has_yield ? x : 0, step, plot);
    draw_zones(stick_width(inputs), plot);
    draw_surface(plot);
    if (has_yield)
        mark_yield(x, y, plot);
    return NULL;
}

const figure figure_field = {
    .name = "field",
    .summary = "contours of von Mises stress below the contact",
    .use = {[A_OVER_B] = {"0.5", 1},
            [FRICTION] = {"0.3", 1},
            [NU] = {"0.3", 1},
            [Q_OVER_FP] = {"", 1},
            [C_OVER_B] = {"", 1}},
    .column = (const char *const[]){"x_over_b", "y_over_b", "A_sxx_over_theta", "A_syy_over_theta",
                                    "A_txy_over_theta", "A_sqrt_J2_over_theta", NULL},
    .compute = compute_field,
    .draw = draw_field};
