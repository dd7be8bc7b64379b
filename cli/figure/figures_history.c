/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "figure.h"

#include "fretting/fretting.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Along the loads ---- */

enum { STEPS = 24 }; /* from load to load, for smooth curves */

/* Adds what is to be seen of a state; the number of the load counts on in between. */
typedef void visitor(const figure_case *inputs, double number, const rwedge_contact *contact,
                     dataset *rows);

static double part_of(double from, double to, int i)
{
    return i == STEPS ? to : from + (to - from) * i / STEPS;
}

/* The states before a load. Where one has no closed form, the curve is straight from there. */
static void visit_between(const figure_case *inputs, size_t step, rwedge_contact *contact,
                          visitor *visit, dataset *rows)
{
    rwedge_contact *trial = NULL;
    load from, to = contact_history_load(inputs->history, step);
    rwedge_contact_loads(contact, &from.P, &from.M, &from.Q, &from.sigma);
    case_check(inputs, rwedge_contact_copy(contact, &trial));
    for (int i = 1; i < STEPS && from.P > 0; i++) {
        if (rwedge_contact_apply(trial, part_of(from.P, to.P, i), part_of(from.M, to.M, i),
                                 part_of(from.Q, to.Q, i),
                                 part_of(from.sigma, to.sigma, i)) != RWEDGE_OK)
            break;
        visit(inputs, (double)step + (double)i / STEPS, trial, rows);
    }
    rwedge_contact_destroy(trial);
}

/* Of the loads from the first on. Those before the first cycle have no number and no place. */
static void visit_all(const figure_case *inputs, size_t first, visitor *visit, dataset *rows)
{
    rwedge_contact *contact = contact_history_begin(inputs->history);
    for (size_t step = 0; step < inputs->history->steps; step++) {
        if (step > first)
            visit_between(inputs, step, contact, visit, rows);
        contact_history_go_on(inputs->history, step, contact);
        if (step >= first)
            visit(inputs, (double)step + 1, contact, rows);
    }
    rwedge_contact_destroy(contact);
}

/* Along x the numbers of the tics stand side by side: long ones get two or three. */
static double tic_along_x(double span)
{
    char text[NUMBER_SIZE];
    const double tic = drawing_tic(span), decade = pow(10, floor(log10(span / 2)));
    if (number_write(tic, DRAWING_DIGITS, '.', text) <= 4)
        return tic;
    return decade * (span / 2 < 2 * decade ? 1 : span / 2 < 5 * decade ? 2 : 5);
}

/* With a minus sign, not a hyphen. */
static void write_number(double value, int digits, char text[NUMBER_SIZE])
{
    char size[NUMBER_SIZE];
    drawing_number(fabs(value), digits, size);
    snprintf(text, NUMBER_SIZE, "%s%.20s", value < 0 ? "−" : "", size);
}

/* An axis from the least number to the largest, with 0 in it, and with room at the ends. */
static axis axis_over(const dataset *rows, int column, const char *text)
{
    const double lo = -dataset_largest(rows, column, -1), hi = dataset_largest(rows, column, 1);
    const double margin = 0.05 * (hi - lo);
    axis over = {.from = lo - margin, .to = hi + margin, .tic = drawing_tic(hi - lo)};
    snprintf(over.text, sizeof over.text, "%s", text);
    return over;
}

/* ---- The stress at a point ---- */

enum { H_LOAD, H_X, H_Y, H_SXX, H_SYY, H_SZZ, H_TXY };

static void add_stress(const figure_case *inputs, double number, const rwedge_contact *contact,
                       dataset *rows)
{
    const double x = inputs->at->x[0], y = inputs->at->y[0];
    double sxx, syy, txy;
    case_check(inputs, rwedge_contact_stresses(contact, 1, &x, &y, &sxx, &syy, &txy));
    const tensor at = tensor_of(sxx, syy, txy, inputs->history->setup.nu1);
    dataset_add(rows, (data_row){.number = {number, x, y, sxx, syy, at.value[TENSOR_SZZ], txy}});
}

/* The last cycle, from the load before it. */
static void compute_history(const figure_case *inputs, dataset *rows)
{
    const size_t loads = inputs->history->loads.count, steps = inputs->history->steps;
    visit_all(inputs, steps > loads ? steps - loads - 1 : 0, add_stress, rows);
}

