/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the workbook computes for a case, in C: the value of every cell of cells.h. The file shows
 * these values until the spreadsheet recalculates them, by the formulas in cells.c.
 *
 * Yield comes from a table of (A sqrt(J2)/theta)^2, the largest in the half-plane, for each of its
 * two branches. They are interpolated apart.
 *   - In f and nu: J2 is nearly linear in f^2 and in (1-2 nu)^2/3.
 *   - In a/b: it is smooth in t = ln(tan(phi0/2)), nearly a parabola for a small tip.
 * So a parabola through three nodes of each is taken. */
#ifndef CLI_MODEL_H
#define CLI_MODEL_H

#include "cells.h"

#include <stdbool.h>

enum { TIPS = 51, NUS = 16, FRICTIONS = 21, FRICTIONS_BELOW = 17, TABLE_COLUMNS = NUS * FRICTIONS };

/* Where it yields, at every other tip: x/(a f) on the surface; x/(a f) and y/a below it. */
enum { PLACE_STEP = 2, PLACE_TIPS = TIPS / PLACE_STEP + 1 };
enum { SURFACE_X, BELOW_X, BELOW_Y, PLACES };

#define WORKBOOK_FRICTION_MAX 0.8
#define WORKBOOK_TIP_MIN 0.003

typedef struct {
    double t[TIPS]; /* ln(tan(phi0/2)), sin(phi0) = a/b; equally spaced, up to 0 */
    double nu[NUS], f[FRICTIONS];
    double surface[TIPS][NUS][FRICTIONS];
    double below[TIPS][NUS][FRICTIONS]; /* 0 where there is no maximum below the surface */
    double place[PLACES][PLACE_TIPS][NUS][FRICTIONS]; /* 0 where the branch does not decide */
} yield_table;

/* A value in a cell: a text where there is one, or a number; NAN is an empty text. */
typedef struct {
    double number[CELL_COUNT];
    char safety[24], branch[12]; /* texts of CELL_SAFETY and CELL_BRANCH; "" for the number */
} case_values;

/* Ten digits, as the tables have: a last bit that differs between math libraries does not show. */
double workbook_rounded(double value);

/* AP/(theta a) of the smallest tip of the table. */
double workbook_end_of_table(void);

/* False where the library could not compute a value. */
bool yield_table_fill(yield_table *table);

/* Of inputs that are sound, within the tables, and where |Q| is not above f P; NAN where an input
 * is not given. Or of no inputs at all: all of them NAN. */
void workbook_compute(const yield_table *table, const double input[INPUT_CELLS], case_values *out);

/* The values of limit_at_tip and limit_at_friction for a node, counted from 0. */
double workbook_limit_at_tip(const yield_table *table, const case_values *values, int node);
double workbook_limit_at_friction(const yield_table *table, const case_values *values, int node);

#endif
