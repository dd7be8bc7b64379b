/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "yield_values.h"

#include "interpolation.h"
#include "text/pi.h"

#include <math.h>
#include <stdio.h>

#include <rwedge.h>

/* ---- The limit ------------------------------------------------------------------------------- */

static void find_limit(const yield_table *table, double v[])
{
    bool none = false, missing = false;
    const double tip = v[WORK_N5];
    v[WORK_SURFACE] = patch_at_case(table->surface, v, &none);
    v[WORK_BELOW] = patch_at_case(table->below, v, &missing);
    if (missing)
        v[WORK_BELOW] = 0;
    v[WORK_LIMIT] = v[WORK_ROUNDING] == 0 ? 0
                                          : (asin(tip) / tip + v[WORK_COS]) /
                                                sqrt(fmax(v[WORK_SURFACE], v[WORK_BELOW]));
    v[WORK_OK_F] = v[WORK_OK] > 0 && v[CELL_NU1] >= 0 && v[WORK_F] <= WORKBOOK_FRICTION_MAX;
    v[WORK_OK_TIP] = v[WORK_ROUNDING] == 0 || v[WORK_RATIO] >= WORKBOOK_TIP_MIN * (1 - 1e-9);
}

/* ---- The yield load -------------------------------------------------------------------------- */

static const double NEVER = 1e99;

/* The tips at which the branch is below k^2 are the last ones, as J2 falls where the tip grows. */
static void reach(branch values, bool may_miss, const double v[], double y[])
{
    int beyond = 0;
    for (int i = 0; i < TIPS; i++) {
        bool missing = false;
        const double value = patch_at_tip(values, i, v, &missing);
        beyond += value < v[WORK_STRENGTH] && !(may_miss && missing);
    }
    y[YIELD_REACHED] = TIPS - beyond;
    y[YIELD_NODE] = fmin(fmax(y[YIELD_REACHED], 1), TIPS - 2);
    for (int i = 0; i < 3; i++) {
        bool missing = false;
        y[YIELD_K + i] = patch_at_tip(values, (int)y[YIELD_NODE] - 1 + i, v, &missing);
        if (may_miss && missing)
            y[YIELD_K + i] = 0;
    }
}

static void find_yield(const yield_table *table, branch values, bool may_miss, const double v[],
                       double y[])
{
    reach(values, may_miss, v, y);
    const double reached = y[YIELD_REACHED], k2 = v[WORK_STRENGTH], *k = &y[YIELD_K];
    const double first = fmax(reached, 1) - y[YIELD_NODE], bend = k[2] - 2 * k[1] + k[0];
    const bool none = reached == 0 || fmin(k[0], fmin(k[1], k[2])) <= 0;
    y[YIELD_G] = k[(int)first] - k2;
    y[YIELD_D] = k[1] - k[0] + bend * (first - 0.5);
    const double root = sqrt(fmax(0, y[YIELD_D] * y[YIELD_D] - 2 * bend * y[YIELD_G]));
    const double place =
        none || reached == TIPS ? 0 : reached - 1 + 2 * y[YIELD_G] / (root - y[YIELD_D]);
    const double t = y[YIELD_U] = table->t[0] * (1 - place / (TIPS - 1));
    y[YIELD_LOAD] = none              ? NEVER
                    : reached == TIPS ? PI / 2 * k2 / k[2]
                                      : (asin(1 / cosh(t)) - tanh(t) / cosh(t)) * cosh(t) * cosh(t);
}

static void find_strength(const yield_table *table, double v[])
{
    const double unit = v[WORK_K] * v[WORK_COMPLIANCE] / v[WORK_THETA];
    v[WORK_STRENGTH] = unit * unit;
    find_yield(table, table->surface, false, v, &v[WORK_YIELD_S]);
    find_yield(table, table->below, true, v, &v[WORK_YIELD_B]);
    v[WORK_YIELD] = fmin(v[WORK_YIELD_S + YIELD_LOAD], v[WORK_YIELD_B + YIELD_LOAD]);
    const double bound = workbook_end_of_table() * v[WORK_X];
    v[WORK_BOUND] = bound >= 10 ? floor(bound) : floor(bound * 10) / 10;
}

static bool at_surface(const double v[])
{
    return v[WORK_YIELD_S + YIELD_LOAD] <= v[WORK_YIELD_B + YIELD_LOAD];
}

static void place_yield(const yield_table *table, double v[])
{
    const double t = v[WORK_YIELD] <= PI / 2 ? 0
                     : at_surface(v)         ? v[WORK_YIELD_S + YIELD_U]
                                             : v[WORK_YIELD_B + YIELD_U];
    v[WORK_YIELD_T] = t;
    v[WORK_PLACE_U] = (1 - t / table->t[0]) * (PLACE_TIPS - 1);
    v[WORK_PLACE_NODE] = fmin(floor(v[WORK_PLACE_U]), PLACE_TIPS - 3);
    parabola(v[WORK_PLACE_U] - v[WORK_PLACE_NODE], &v[WORK_WEIGHT_PLACE]);
    v[WORK_PLACE_ROW] = v[WORK_PLACE_NODE] + 1 + (at_surface(v) ? 0 : PLACE_TIPS);
    v[WORK_PLACE_UNIT] = v[WORK_ROUNDING] * sqrt(fmin(1, 2 / PI * v[WORK_YIELD]));
}

/* ---- Critical friction ----------------------------------------------------------------------- */

