/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/loads.h"
#include "figure_eccentric.h"

#include <math.h>
#include <stdio.h>

#include <rwedge.h>

static const double PI = 3.14159265358979323846;

/* Of the rows. */
enum { SIGMA, X, SHEAR, STICK_LEFT, STICK_RIGHT };

/* ---- The numbers ---- */

/* theta, A, f and b are 1. */
typedef struct {
    const rwedge_contact *contact;
    double sigma_over_max, left, right; /* edges of the stick zone, NAN where all slides */
    int number;
    dataset *rows;
} case_of_tension;

/* The traction at a point; infinite at the apex of the sharp wedge. */
static int32_t add_point(const case_of_tension *of, double x)
{
    double p, q = -HUGE_VAL;
    const int32_t status = rwedge_contact_tractions(of->contact, 1, &x, &p, &q);
    dataset_add(of->rows,
                (data_row){.curve = of->number,
                           .number = {of->sigma_over_max, x, -PI * q, of->left, of->right}});
    return x == 0 && status == RWEDGE_EDOMAIN ? RWEDGE_OK : status;
}

/* Dense at the edges; the edges of the stick zone are points of their own, as there is a kink. */
static int32_t add_points(const case_of_tension *of)
{
    enum { STEPS = 200 };
    const double kink[] = {of->left, of->right};
    int next = 0;
    int32_t status = RWEDGE_OK;
    for (int i = -STEPS; i <= STEPS && status == RWEDGE_OK; i++) {
        const double x = i == 0 ? 0 : sin(0.5 * PI * i / STEPS);
        for (; next < 2 && kink[next] < x && status == RWEDGE_OK; next++)
            if (kink[next] > -1)
                status = add_point(of, kink[next]);
        if (status == RWEDGE_OK)
            status = add_point(of, x);
    }
    return status;
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

static int32_t add_curve(const figure_case *of, int number, dataset *rows)
{
    rwedge_contact *contact = NULL;
    const double alpha = case_value(of, A_OVER_B);
    case_of_tension one = {.sigma_over_max = range_value(&of->value[SIGMA_OVER_MAX], number),
                           .left = NAN,
                           .right = NAN,
                           .number = number,
                           .rows = rows};
    int32_t status = rwedge_contact_create(1, alpha, 1, 1, &contact);
    if (status == RWEDGE_OK)
        status = apply(alpha, case_value(of, Q_OVER_FP), one.sigma_over_max, contact);
    if (status == RWEDGE_OK) {
        one.contact = contact;
        rwedge_contact_stick_zone(contact, &one.left, &one.right);
        status = add_points(&one);
    }
    rwedge_contact_destroy(contact);
    return status;
}

static int32_t compute_eccentric(const figure_case *of, dataset *rows)
{
    int32_t status = RWEDGE_OK;
    for (int n = 0; n < of->value[SIGMA_OVER_MAX].count && status == RWEDGE_OK; n++)
        status = add_curve(of, n, rows);
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

/* Below the curves, one below the other: a bar for each stick zone, and the tension beside it. */
static void draw_stick_zones(const dataset *rows, double y, double step, drawing *on)
{
    for (int n = 0; n < dataset_curves(rows); n++, y -= step) {
        size_t first;
        char text[NUMBER_SIZE];
        dataset_curve(rows, n, &first);
        const double *row = rows->row[first].number;
        const bool sticks = isfinite(row[STICK_LEFT]);
        drawing_number(fabs(row[SIGMA]), text);
        label *one = drawing_label(on, sticks ? row[STICK_LEFT] - 0.03 : 0, y - step / 4, "%s%s",
                                   row[SIGMA] < 0 ? "−" : "", text);
        one->align = sticks ? ALIGN_RIGHT : ALIGN_CENTRE;
        one->colour = on->curve[n + 1].colour; /* after the limit */
        if (!sticks)
            continue;
        curve *bar = drawing_bar(on, row[STICK_LEFT], row[STICK_RIGHT], y, y - step / 2);
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

static void write_texts(const figure_case *of, drawing *on)
{
    char alpha[NUMBER_SIZE], ratio[NUMBER_SIZE];
    drawing_number(case_value(of, A_OVER_B), alpha);
    drawing_number(case_value(of, Q_OVER_FP), ratio);
    snprintf(on->title, sizeof on->title, "Shear traction with bulk tension");
    snprintf(on->caption, sizeof on->caption,
             "*a*/*b* = %s, *Q*/(*fP*) = %s; bars: stick, by π*b*σ/(4*Q*)", alpha, ratio);
}

static void draw_eccentric(const figure_case *of, const dataset *rows, drawing *on)
{
    const double top = extreme(rows, 1), bottom = extreme(rows, -1);
    const double size = top + bottom > 0 ? top + bottom : 1, step = 0.07 * size;
    const double first_bar = -bottom - step;
    write_texts(of, on);
    on->x = (axis){"*x*/*b*", -1, 1, 0.5, 0};
    on->y = (axis){"−*qA*π/(*f*θ)", first_bar - step * dataset_curves(rows), 1.1 * top + step,
                   size > 4   ? 2
                   : size > 2 ? 1
                              : 0.5,
                   0};
    on->height = 0.95;
    draw_limit(case_value(of, A_OVER_B), on);
    for (int n = 0; n < dataset_curves(rows); n++) {
        curve *one = drawing_curve(on, rows, n, X, SHEAR);
        style_of_family(one, n);
        one->width = 1.4;
    }
    draw_stick_zones(rows, first_bar, step, on);
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
