/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Figs. 3 to 5: the elastic limit, and where it yields. */
#include "figure.h"

#include <math.h>
#include <stdio.h>

static const char surface[] = "surface", subsurface[] = "subsurface";

/* ---- Fig. 3 ---- */

/* Equal steps, and below the first a decade in eight: the limit falls to 0 like the inverse of a
 * logarithm. */
enum { NORMAL_STEPS = 200, NORMAL_DECADES = 8, NORMAL_PER_DECADE = 8 };
static const double NORMAL_FINE_BELOW = 1.0 / NORMAL_STEPS;

static double normal_alpha(int i)
{
    const int fine = NORMAL_DECADES * NORMAL_PER_DECADE;
    if (i == 0)
        return 0;
    return i < fine ? NORMAL_FINE_BELOW * pow(10, (double)(i - fine) / NORMAL_PER_DECADE)
                    : (double)(i - fine + 1) / NORMAL_STEPS;
}

static bool yields_at_surface(double alpha, double nu)
{
    double limit, x, y;
    return rwedge_yield_point(alpha, 0, nu, &limit, &x, &y) == RWEDGE_OK && y == 0;
}

/* The a/b at which the yield point of a normal load jumps; 0 where it does not between the first
 * and the last. */
static double jump_of_yield_point(double nu)
{
    double lo = normal_alpha(1), hi = 1;
    if (!yields_at_surface(lo, nu) || yields_at_surface(hi, nu))
        return 0;
    for (int i = 0; i < 200 && hi - lo > 1e-15 * hi; i++) {
        const double middle = lo < 0.01 * hi ? sqrt(lo * hi) : 0.5 * (lo + hi);
        if (yields_at_surface(middle, nu))
            lo = middle;
        else
            hi = middle;
    }
    return hi;
}

static void add_normal(double alpha, double nu, double limit, double y, bool below, dataset *rows)
{
    dataset_add(rows, (data_row){.curve = below ? 1 : 0,
                                 .text = below ? subsurface : surface,
                                 .number = {alpha, nu, limit, y}});
}

/* Both branches at the jump: the curves end there, and the limit has no gap. */
static void add_jump(const figure_case *inputs, double alpha, dataset *rows)
{
    const double nu = case_value(inputs, NU);
    double limit, x, y;
    case_check(inputs, rwedge_surface_yield(alpha, 0, nu, &limit, &x));
    add_normal(alpha, nu, limit, 0, false, rows);
    case_check(inputs, rwedge_subsurface_yield(alpha, 0, nu, &limit, &x, &y));
    add_normal(alpha, nu, limit, y, true, rows);
}

static void compute_normal(const figure_case *inputs, dataset *rows)
{
    const double nu = case_value(inputs, NU), jump = jump_of_yield_point(nu);
    bool jumped = jump == 0;
    for (int i = 0; i < NORMAL_DECADES * NORMAL_PER_DECADE + NORMAL_STEPS; i++) {
        const double alpha = normal_alpha(i);
        double limit, x, y;
        if (!jumped && alpha > jump)
            add_jump(inputs, jump, rows);
        jumped = jumped || alpha > jump;
        case_check(inputs, rwedge_yield_point(alpha, 0, nu, &limit, &x, &y));
        add_normal(alpha, nu, limit, y, y > 0, rows);
    }
}

/* Value of a column at the first row that reaches a/b. */
static double normal_at(const dataset *rows, double alpha, int column)
{
    size_t i = 0;
    while (i + 1 < rows->count && rows->row[i].number[0] < alpha)
        i++;
    return rows->count > 0 ? rows->row[i].number[column] : NAN;
}

static void draw_jump(const dataset *rows, drawing *plot)
{
    size_t first;
    if (dataset_curve(rows, 0, &first) < 2 || dataset_curve(rows, 1, &first) == 0)
        return;
    const double alpha = rows->row[first].number[0], y = rows->row[first].number[3];
    for (int i = 0; i < 2; i++)
        dataset_add(&plot->outlines, (data_row){.curve = 0, .number = {alpha, i * y}});
    curve *jump = drawing_curve(plot, &plot->outlines, 0, 0, 1);
    jump->second_axis = true;
    jump->colour = VERMILLION;
    jump->dash = 2;
    const bool left = alpha < 0.5;
    label *note = drawing_label(plot, left ? fmax(alpha + 0.03, 0.08) : alpha - 0.03, 0.07,
                                "jump at %.4g", alpha);
    note->second_axis = true;
    note->colour = VERMILLION;
    note->align = left ? ALIGN_LEFT : ALIGN_RIGHT;
}