/* The J2 of the surface less that below it, at this a/b and nu. */
static double gap_at(const yield_table *table, int f, const double v[], bool *missing)
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        const int tip = (int)v[WORK_TIP_NODE] - 1 + i;
        bool none = false;
        sum += v[WORK_WEIGHT_T + i] * (patch_at_friction(table->surface, tip, f, v, &none) -
                                       patch_at_friction(table->below, tip, f, v, missing));
    }
    return sum;
}

/* Where the branches cross. The difference of their J2 is nearly linear in f^2. If the branch below
 * the surface has ended at the next node, the line through the two nodes before it is extended. */
static void find_critical(const yield_table *table, double v[])
{
    int gaps = 0;
    for (int f = 0; f < FRICTIONS; f++) {
        bool missing = false;
        gaps += gap_at(table, f, v, &missing) < 0 && !missing;
    }
    bool ended = false, ignored = false;
    gap_at(table, gaps, v, &ended);
    const int node = ended && gaps > 1 ? gaps - 1 : (int)fmax(1, gaps);
    v[WORK_GAPS] = gaps;
    v[WORK_GAP_NODE] = node;
    v[WORK_GAP_1] = gap_at(table, node - 1, v, &ignored);
    v[WORK_GAP_2] = gap_at(table, node, v, &ignored);
}

void yield_solve(const yield_table *table, double v[CELL_COUNT])
{
    patch_find(table, v);
    find_limit(table, v);
    find_strength(table, v);
    place_yield(table, v);
    find_critical(table, v);
}

/* ---- Results --------------------------------------------------------------------------------- */

static double critical_friction(const yield_table *table, const double v[])
{
    if (v[WORK_GAPS] <= 0)
        return 0;
    const double *f = &table->f[(int)v[WORK_GAP_NODE] - 1];
    const double share = v[WORK_GAP_1] / (v[WORK_GAP_1] - v[WORK_GAP_2]);
    return sqrt(f[0] * f[0] + (f[1] * f[1] - f[0] * f[0]) * share);
}

static void answer_place(const yield_table *table, case_values *out)
{
    double *v = out->number;
    const bool surface = v[WORK_ROUNDING] == 0 || at_surface(v);
    const int node = (int)v[WORK_PLACE_NODE];
    const double *weight = &v[WORK_WEIGHT_PLACE];
    bool none = false;
    const double x = patch_at_tips(table->place[at_surface(v) ? SURFACE_X : BELOW_X], node, weight,
                                   v, &none),
                 y = patch_at_tips(table->place[BELOW_Y], node, weight, v, &none);
    snprintf(out->branch, sizeof out->branch, "%s", surface ? "surface" : "subsurface");
    v[CELL_YIELD_X] = (v[CELL_Q] < 0 ? -1 : 1) * v[WORK_PLACE_UNIT] * v[WORK_F_TABLE] * x;
    v[CELL_YIELD_Y] = surface ? 0 : v[WORK_PLACE_UNIT] * y;
}

void yield_answer(const yield_table *table, case_values *out)
{
    double *v = out->number;
    const bool has_k = v[WORK_HAS_K] > 0, tip = v[WORK_OK_TIP] > 0, f = v[WORK_OK_F] > 0;
    const bool sharp = v[WORK_ROUNDING] == 0;
    v[CELL_LOAD_OVER_BK] = has_k ? v[WORK_LOAD] / (v[WORK_B] * v[WORK_K]) : NAN;
    v[CELL_P_OVER_BK] = f && tip ? v[WORK_LIMIT] : NAN;
    if (f && tip && !sharp)
        v[CELL_VON_MISES] = sqrt(3) * v[WORK_LOAD] / v[WORK_B] / v[WORK_LIMIT];
    if (tip && !sharp && v[CELL_NU1] >= 0)
        v[CELL_F_CRITICAL] = critical_friction(table, v);
    v[CELL_SAFETY_STRENGTH] = v[CELL_P_OVER_BK] / v[CELL_LOAD_OVER_BK];
    if (!has_k || !f)
        return;
    if (sharp || v[WORK_YIELD] < NEVER) {
        v[CELL_P_YIELD] =
            sharp ? 0 : v[WORK_YIELD] * v[WORK_THETA] * v[WORK_ROUNDING] / v[WORK_COMPLIANCE];
        v[CELL_SAFETY] = v[CELL_P_YIELD] / v[WORK_LOAD];
        answer_place(table, out);
    } else
        snprintf(out->safety, sizeof out->safety, "> %.*f", v[WORK_BOUND] >= 10 ? 0 : 1,
                 v[WORK_BOUND]);
}

/* ---- Curves ---------------------------------------------------------------------------------- */

static double limit_from(double load, double surface, double below, bool missing)
{
    return load / sqrt(fmax(surface, missing ? 0 : below));
}

double workbook_limit_at_tip(const yield_table *table, const case_values *values, int node)
{
    bool none = false, missing = false;
    const double surface = patch_at_tip(table->surface, node, values->number, &none),
                 below = patch_at_tip(table->below, node, values->number, &missing);
    return limit_from(rwedge_load(1 / cosh(table->t[node])), surface, below, missing);
}

double workbook_limit_at_friction(const yield_table *table, const case_values *values, int node)
{
    const double *v = values->number;
    bool missing = false;
    double surface = 0, below = 0;
    for (int i = 0; i < 3; i++) {
        const int tip = (int)v[WORK_TIP_NODE] - 1 + i;
        bool none = false;
        surface += v[WORK_WEIGHT_T + i] * patch_at_friction(table->surface, tip, node, v, &none);
        below += v[WORK_WEIGHT_T + i] * patch_at_friction(table->below, tip, node, v, &missing);
    }
    return limit_from(asin(v[WORK_N5]) / v[WORK_N5] + v[WORK_COS], surface, below, missing);
}
