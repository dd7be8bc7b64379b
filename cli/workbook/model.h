/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the workbook's calculator computes, in C. The cells show these values until the spreadsheet
 * recalculates them, by the formulas in working.c.
 *
 * The elastic limit comes from a table of its two branches, which are interpolated apart.
 *   - In f and nu: 1/limit^2 is nearly linear in f^2 and in (1-2 nu)^2/3, as J2 is. A parabola
 *     through three nodes of each is exact to 1e-4.
 *   - In a/b: the limit is taken as linear in t = ln(tan(phi0/2)). The limit is smooth in t up to
 *     Hertz' contact; in a/b it has a root there. */
#ifndef CLI_MODEL_H
#define CLI_MODEL_H

#include <stdbool.h>

enum { TIPS = 61, NUS = 16, FRICTIONS = 21, FRICTIONS_BELOW = 17, NEWTON_STEPS = 5 };

/* The largest friction with a limit below the surface, and of all. */
#define WORKBOOK_FRICTION_MAX 0.8
#define WORKBOOK_TIP_MIN 0.01

typedef struct {
    /* a/b, ln tan(phi0/2), AP/(theta b), ln(AP/(theta a)) */
    double tip[TIPS], t[TIPS], load[TIPS], log_load[TIPS];
    double nu[NUS], f[FRICTIONS];
    double surface[TIPS][NUS][FRICTIONS];     /* P/(bk) */
    double below[TIPS][NUS][FRICTIONS_BELOW]; /* NAN where there is none */
} limit_table;

typedef struct {
    double theta, a, E1, nu1, E2, nu2, P, f, k;
} workbook_inputs;

typedef struct {
    double A, x, step[NEWTON_STEPS + 1], a_over_b, tip, cosine, b, p0, tension_ratio, tension;
    double beta;
    /* The patch of the table: first node of nu and of f, counted from 0, and the weights of
     * three of each. */
    int nu_node, f_node;
    double m, weight_nu[3], weight_f[3];
    /* limits at these f and nu; NAN: none */
    double surface[TIPS], below[TIPS];
    /* A sqrt(J2)/theta, the larger last */
    double stress_surface[TIPS], stress_below[TIPS], stress[TIPS];
    /* the case among the tips: between node and node + 1 */
    double t, share;
    int node;
    double limit_surface, limit_below, limit;
    double strength; /* k A/theta */
    /* so many tips yield before the load makes them */
    int reached;
    /* ln(AP/(theta a)) at yield by branch; AP/(theta a) */
    double yield_surface, yield_below, yield_either, yield;
    double P_yield, safety, load_over_bk;
    double low_surface[FRICTIONS], high_surface[FRICTIONS], low_below[FRICTIONS],
        high_below[FRICTIONS];
    double curve_surface[FRICTIONS], curve_below[FRICTIONS], curve[FRICTIONS], gap[FRICTIONS];
    int gaps; /* so many frictions yield below the surface */
    double f_critical;
} workbook_results;

/* Ten digits, as the tables have: a last bit that differs between math libraries does not show. */
double workbook_rounded(double value);

/* False where the library could not compute a value. */
bool limit_table_fill(limit_table *table);

/* For inputs that are physical and within the tables. */
void workbook_compute(const limit_table *table, const workbook_inputs *in, workbook_results *out);

#endif