static const char *draw_normal(const figure_case *inputs, const dataset *rows, drawing *plot)
{
    char nu[NUMBER_SIZE];
    snprintf(plot->title, sizeof plot->title, "Elastic limit under a normal load, ν = %s",
             case_text(inputs, NU, 0, nu));
    const double top = ceil(normal_at(rows, 1, 2));
    plot->x = (axis){"*a*/*b*", 0, 1, 0.2, 0};
    plot->y = (axis){"*P*/(*bk*)", 0, top > 4 ? top : 5, 1, 0};
    plot->second = (axis){"*y*/*b* of the yield point", 0, 1, 0.2, 0};
    plot->height = 0.85;
    for (int n = 0; n < 2; n++) {
        drawing_curve(plot, rows, n, 0, 2)->width = 1.5;
        curve *depth = drawing_curve(plot, rows, n, 0, 3);
        depth->width = 1.5;
        depth->second_axis = true;
        depth->colour = VERMILLION;
        depth->dash = 1;
    }
    drawing_label(plot, 0.42, normal_at(rows, 0.42, 2) + 0.05 * plot->y.to, "← *P*/(*bk*)")->align =
        ALIGN_RIGHT;
    const double deep = normal_at(rows, 0.66, 3);
    label *depth = drawing_label(plot, 0.66, deep > 0.2 ? deep - 0.07 : deep + 0.07, "*y*/*b* →");
    depth->second_axis = true;
    depth->colour = VERMILLION;
    draw_jump(rows, plot);
    return NULL;
}

const figure figure_normal = {
    .name = "3",
    .summary = "elastic limit under a normal load, and depth of yield, over a/b",
    .use = {[NU] = {"0.3", 1}},
    .column = (const char *const[]){"a_over_b", "nu", "P_over_bk", "y_over_b", NULL},
    .text_column = "branch",
    .compute = compute_normal,
    .draw = draw_normal};

/* ---- Fig. 4 ---- */

/* The paper's steps of friction. */
enum { FRICTION_STEPS = 64 };
static double friction_step(int i)
{
    return i / 80.0;
}
static const double FRICTION_TOP = 0.8;

/* The limit on the side of the cusp that is asked for; the sharp wedge has no branches. */
static void add_sliding(const figure_case *inputs, int n, double f, bool below, dataset *rows)
{
    const double alpha = range_value(&inputs->value[A_OVER_B], n), nu = case_value(inputs, NU);
    double limit, x, y;
    if (alpha == 0)
        case_check(inputs, rwedge_yield_point(alpha, f, nu, &limit, &x, &y));
    else
        case_check(inputs, below ? rwedge_subsurface_yield(alpha, f, nu, &limit, &x, &y)
                                 : rwedge_surface_yield(alpha, f, nu, &limit, &x));
    dataset_add(rows, (data_row){.curve = n,
                                 .text = below ? subsurface : surface,
                                 .number = {alpha, f, nu, limit}});
}

/* The friction up to which the curve n is below the surface; 0 for a sharp wedge. */
static double critical_friction(const figure_case *inputs, int n)
{
    const double alpha = range_value(&inputs->value[A_OVER_B], n);
    const double critical = alpha > 0 ? rwedge_critical_friction(alpha, case_value(inputs, NU)) : 0;
    case_check(inputs, isnan(critical) ? RWEDGE_ENOCONV : RWEDGE_OK);
    return critical;
}

/* Each branch up to the critical friction, which is a point of both: the cusp is exact. */
static void add_sliding_curve(const figure_case *inputs, int n, dataset *rows)
{
    const double critical = critical_friction(inputs, n);
    bool below = critical > 0;
    for (int i = 0; i <= FRICTION_STEPS; i++) {
        const double f = friction_step(i);
        if (below && f >= critical) {
            add_sliding(inputs, n, critical, true, rows);
            add_sliding(inputs, n, critical, false, rows);
            below = false;
        }
        if (!(f == critical && critical > 0))
            add_sliding(inputs, n, f, below, rows);
    }
}

static void compute_sliding(const figure_case *inputs, dataset *rows)
{
    for (int n = 0; n < inputs->value[A_OVER_B].count; n++)
        add_sliding_curve(inputs, n, rows);
}

static const char *draw_sliding(const figure_case *inputs, const dataset *rows, drawing *plot)
{
    char text[NUMBER_SIZE];
    const double top = dataset_largest(rows, 3, 1);
    snprintf(plot->title, sizeof plot->title, "Elastic limit in full sliding, by *a*/*b*; ν = %s",
             case_text(inputs, NU, 0, text));
    if (top == 0)
        return "the elastic limit of a sharp wedge is 0";
    plot->x = (axis){"*f*", 0, FRICTION_TOP, 0.2, 0};
    plot->y = drawing_axis(top, "*P*/(*bk*)");
    plot->height = 0.96;
    draw_family(inputs, A_OVER_B, rows, 1, 3, plot);
    return NULL;
}