static const char *draw_history(const figure_case *inputs, const dataset *rows, drawing *plot)
{
    static const char *const names[] = {"*σ*_x", "*σ*_y", "*τ*_x_y"};
    static const int columns[] = {H_SXX, H_SYY, H_TXY};
    char x[NUMBER_SIZE], y[NUMBER_SIZE];
    double top = 0, bottom = 0;
    for (int i = 0; i < 3; i++) {
        top = fmax(top, dataset_largest(rows, columns[i], 1));
        bottom = fmax(bottom, dataset_largest(rows, columns[i], -1));
    }
    if (top == 0 && bottom == 0)
        return "there is no stress";
    write_number(inputs->at->x[0], DRAWING_DIGITS, x);
    write_number(inputs->at->y[0], DRAWING_DIGITS, y);
    snprintf(plot->title, sizeof plot->title, "Stresses at *x* = %s, *y* = %s", x, y);
    const double first = rows->row[0].number[H_LOAD],
                 last = rows->row[rows->count - 1].number[H_LOAD], margin = 0.05 * (top + bottom);
    plot->x = (axis){"load", first, last > first ? last : first + 1, 1, 0};
    if (last - first > 10)
        plot->x.tic = fmax(1, drawing_tic(last - first));
    plot->y = (axis){"stress", -bottom - margin, top + margin, drawing_tic(top + bottom), 0};
    plot->height = 0.75;
    for (int i = 0; i < 3; i++) {
        curve *line = drawing_curve(plot, rows, 0, H_LOAD, columns[i]);
        style_of_family(line, i);
        line->width = 1.3;
        snprintf(line->legend, sizeof line->legend, "%s", names[i]);
    }
    return NULL;
}

const figure figure_history = {
    .name = "history",
    .summary = "stresses at a point, --at, in the last cycle of loads",
    .has_history = true,
    .needs_point = true,
    .cycles = 1,
    .column = (const char *const[]){"load", "x", "y", "sxx", "syy", "szz", "txy", NULL},
    .compute = compute_history,
    .draw = draw_history};

/* ---- The loop of Q over the displacement ---- */

enum { L_LOAD, L_P, L_M, L_Q, L_SIGMA, L_DISPLACEMENT, L_ENERGY };

static void add_displacement(const figure_case *inputs, double number,
                             const rwedge_contact *contact, dataset *rows)
{
    load now;
    rwedge_contact_loads(contact, &now.P, &now.M, &now.Q, &now.sigma);
    dataset_add(rows,
                (data_row){.number = {number, now.P, now.M, now.Q, now.sigma,
                                      rwedge_contact_displacement(contact, inputs->half_width),
                                      rwedge_contact_dissipated_energy(contact)}});
}

static void compute_any_loop(const figure_case *inputs, dataset *rows)
{
    visit_all(inputs, 0, add_displacement, rows);
}

static const char *draw_any_loop(const figure_case *inputs, const dataset *rows, drawing *plot)
{
    (void)inputs;
    if (dataset_largest(rows, L_DISPLACEMENT, 1) == 0 &&
        dataset_largest(rows, L_DISPLACEMENT, -1) == 0)
        return "nothing slips, or the slip has no closed form";
    snprintf(plot->title, sizeof plot->title, "*Q* through the history of loads");
    plot->x = axis_over(rows, L_DISPLACEMENT, "displacement by slip");
    plot->x.tic = tic_along_x(plot->x.to - plot->x.from);
    plot->y = axis_over(rows, L_Q, "*Q*");
    plot->height = 0.85;
    drawing_curve(plot, rows, 0, L_DISPLACEMENT, L_Q)->width = 1.2;
    return NULL;
}

const figure figure_any_loop = {
    .name = "loop",
    .summary = "Q over the displacement by slip",
    .has_history = true,
    .cycles = 1,
    .column = (const char *const[]){"load", "P", "M", "Q", "sigma", "displacement", "energy", NULL},
    .compute = compute_any_loop,
    .draw = draw_any_loop};

/* ---- Smith, Watson and Topper's parameter along the surface ---- */

enum { F_X, F_SWT, F_ANGLE, F_SLIP, F_F1, F_F2, F_ENERGY };

/* Measures the cycle at the places by default. */
static void measure_usual(const figure_case *inputs, const last_cycle *last, measured *result)
{
    case_check(inputs,
               surface_usual(last, result) ? surface_measure(last, result) : RWEDGE_EABSENT);
}

