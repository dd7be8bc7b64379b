/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "yield_table.h"

#include "rounded.h"

#include <math.h>
#include <string.h>

#include <rwedge.h>

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
 * 0.5 and f = 0. False where it could not be computed. */
static bool fill_one(double load, int32_t status, double limit, double *value)
{
    *value = status == RWEDGE_OK ? rounded_to(load / limit * (load / limit), TABLE_DIGITS) : 0;
    return status == RWEDGE_OK || status == RWEDGE_EABSENT;
}

static bool fill_tip(yield_table *table, int i)
{
    const double tip = 1 / cosh(table->t[i]), load = rwedge_load(tip);
    bool done = true;
    for (int j = 0; j < NUS; j++)
        for (int k = 0; k < FRICTIONS; k++) {
            double limit = 0, x, y;
            const int32_t status = rwedge_surface_yield(tip, frictions[k], nus[j], &limit, &x);
            done = fill_one(load, status, limit, &table->surface[i][j][k]) && done;
            table->below[i][j][k] = 0;
            if (k >= FRICTIONS_BELOW)
                continue;
            const int32_t deep = rwedge_subsurface_yield(tip, frictions[k], nus[j], &limit, &x, &y);
            done = fill_one(load, deep, limit, &table->below[i][j][k]) && done;
        }
    return done;
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
            for (int which = 0; which < PLACES; which++)
                table->place[which][i][j][k] = 0;
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

bool yield_table_fill(yield_table *table)
{
    const double first = -acosh(1 / WORKBOOK_TIP_MIN);
    bool done = true;
    memcpy(table->nu, nus, sizeof nus);
    memcpy(table->f, frictions, sizeof frictions);
    for (int i = 0; i < TIPS; i++) {
        table->t[i] = workbook_rounded(first * (TIPS - 1 - i) / (TIPS - 1));
        done = fill_tip(table, i) && done;
    }
    for (int i = 0; i < PLACE_TIPS; i++)
        fill_places(table, i);
    return done;
}

double workbook_end_of_table(void)
{
    return workbook_rounded(rwedge_load(WORKBOOK_TIP_MIN) / WORKBOOK_TIP_MIN);
}
