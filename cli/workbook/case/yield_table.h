/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of (A sqrt(J2)/theta)^2, the largest in the half-plane, for each of the two branches of
 * yield: on the surface, and below it. */
#ifndef CLI_YIELD_TABLE_H
#define CLI_YIELD_TABLE_H

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

void yield_table_fill(yield_table *table);

/* AP/(theta a) of the smallest tip of the table. */
double workbook_end_of_table(void);

#endif
