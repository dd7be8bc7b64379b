/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "workbook.h"

#include "number/number.h"

#include <math.h>
#include <string.h>

#include <rwedge.h>

double workbook_rounded(double value)
{
    return number_rounded(value, 10);
}

double workbook_computed(double value)
{
    if (!isfinite(value))
        failure("the workbook: a value of its tables could not be computed");
    return workbook_rounded(value);
}

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

/* (load/limit)^2, rounded; 0 where there is no such branch, or J2 is 0 as on the surface for nu =
 * 0.5 and f = 0. */
static double entry(double load, int32_t status, double limit)
{
    if (status != RWEDGE_OK && status != RWEDGE_EABSENT)
        failure("the workbook: the elastic limit could not be computed");
    return status == RWEDGE_OK ? number_rounded(load / limit * (load / limit), TABLE_DIGITS) : 0;
}

static void fill_tip(yield_table *table, int i)
{
    const double tip = 1 / cosh(table->t[i]), load = rwedge_load(tip);
    for (int j = 0; j < NUS; j++)
        for (int k = 0; k < FRICTIONS; k++) {
            double limit = 0, x, y;
            const int32_t status = rwedge_surface_yield(tip, frictions[k], nus[j], &limit, &x);
            table->surface[i][j][k] = entry(load, status, limit);
            table->below[i][j][k] = 0;
            if (k >= FRICTIONS_BELOW)
                continue;
            const int32_t deep = rwedge_subsurface_yield(tip, frictions[k], nus[j], &limit, &x, &y);
            table->below[i][j][k] = entry(load, deep, limit);
        }
}

/* x is odd in f, so x/f is even, as J2 is. This f stands for 0. */
static const double SMALL_FRICTION = 1e-3;

/* A branch whose J2 is less than this share of the other's decides in no cell of the table around
 * it: its place is left out. */
static const double FAR_BELOW = 0.7;

static double thousandths(double value)
{
    return floor(1000 * value + 0.5) / 1000;
}

static void fill_places(yield_table *table, int i)
{
    const double tip = 1 / cosh(table->t[PLACE_STEP * i]);
    for (int j = 0; j < NUS; j++)
        for (int k = 0; k < FRICTIONS; k++) {
            const double f = fmax(frictions[k], SMALL_FRICTION);
            const double surface = table->surface[PLACE_STEP * i][j][k],
                         below = table->below[PLACE_STEP * i][j][k];
            double limit, x, y;
            for (int p = 0; p < PLACES; p++)
                table->place[p][i][j][k] = 0;
            if (surface >= FAR_BELOW * below &&
                rwedge_surface_yield(tip, f, nus[j], &limit, &x) == RWEDGE_OK)
                table->place[SURFACE_X][i][j][k] = thousandths(x / (tip * f));
            if (below > 0 && below >= FAR_BELOW * surface &&
                rwedge_subsurface_yield(tip, f, nus[j], &limit, &x, &y) == RWEDGE_OK) {
                table->place[BELOW_X][i][j][k] = thousandths(x / (tip * f));
                table->place[BELOW_Y][i][j][k] = thousandths(y / tip);
            }
        }
}

void yield_table_fill(yield_table *table)
{
    const double first = -acosh(1 / WORKBOOK_TIP_MIN);
    memcpy(table->nu, nus, sizeof nus);
    memcpy(table->f, frictions, sizeof frictions);
    for (int i = 0; i < TIPS; i++) {
        table->t[i] = workbook_rounded(first * (TIPS - 1 - i) / (TIPS - 1));
        fill_tip(table, i);
    }
    for (int i = 0; i < PLACE_TIPS; i++)
        fill_places(table, i);
}

double workbook_end_of_table(void)
{
    return workbook_rounded(rwedge_load(WORKBOOK_TIP_MIN) / WORKBOOK_TIP_MIN);
}
