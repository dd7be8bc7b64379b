/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/loads.h"
#include "figure_eccentric.h"
#include "number/pi.h"

#include <math.h>
#include <stdio.h>

#include <rwedge.h>

/* Of the rows. */
enum { SIGMA, X, SHEAR, STICK_LEFT, STICK_RIGHT };

/* ---- The numbers ---- */

/* theta, A, f and b are 1. */
typedef struct {
    const rwedge_contact *contact;
    double sigma_over_max, left, right; /* edges of the stick zone, NAN where all slides */
    int number;
    dataset *rows;
} tension_case;

/* The traction at a point; infinite at the apex of the sharp wedge. */
static int32_t add_point(const tension_case *tension, double x)
{
    double p, q = -HUGE_VAL;
    const int32_t status = rwedge_contact_tractions(tension->contact, 1, &x, &p, &q);
    dataset_add(tension->rows, (data_row){.curve = tension->number,
                                          .number = {tension->sigma_over_max, x, -PI * q,
                                                     tension->left, tension->right}});
    return x == 0 && status == RWEDGE_EDOMAIN ? RWEDGE_OK : status;
}

/* Dense at both ends, where the traction is steep; the last point is left out. */
static int32_t add_zone(const tension_case *tension, double from, double to)
{
    enum { STEPS = 100 };
    int32_t status = RWEDGE_OK;
    for (int i = -STEPS; i < STEPS && status == RWEDGE_OK; i++)
        status =
            add_point(tension, 0.5 * (from + to) + 0.5 * (to - from) * sin(0.5 * PI * i / STEPS));
    return status;
}

/* The slip zones, and the stick zone where there is one: the edges are kinks. */
static int32_t add_points(const tension_case *tension)
{
    const bool sticks =
        isfinite(tension->left) && tension->left > -1 && tension->right > tension->left;
    int32_t status = add_zone(tension, -1, sticks ? tension->left : 0);
    if (status == RWEDGE_OK && sticks)
        status = add_zone(tension, tension->left, tension->right);
    if (status == RWEDGE_OK)
        status = add_zone(tension, sticks ? tension->right : 0, 1);
    return status == RWEDGE_OK ? add_point(tension, 1) : status;
}

/* Under constant P, Q and sigma together. */
static int32_t apply(double alpha, double Q_over_fP, double sigma_over_max, rwedge_contact *contact)
{
    load to = {.P = rwedge_load(alpha)};
    to.Q = Q_over_fP * to.P;
    const int32_t status = loads_apply_monotonic((load){.P = to.P}, contact);
    if (status != RWEDGE_OK)
        return status;
    to.sigma = sigma_over_max * rwedge_contact_largest_tension_step(contact, to.Q);
    return loads_apply_monotonic(to, contact);
}

static int32_t add_curve(const figure_case *inputs, int number, dataset *rows)
{
    rwedge_contact *contact = NULL;
    const double alpha = case_value(inputs, A_OVER_B);
    tension_case tension = {.sigma_over_max = range_value(&inputs->value[SIGMA_OVER_MAX], number),
                            .left = NAN,
                            .right = NAN,
                            .number = number,
                            .rows = rows};
    int32_t status = rwedge_contact_create(1, alpha, 1, 1, &contact);
    if (status == RWEDGE_OK)
        status = apply(alpha, case_value(inputs, Q_OVER_FP), tension.sigma_over_max, contact);
    if (status == RWEDGE_OK) {
        tension.contact = contact;
        rwedge_contact_stick_zone(contact, &tension.left, &tension.right);
        status = add_points(&tension);
    }
    rwedge_contact_destroy(contact);
    return status;
}

static int32_t compute_eccentric(const figure_case *inputs, dataset *rows)
{
    int32_t status = RWEDGE_OK;
    for (int n = 0; n < inputs->value[SIGMA_OVER_MAX].count && status == RWEDGE_OK; n++)
        status = add_curve(inputs, n, rows);
    return status;
}

/* ---- The picture ---- */

/* Friction's limit, f p. */
static void draw_limit(double alpha, drawing *on)
{
    enum { STEPS = 200 };
    const int number = dataset_curves(&on->outlines);
    for (int i = -STEPS; i <= STEPS; i++) {
        const double x = i == 0 ? 0 : sin(0.5 * PI * i / STEPS);
        dataset_add(&on->outlines,
                    (data_row){.curve = number, .number = {x, -PI * rwedge_pressure(alpha, x)}});
    }
    drawing_curve(on, &on->outlines, number, 0, 1)->width = 0.5;
}

/* Below the curves, one below the other: a bar for each stick zone. */
static void draw_stick_zones(const dataset *rows, double y, double step, drawing *on)
{
    for (int n = 0; n < dataset_curves(rows); n++) {
        size_t first;
        dataset_curve(rows, n, &first);
        const double *row = rows->row[first].number, top = y - n * step;
        if (!isfinite(row[STICK_LEFT]))
            continue;
        curve *bar = drawing_bar(on, row[STICK_LEFT], row[STICK_RIGHT], top, top - step / 2);
        style_of_family(bar, n);
        bar->width = 1.4;
    }
}

static double extreme(const dataset *rows, double sign)
{
    double most = 0;
    for (size_t i = 0; i < rows->count; i++)
        if (isfinite(rows->row[i].number[SHEAR]))
            most = fmax(most, sign * rows->row[i].number[SHEAR]);
    return most;
}

static const char *draw_eccentric(const figure_case *inputs, const dataset *rows, drawing *on)
{
    char alpha[NUMBER_SIZE], text[NUMBER_SIZE];
    const double top = extreme(rows, 1), bottom = extreme(rows, -1), step = 0.05 * (top + bottom);
    if (top == 0)
        return "without Q there is no shear traction";
    case_text(inputs, A_OVER_B, 0, alpha);
    case_text(inputs, Q_OVER_FP, 0, text);
    snprintf(on->title, sizeof on->title,
             "Shear traction with bulk tension,\n*a*/*b* = %s, *Q*/(*fP*) = %s", alpha, text);
    snprintf(on->caption, sizeof on->caption, "bars: stick zones; thin line: friction's limit");
    on->x = (axis){"*x*/*b*", -1, 1, 0.5, 0};
    on->y = drawing_axis(1.05 * top, "−*qA*π/(*f*θ)");
    on->y.from = -bottom - step * (dataset_curves(rows) + 1);
    on->height = 0.9;
    draw_limit(case_value(inputs, A_OVER_B), on);
    for (int n = 0; n < dataset_curves(rows); n++) {
        curve *line = drawing_curve(on, rows, n, X, SHEAR);
        style_of_family(line, n);
        line->width = 1.4;
        case_text(inputs, SIGMA_OVER_MAX, n, text);
        snprintf(line->legend, sizeof line->legend, "π*b*σ/(4*Q*) = %s", text);
    }
    draw_stick_zones(rows, -bottom - step, step, on);
    return NULL;
}

static const char *const eccentric_columns[] = {
    "sigma_over_max",    "x_over_b",           "minus_pi_A_q_over_f_theta",
    "stick_left_over_b", "stick_right_over_b", NULL};

const figure figure_eccentric = {
    .name = "eccentric",
    .summary = "shear tractions and stick zones where a bulk tension grows with Q",
    .use = {[A_OVER_B] = {"0.25", 1}, [Q_OVER_FP] = {"0.5", 1}, [SIGMA_OVER_MAX] = {"0,0.5,1", 6}},
    .column = eccentric_columns,
    .compute = compute_eccentric,
    .draw = draw_eccentric};
