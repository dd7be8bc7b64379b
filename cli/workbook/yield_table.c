/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "workbook.h"

#include <math.h>
#include <string.h>

#include <rwedge.h>

enum { TIPS = 51, NUS = 16, FRICTIONS = 21, FRICTIONS_BELOW = 17 };

/* Where it yields, at every other tip: x/(a f) on the surface; x/(a f) and y/a below it. */
enum { PLACE_STEP = 2, PLACE_TIPS = TIPS / PLACE_STEP + 1 };
enum { SURFACE_X, BELOW_X, BELOW_Y, PLACES };

static const double TIP_MIN = 0.003;

struct yield_table {
    double t[TIPS]; /* ln(tan(phi0/2)), sin(phi0) = a/b; equally spaced, up to 0 */
    double tip[TIPS];
    double m[NUS], end;
    double surface[TIPS][NUS][FRICTIONS], below[TIPS][NUS][FRICTIONS]; /* NAN: no such branch */
    double place[PLACES][PLACE_TIPS][NUS][FRICTIONS]; /* NAN where the branch does not decide */
    double limit_at_tip[TIPS], limit_at_friction[FRICTIONS], tension;
};

/* The nodes are closer from nu = 0.18 on. There the branch below the surface begins to decide, and
 * near there it ends. Where a value of a patch is missing, the surface alone decides. f = 0.385 is
 * above all critical frictions (0.378). Hertz' contact still has the branch there. */
static const double nus[NUS] = {0,     0.1,  0.175, 0.2, 0.225, 0.25, 0.275, 0.3,
                                0.325, 0.35, 0.375, 0.4, 0.425, 0.45, 0.475, 0.5};
static const double frictions[FRICTIONS] = {0,     0.025, 0.05,  0.075, 0.1,   0.125, 0.15,
                                            0.175, 0.2,   0.225, 0.25,  0.275, 0.3,   0.325,
                                            0.35,  0.375, 0.385, 0.5,   0.6,   0.7,   0.8};

/* Enough beside the error of interpolation, and the file is smaller. */
enum { TABLE_DIGITS = 6 };

/* (load/limit)^2, rounded; NAN where there is no such branch, or J2 is 0 as on the surface for nu =
 * 0.5 and f = 0. */
static double entry(double load, int32_t status, double limit)
{
    if (status != RWEDGE_OK && status != RWEDGE_EABSENT)
        failure("the workbook: the elastic limit could not be computed");
    const double J2 = status == RWEDGE_OK ? load / limit * (load / limit) : 0;
    return J2 > 0 ? number_rounded(J2, TABLE_DIGITS) : NAN;
}

static void fill_node(yield_table *table, int i, int j, int k)
{
    const double tip = 1 / cosh(table->t[i]), load = rwedge_load(tip);
    double limit = 0, x, y;
    int32_t status = rwedge_surface_yield(tip, frictions[k], nus[j], &limit, &x);
    table->surface[i][j][k] = entry(load, status, limit);
    status = k < FRICTIONS_BELOW
                 ? rwedge_subsurface_yield(tip, frictions[k], nus[j], &limit, &x, &y)
                 : RWEDGE_EABSENT;
    table->below[i][j][k] = entry(load, status, limit);
}

/* x is odd in f, so x/f is even, as J2 is. This f stands for 0. */
static const double SMALL_FRICTION = 1e-3;

/* A branch whose J2 is less than this share of the other's decides in no cell of the table around
 * it: its place is left out. */
static const double FAR_BELOW = 0.7;

/* In thousandths; 0 as an empty cell, which is the same in formulas. */
static double place(double value)
{
    const double rounded = floor(1000 * value + 0.5) / 1000;
    return rounded != 0 ? rounded : NAN;
}

static void fill_place(yield_table *table, int i, int j, int k)
{
    const double tip = 1 / cosh(table->t[PLACE_STEP * i]), f = fmax(frictions[k], SMALL_FRICTION);
    const double surface = fmax(0, table->surface[PLACE_STEP * i][j][k]),
                 below = fmax(0, table->below[PLACE_STEP * i][j][k]);
    double limit, x = NAN, y = NAN;
    if (surface >= FAR_BELOW * below)
        rwedge_surface_yield(tip, f, nus[j], &limit, &x);
    table->place[SURFACE_X][i][j][k] = place(x / (tip * f));
    x = NAN;
    if (below > 0 && below >= FAR_BELOW * surface)
        rwedge_subsurface_yield(tip, f, nus[j], &limit, &x, &y);
    table->place[BELOW_X][i][j][k] = place(x / (tip * f));
    table->place[BELOW_Y][i][j][k] = place(y / tip);
}

yield_table *yield_table_make(const case_values *values)
{
    yield_table *table = memory_zeroed(1, sizeof *table);
    const double f = shown_number(values, "f"), nu = shown_number(values, "nu1"),
                 a_over_b = shown_number(values, "a_over_b");
    const double first = -acosh(1 / TIP_MIN);
    for (int i = 0; i < TIPS; i++) {
        table->t[i] = number_rounded(first * (TIPS - 1 - i) / (TIPS - 1), XLSX_DIGITS);
        table->tip[i] = number_rounded(1 / cosh(table->t[i]), XLSX_DIGITS);
        table->limit_at_tip[i] = rwedge_elastic_limit(1 / cosh(table->t[i]), f, nu);
    }
    for (int n = 0; n < TIPS * NUS * FRICTIONS; n++)
        fill_node(table, n / (NUS * FRICTIONS), n / FRICTIONS % NUS, n % FRICTIONS);
    for (int n = 0; n < PLACE_TIPS * NUS * FRICTIONS; n++)
        fill_place(table, n / (NUS * FRICTIONS), n / FRICTIONS % NUS, n % FRICTIONS);
    for (int i = 0; i < NUS; i++)
        table->m[i] = (1 - 2 * nus[i]) * (1 - 2 * nus[i]) / 3;
    table->end = number_rounded(rwedge_load(TIP_MIN) / TIP_MIN, XLSX_DIGITS);
    for (int i = 0; i < FRICTIONS; i++)
        table->limit_at_friction[i] = rwedge_elastic_limit(a_over_b, frictions[i], nu);
    table->tension = rwedge_max_tension(a_over_b);
    return table;
}

const double *yield_table_numbers(const yield_table *table, const char *name, int *rows,
                                  int *columns)
{
    const struct {
        const char *name;
        int rows, columns;
        const double *number;
    } parts[] = {{"rwt_nu", NUS, 1, nus},
                 {"rwt_ms", NUS, 1, table->m},
                 {"rwt_f", FRICTIONS, 1, frictions},
                 {"rwt_ts", TIPS, 1, table->t},
                 {"rwt_end", 1, 1, &table->end},
                 {"rwt_tips", TIPS, 1, table->tip},
                 {"limit_at_tip", TIPS, 1, table->limit_at_tip},
                 {"limit_at_friction", FRICTIONS, 1, table->limit_at_friction},
                 {"tension_at_tip", 1, 1, &table->tension},
                 {"rwt_surface", TIPS, NUS * FRICTIONS, table->surface[0][0]},
                 {"rwt_below", TIPS, NUS * FRICTIONS, table->below[0][0]},
                 {"rwt_place", PLACES * PLACE_TIPS, NUS * FRICTIONS, table->place[0][0][0]}};
    int i = 0;
    while (strcmp(parts[i].name, name) != 0)
        i++;
    *rows = parts[i].rows;
    *columns = parts[i].columns;
    return parts[i].number;
}
