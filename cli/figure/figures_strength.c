/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Figs. 3 to 5: the elastic limit, and where it yields. Unlike bodies beside Figs. 4 and 6. */
#include "figure.h"

#include <math.h>
#include <stdio.h>

static const char surface[] = "surface", subsurface[] = "subsurface";

/* What beta f of unlike bodies is drawn; 0 are similar ones. */
#define UNLIKE_USUAL "-0.1,-0.05,0,0.05,0.1"

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
static void compute_normal(const figure_case *inputs, dataset *rows)
{
    const double nu = case_value(inputs, NU), jump = jump_of_yield_point(nu);
    bool jumped = jump == 0;
    for (int i = 0; i < NORMAL_DECADES * NORMAL_PER_DECADE + NORMAL_STEPS; i++) {
        const double alpha = normal_alpha(i);
        double limit, x, y;
        if (!jumped && alpha > jump) {
            case_check(inputs, rwedge_surface_yield(jump, 0, nu, &limit, &x));
            add_normal(jump, nu, limit, 0, false, rows);
            case_check(inputs, rwedge_subsurface_yield(jump, 0, nu, &limit, &x, &y));
            add_normal(jump, nu, limit, y, true, rows);
            jumped = true;
        }
        case_check(inputs, rwedge_yield_point(alpha, 0, nu, &limit, &x, &y));
        add_normal(alpha, nu, limit, y, y > 0, rows);
    }
}

const figure figure_normal = {
    .name = "3",
    .summary = "elastic limit under a normal load, and depth of yield, over a/b",
    .use = {[NU] = {"0.3", 1}},
    .column = (const char *const[]){"a_over_b", "nu", "P_over_bk", "y_over_b", NULL},
    .text_column = "branch",
    .compute = compute_normal,
    .script = normal_lines};

/* ---- Fig. 4 ---- */

