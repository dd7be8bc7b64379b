/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contours of von Mises' stress below the contact. */
#include "figure.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Rows are closer to each other near the surface, where the stress changes most. */
enum { FIELD_COLUMNS = 241, FIELD_ROWS = 97 };
static const double FIELD_HALF_WIDTH = 1.5, FIELD_DEPTH = 1.5;

static double stick_width(const figure_case *inputs)
{
    if (inputs->value[C_OVER_B].count > 0)
        return case_value(inputs, C_OVER_B);
    return inputs->value[Q_OVER_FP].count > 0
               ? rwedge_stick_width(case_value(inputs, A_OVER_B), case_value(inputs, Q_OVER_FP))
               : 0;
}

static void compute_field(const figure_case *inputs, dataset *rows)
{
    const double alpha = case_value(inputs, A_OVER_B), f = case_value(inputs, FRICTION),
                 nu = case_value(inputs, NU);
    const double c = stick_width(inputs);
    rows->across = FIELD_COLUMNS;
    for (int j = 0; j < FIELD_ROWS; j++)
        for (int i = 0; i < FIELD_COLUMNS; i++) {
            const double x = FIELD_HALF_WIDTH * (2 * i - (FIELD_COLUMNS - 1)) / (FIELD_COLUMNS - 1),
                         y = FIELD_DEPTH * pow((double)j / (FIELD_ROWS - 1), 1.5);
            double sxx, syy, txy;
            const int32_t status = rwedge_stress(alpha, f, c, x, y, &sxx, &syy, &txy);
            if (alpha == 0 && x == 0 && y == 0) /* infinite at the sharp apex */
                sxx = syy = txy = NAN;
            else
                case_check(inputs, status);
            const double sqrt_J2 = rwedge_von_mises(sxx, syy, txy, nu) / sqrt(3);
            dataset_add(rows, (data_row){.number = {x, y, sxx, syy, txy, sqrt_J2}});
        }
}

/* ---- Contours ---- */

/* Rows and columns of the grid without numbers of contours: none stands on the edges of the
 * picture. */
enum { MARGIN = 14, FIRST_ROW = 18 };

/* What has a number already. */
typedef struct {
    double x, y;
    char text[NUMBER_SIZE];
} level_number;

typedef struct {
    level_number number[60];
    int count;
    double step;
} level_numbers;

/* The number of a level where the way from one place of the grid to the next crosses it, unless
 * another number is next to it, or the same one near. */
static void name_level(const data_row *from, const data_row *to, level_numbers *all)
{
    const double a = from->number[5], b = to->number[5], step = all->step;
    const double level = step * ceil(fmin(a, b) / step), part = (level - a) / (b - a);
    level_number *next = &all->number[all->count];
    if (!(level <= fmax(a, b)) || !(level > 0) || a == b)
        return;
    next->x = from->number[0] + part * (to->number[0] - from->number[0]);
    next->y = from->number[1] + part * (to->number[1] - from->number[1]);
    number_write(level, FIGURE_DIGITS, '.', next->text);
    for (const level_number *other = all->number; other < next; other++)
        if (fabs(next->x - other->x) < 0.32 &&
            fabs(next->y - other->y) < (strcmp(next->text, other->text) == 0 ? 0.6 : 0.12))
            return;
    all->count += all->count < (int)(sizeof all->number / sizeof all->number[0]) - 1;
}

/* Downwards from the place nearest to x, and along a row both ways from there. */
static void name_levels(const dataset *rows, double x, double step, FILE *script)
{
    enum { ROW = FIELD_ROWS - 12 };
    const double nearest = (FIELD_COLUMNS - 1) * (0.5 + 0.5 * x / FIELD_HALF_WIDTH);
    const int column = (int)fmin(fmax(nearest, MARGIN), FIELD_COLUMNS - 1 - MARGIN);
    const data_row *top = &rows->row[column], *row = &rows->row[ROW * FIELD_COLUMNS];
    level_numbers all = {.step = step};
    for (int j = FIRST_ROW; j < ROW; j++)
        name_level(&top[j * FIELD_COLUMNS], &top[(j + 1) * FIELD_COLUMNS], &all);
    for (int i = column; i > MARGIN; i--)
        name_level(&row[i], &row[i - 1], &all);
    for (int i = column; i < FIELD_COLUMNS - 1 - MARGIN; i++)
        name_level(&row[i], &row[i + 1], &all);
    for (int i = 0; i < all.count; i++)
        fprintf(script,
                "set label \"%s\" at first %.7g,%.7g center front textcolor rgb '#000000' boxed\n",
                all.number[i].text, all.number[i].x, all.number[i].y);
}

/* ---- What stands on them ---- */

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
    if (status == RWEDGE_ENOMEM)
        failure("out of memory");
    *top = factor > 0 ? 1 / factor : 0;
    return status == RWEDGE_OK && factor > 0;
}

static void prepare_field(const figure_case *inputs, const dataset *rows, FILE *script)
{
    const double top = dataset_largest(rows, 5), step = step_of_levels(top);
    double x = 0, y = 0, most = 0;
    const bool yields = find_yield(inputs, &x, &y, &most);
    name_levels(rows, yields ? x : 0, step, script);
    script_number(script, "stick", stick_width(inputs));
    script_number(script, "top", top);
    script_number(script, "step", step);
    script_number(script, "yields", yields);
    script_number(script, "yield_x", x);
    script_number(script, "yield_y", y);
    script_number(script, "most", most);
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
    .prepare = prepare_field,
    .script = field_lines};