static void compute_fretting(const figure_case *inputs, dataset *rows)
{
    last_cycle last;
    measured result;
    const criteria usual = criteria_usual(&inputs->history->setup);
    history_cycle(inputs->history, &usual, &last, NULL);
    measure_usual(inputs, &last, &result);
    for (size_t i = 0; i < result.count; i++) {
        const double *v = result.place[i].at.value;
        dataset_add(rows,
                    (data_row){.number = {result.place[i].x, v[MEASURE_SWT], v[MEASURE_SWT_ANGLE],
                                          v[MEASURE_SLIP_RANGE], v[MEASURE_RUIZ_F1],
                                          v[MEASURE_RUIZ_F2], v[MEASURE_ENERGY_PER_AREA]}});
    }
}

/* The contact is where there is slip to speak of. */
static void draw_contact(const dataset *rows, double height, drawing *plot)
{
    double left = NAN, right = NAN;
    for (size_t i = 0; i < rows->count; i++)
        if (!isnan(rows->row[i].number[F_SLIP])) {
            left = fmin(left, rows->row[i].number[F_X]);
            right = fmax(right, rows->row[i].number[F_X]);
        }
    if (left < right)
        drawing_bar(plot, left, right, 0, -height)->width = 0.8;
}

static const char *draw_fretting(const figure_case *inputs, const dataset *rows, drawing *plot)
{
    (void)inputs;
    size_t best = 0;
    char x[NUMBER_SIZE];
    for (size_t i = 0; i < rows->count; i++)
        if (rows->row[i].number[F_SWT] > rows->row[best].number[F_SWT])
            best = i;
    const double *worst = rows->row[best].number, from = rows->row[0].number[F_X],
                 to = rows->row[rows->count - 1].number[F_X];
    if (!(worst[F_SWT] > 0))
        return "there is no tension in the cycle";
    snprintf(plot->title, sizeof plot->title, "Smith–Watson–Topper along the surface");
    write_number(worst[F_X], 4, x);
    snprintf(plot->caption, sizeof plot->caption, "bar: contact; worst: %.4g at *x* = %s",
             worst[F_SWT], x);
    plot->x = (axis){"*x*", from, to, tic_along_x(to - from), 0};
    plot->y = drawing_axis(1.05 * worst[F_SWT], "SWT parameter");
    plot->y.from = -0.06 * worst[F_SWT];
    plot->height = 0.75;
    drawing_curve(plot, rows, 0, F_X, F_SWT)->width = 1.3;
    draw_contact(rows, 0.03 * worst[F_SWT], plot);
    return NULL;
}

const figure figure_fretting = {.name = "fretting",
                                .summary = "Smith-Watson-Topper along the surface, last cycle",
                                .has_history = true,
                                .cycles = 3,
                                .column = (const char *const[]){"x", "swt", "swt_angle",
                                                                "slip_range", "ruiz_f1", "ruiz_f2",
                                                                "energy_per_area", NULL},
                                .compute = compute_fretting,
                                .draw = draw_fretting};

/* ---- Any measure: along the surface, below its worst place, as contours ---- */

enum { DEPTHS = 121, COLUMNS = 81, ROWS = 41 };

static void measure_place(const figure_case *inputs, const last_cycle *last, double x, double y,
                          dataset *rows)
{
    measures at;
    case_check(inputs, last_cycle_measure(last, 1, &x, &y, &at));
    dataset_add(rows, (data_row){.number = {x, y, at.value[inputs->measure]}});
}

static void measure_surface(const figure_case *inputs, const last_cycle *last, dataset *rows)
{
    measured result;
    measure_usual(inputs, last, &result);
    for (size_t i = 0; i < result.count; i++)
        dataset_add(rows, (data_row){.number = {result.place[i].x, 0,
                                                result.place[i].at.value[inputs->measure]}});
    free(result.place);
}

static const data_row *worst_row_of(const dataset *rows)
{
    const data_row *best = rows->row;
    for (size_t i = 0; i < rows->count; i++)
        if (!(best->number[2] >= rows->row[i].number[2]) && !isnan(rows->row[i].number[2]))
            best = &rows->row[i];
    return best;
}