const figure figure_sliding = {
    .name = "4",
    .summary = "elastic limit in full sliding over f",
    .use = {[A_OVER_B] = {"0.1:1:0.1", FIGURE_CURVES_MAX}, [NU] = {"0.3", 1}},
    .column = (const char *const[]){"a_over_b", "f", "nu", "P_over_bk", NULL},
    .text_column = "branch",
    .compute = compute_sliding,
    .draw = draw_sliding};

/* ---- Fig. 5 ---- */

static void add_yield_point(const figure_case *inputs, int n, double f, const char *point,
                            dataset *rows)
{
    const double alpha = range_value(&inputs->value[A_OVER_B], n), nu = case_value(inputs, NU);
    double limit, x, y;
    case_check(inputs, rwedge_subsurface_yield(alpha, f, nu, &limit, &x, &y));
    dataset_add(rows, (data_row){.curve = n, .text = point, .number = {alpha, f, nu, x, y}});
}

/* A cross for each step of friction, and the last point below the surface. */
static void compute_yield_point(const figure_case *inputs, dataset *rows)
{
    for (int n = 0; n < inputs->value[A_OVER_B].count; n++) {
        const double critical = critical_friction(inputs, n);
        for (int i = 0; friction_step(i) < critical; i++)
            add_yield_point(inputs, n, friction_step(i), "step", rows);
        if (critical > 0)
            add_yield_point(inputs, n, critical, "jump", rows);
    }
}

/* The line has the name. What the marks are is said once. */
static void draw_path(const figure_case *inputs, const dataset *rows, int n, bool explain,
                      drawing *plot)
{
    const curve *line = draw_member(inputs, A_OVER_B, n, "", rows, 3, 4, plot);
    curve *crosses = drawing_curve(plot, rows, n, 3, 4);
    crosses->style = STYLE_CROSSES;
    crosses->colour = line->colour;
    crosses->count--;
    curve *end = drawing_curve(plot, rows, n, 3, 4);
    end->style = STYLE_CIRCLES;
    end->colour = VERMILLION;
    end->first += end->count - 1;
    end->count = 1;
    if (explain)
        snprintf(plot->caption, sizeof plot->caption,
                 "crosses: every 0.0125 in *f*;\ncircles: jump to the surface");
}

/* The deepest and the rightmost point. */
static void set_axes(const dataset *rows, drawing *plot)
{
    const double right = dataset_largest(rows, 3, 1), down = dataset_largest(rows, 4, 1);
    plot->y = drawing_axis(1.02 * down, "*y*/*b*");
    plot->y.from = plot->y.to;
    plot->y.to = 0;
    plot->x = drawing_axis(fmax(1.05 * right, plot->y.from), "*x*/*b*");
}

/* Values of a/b that have no path; all texts fit, or the last is cut. */
static void name_missing(const figure_case *inputs, const dataset *rows, drawing *plot)
{
    char text[NUMBER_SIZE];
    size_t first;
    int missing = 0;
    for (int n = 0; n < inputs->value[A_OVER_B].count; n++)
        if (dataset_curve(rows, n, &first) == 0) {
            list_add(plot->caption, sizeof plot->caption,
                     missing == 0       ? ";\n"
                     : missing % 3 == 0 ? ",\n"
                                        : ", ",
                     "%s%s", missing == 0 ? "always at the surface: *a*/*b* = " : "",
                     case_text(inputs, A_OVER_B, n, text));
            missing++;
        }
}

static const char *draw_yield_point(const figure_case *inputs, const dataset *rows, drawing *plot)
{
    char text[NUMBER_SIZE];
    if (rows->count == 0)
        return "it yields at the surface, whatever f is";
    snprintf(plot->title, sizeof plot->title, "Subsurface yield point, by *a*/*b*; ν = %s",
             case_text(inputs, NU, 0, text));
    set_axes(rows, plot);
    bool explain = true;
    for (int n = 0; n < inputs->value[A_OVER_B].count; n++) {
        size_t first;
        if (dataset_curve(rows, n, &first) == 0)
            continue;
        draw_path(inputs, rows, n, explain, plot);
        explain = false;
    }
    name_missing(inputs, rows, plot);
    return NULL;
}

const figure figure_yield_point = {
    .name = "5",
    .summary = "path of the subsurface yield point with growing f",
    .use = {[A_OVER_B] = {"0.1:1:0.1", FIGURE_CURVES_MAX}, [NU] = {"0.3", 1}},
    .column = (const char *const[]){"a_over_b", "f", "nu", "x_over_b", "y_over_b", NULL},
    .text_column = "point",
    .compute = compute_yield_point,
    .draw = draw_yield_point};