/* The paper's steps of friction. */
enum { FRICTION_STEPS = 64 };
static double friction_step(int i)
{
    return i / 80.0;
}

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
static void compute_sliding(const figure_case *inputs, dataset *rows)
{
    for (int n = 0; n < inputs->value[A_OVER_B].count; n++) {
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
}

const figure figure_sliding = {
    .name = "4",
    .summary = "elastic limit in full sliding over f",
    .use = {[A_OVER_B] = {"0.1:1:0.1", FIGURE_CURVES_MAX}, [NU] = {"0.3", 1}},
    .column = (const char *const[]){"a_over_b", "f", "nu", "P_over_bk", NULL},
    .text_column = "branch",
    .compute = compute_sliding,
    .drawn = 1 << 3,
    .nothing = "the elastic limit of a sharp wedge is 0",
    .script = sliding_lines};

/* ---- The map of shakedown ---- */

static void add_passes(const figure_case *inputs, int n, double f, dataset *rows)
{
    const double alpha = range_value(&inputs->value[A_OVER_B], n), nu = case_value(inputs, NU);
    const double elastic = rwedge_elastic_limit(alpha, f, nu);
    double shakedown, y;
    case_check(inputs, rwedge_shakedown_limit(alpha, f, nu, &shakedown, &y));
    dataset_add(rows, (data_row){.curve = n,
                                 .text = y > 0 ? subsurface : surface,
                                 .number = {alpha, f, nu, elastic, shakedown}});
}

/* The friction from which on the surface governs shakedown, where that is between 0 and the last;
 * 0 where it is not. */
static double jump_of_passes(const figure_case *inputs, int n)
{
    const double alpha = range_value(&inputs->value[A_OVER_B], n), nu = case_value(inputs, NU);
    double low = 0, high = friction_step(FRICTION_STEPS), limit, y;
    case_check(inputs, rwedge_shakedown_limit(alpha, low, nu, &limit, &y));
    if (!(y > 0))
        return 0;
    for (int i = 0; i < 40; i++) {
        const double middle = (low + high) / 2;
        case_check(inputs, rwedge_shakedown_limit(alpha, middle, nu, &limit, &y));
        *(y > 0 ? &low : &high) = middle;
    }
    return high < friction_step(FRICTION_STEPS) ? high : 0;
}

/* Both cusps of each curve are points of it. */
static void compute_shakedown(const figure_case *inputs, dataset *rows)
{
    for (int n = 0; n < inputs->value[A_OVER_B].count; n++) {
        const double of_yield = critical_friction(inputs, n), of_passes = jump_of_passes(inputs, n);
        const double cusp[] = {fmin(of_yield, of_passes), fmax(of_yield, of_passes)};
        for (int i = 0; i <= FRICTION_STEPS; i++) {
            for (int k = 0; k < 2 && i > 0; k++)
                if (cusp[k] > friction_step(i - 1) && cusp[k] < friction_step(i))
                    add_passes(inputs, n, cusp[k], rows);
            add_passes(inputs, n, friction_step(i), rows);
        }
    }
}

const figure figure_shakedown = {
    .name = "shakedown",
    .summary = "limits of first yield and of repeated sliding passes over f",
    .use = {[A_OVER_B] = {"0.1,0.25,0.5,1", FIGURE_CURVES_MAX}, [NU] = {"0.3", 1}},
    .column = (const char *const[]){"a_over_b", "f", "nu", "P_over_bk_elastic",
                                    "P_over_bk_shakedown", NULL},
    .text_column = "branch",
    .compute = compute_shakedown,
    .drawn = 1 << 4,
    .nothing = "the limits of a sharp wedge are 0",
    .script = shakedown_lines};

/* ---- Unlike bodies beside Figs. 4 and 6 ---- */

static double limit_of_unlike(const figure_case *inputs, int n, double f, int32_t is_held)
{
    double limit, x, y;
    case_check(inputs, rwedge_sliding_limit(case_value(inputs, A_OVER_B),
                                            range_value(&inputs->value[BETA_F], n), f,
                                            case_value(inputs, NU), is_held, &limit, &x, &y));
    return limit;
}

static void add_unlike(const figure_case *inputs, int n, double f, dataset *rows)
{
    const double alpha = case_value(inputs, A_OVER_B), nu = case_value(inputs, NU);
    dataset_add(rows, (data_row){.curve = n,
                                 .number = {alpha, range_value(&inputs->value[BETA_F], n), f, nu,
                                            rwedge_elastic_limit(alpha, f, nu),
                                            limit_of_unlike(inputs, n, f, 1),
                                            limit_of_unlike(inputs, n, f, 0)}});
}

/* |beta| is at most 1/2: from that friction on. */
static void compute_unlike_limit(const figure_case *inputs, dataset *rows)
{
    for (int n = 0; n < inputs->value[BETA_F].count; n++) {
        const double least = 2 * fabs(range_value(&inputs->value[BETA_F], n));
        add_unlike(inputs, n, least, rows);
        for (int i = 0; i <= FRICTION_STEPS; i++)
            if (friction_step(i) > least)
                add_unlike(inputs, n, friction_step(i), rows);
    }
}

const figure figure_unlike_limit = {
    .name = "unlike-limit",
    .summary = "elastic limit of unlike bodies in sliding over f, beside Fig. 4",
    .use =
        {[A_OVER_B] = {"0.5", 1}, [NU] = {"0.3", 1}, [BETA_F] = {UNLIKE_USUAL, FIGURE_CURVES_MAX}},
    .column = (const char *const[]){"a_over_b", "beta_f", "f", "nu", "P_over_bk", "P_over_bk_held",
                                    "P_over_bk_free", NULL},
    .compute = compute_unlike_limit,
    .drawn = 1 << 4,
    .nothing = "the elastic limit of a sharp wedge is 0",
    .script = unlike_limit_lines};

static double tension_of_unlike(const figure_case *inputs, double alpha, double beta_f,
                                int32_t is_held)
{
    double total, middle, tilt, tension;
    case_check(inputs,
               rwedge_sliding_law(alpha, beta_f, is_held, &total, &middle, &tilt, &tension));
    return tension;
}

static void compute_unlike_tension(const figure_case *inputs, dataset *rows)
{
    enum { STEPS = 100 };
    for (int n = 0; n < inputs->value[BETA_F].count; n++)
        for (int i = 0; i <= STEPS; i++) {
            const double alpha = (double)i / STEPS, beta_f = range_value(&inputs->value[BETA_F], n);
            dataset_add(rows, (data_row){.curve = n,
                                         .number = {alpha, beta_f,
                                                    tension_of_unlike(inputs, alpha, beta_f, 1),
                                                    tension_of_unlike(inputs, alpha, beta_f, 0)}});
        }
}

const figure figure_unlike_tension = {
    .name = "unlike-tension",
    .summary = "maximum tension of unlike bodies over a/b, beside Fig. 6",
    .use = {[BETA_F] = {UNLIKE_USUAL, FIGURE_CURVES_MAX}},
    .column = (const char *const[]){"a_over_b", "beta_f", "b_sigma_over_fP_held",
                                    "b_sigma_over_fP_free", NULL},
    .compute = compute_unlike_tension,
    .script = unlike_tension_lines};

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

/* Which values of a/b have a path, by their numbers, and which have none. */
static void prepare_yield_point(const figure_case *inputs, const dataset *rows, FILE *script)
{
    (void)rows;
    char drawn[4 * FIGURE_CURVES_MAX] = "", missing[sizeof drawn] = "";
    for (int n = 0; n < inputs->value[A_OVER_B].count; n++) {
        const bool has_path = critical_friction(inputs, n) > 0;
        list_add(has_path ? drawn : missing, sizeof drawn, " ", "%d", n + 1);
    }
    script_text(script, "drawn", drawn);
    script_text(script, "missing", missing);
}

const figure figure_yield_point = {
    .name = "5",
    .summary = "path of the subsurface yield point with growing f",
    .use = {[A_OVER_B] = {"0.1:1:0.1", FIGURE_CURVES_MAX}, [NU] = {"0.3", 1}},
    .column = (const char *const[]){"a_over_b", "f", "nu", "x_over_b", "y_over_b", NULL},
    .text_column = "point",
    .compute = compute_yield_point,
    .drawn = 1 << 4,
    .nothing = "it yields at the surface, whatever f is",
    .prepare = prepare_yield_point,
    .script = yield_point_lines};