/* Down to the half-width, dense at the surface. */
static void measure_depth(const figure_case *inputs, const last_cycle *last, dataset *rows)
{
    dataset along = {0};
    measure_surface(inputs, last, &along);
    const double x = worst_row_of(&along)->number[0];
    free(along.row);
    for (int i = 0; i < DEPTHS; i++) {
        const double part = (double)i / (DEPTHS - 1);
        measure_place(inputs, last, x, inputs->half_width * part * part, rows);
    }
}

static void measure_field(const figure_case *inputs, const last_cycle *last, dataset *rows)
{
    const double middle = (last->left + last->right) / 2, half = (last->right - last->left) / 2;
    for (int j = 0; j < ROWS; j++)
        for (int i = 0; i < COLUMNS; i++)
            measure_place(inputs, last, middle + 1.5 * half * (2.0 * i / (COLUMNS - 1) - 1),
                          half * pow((double)j / (ROWS - 1), 1.5), rows);
}

static void compute_measure(const figure_case *inputs, dataset *rows)
{
    static void (*const ways[OVER_COUNT])(const figure_case *, const last_cycle *, dataset *) = {
        measure_surface, measure_depth, measure_field};
    last_cycle last;
    history_cycle(inputs->history, inputs->asked, &last, NULL);
    case_check(inputs, isnan(last.left) ? RWEDGE_EABSENT : RWEDGE_OK);
    ways[inputs->over](inputs, &last, rows);
}

static void draw_measure_field(const dataset *rows, double top, drawing *plot)
{
    const double *first = rows->row[0].number, *last = rows->row[rows->count - 1].number;
    const double step = step_of_levels(top), width = last[0] - first[0];
    plot->x = (axis){"*x*", first[0], last[0], tic_along_x(width), 0};
    plot->y = (axis){"*y*", last[1], 0, tic_along_x(last[1]), 0};
    plot->field = (contours){rows, COLUMNS, 0, 1, 2, step, top};
    list_add(plot->caption, sizeof plot->caption, ";\n", "lines: every %.3g", step);
}

static void write_unit(const char *unit, char text[DRAWING_TEXT])
{
    const bool has_unit = strcmp(unit, "none") != 0;
    snprintf(text, DRAWING_TEXT, "%s%s", has_unit ? "in units of " : "pure number",
             has_unit ? unit : "");
    char *star = strchr(text, '*'); /* would begin italics */
    if (star != NULL)
        *star = ' ';
}

static void draw_measure_curve(const figure_case *inputs, const dataset *rows, double top,
                               drawing *plot)
{
    const int along = inputs->over == OVER_DEPTH ? 1 : 0;
    const double from = rows->row[0].number[along], to = rows->row[rows->count - 1].number[along];
    plot->x = (axis){"", from, to, tic_along_x(to - from), 0};
    snprintf(plot->x.text, sizeof plot->x.text, "%s", along == 1 ? "*y*" : "*x*");
    plot->y = drawing_axis(1.05 * top, "");
    write_unit(measure_kinds[inputs->measure].unit, plot->y.text);
    plot->y.from = -1.05 * dataset_largest(rows, 2, -1);
    plot->height = 0.75;
    drawing_curve(plot, rows, 0, along, 2)->width = 1.3;
}

static const char *draw_measure(const figure_case *inputs, const dataset *rows, drawing *plot)
{
    const double *worst = worst_row_of(rows)->number;
    char x[NUMBER_SIZE], y[NUMBER_SIZE];
    if (!(worst[2] > 0))
        return "the measure is nowhere above 0";
    write_number(worst[0], 4, x);
    write_number(worst[1], 4, y);
    snprintf(plot->title, sizeof plot->title, "%s", measure_kinds[inputs->measure].title);
    snprintf(plot->caption, sizeof plot->caption, "%s: %.4g at%s*x* = %s, *y* = %s",
             inputs->over == OVER_FIELD ? "largest of the grid" : "worst", worst[2],
             inputs->over == OVER_FIELD ? "\n" : " ", x, y);
    if (inputs->over == OVER_FIELD)
        draw_measure_field(rows, worst[2], plot);
    else
        draw_measure_curve(inputs, rows, worst[2], plot);
    return NULL;
}

const figure figure_measure = {.name = "measure",
                               .summary = "any column of fretting, by --measure and --over",
                               .has_history = true,
                               .cycles = 3,
                               .column = (const char *const[]){"x", "y", "value", NULL},
                               .compute = compute_measure,
                               .draw = draw_measure};
