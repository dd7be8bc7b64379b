/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "computed/growing_cells.h"

#include <math.h>
#include <stdlib.h>

static bool allocate(rw_growth *g, size_t n)
{
    *g = (rw_growth){
        .count = n, .x = calloc(5 * n + 1, sizeof *g->x), .label = calloc(n, sizeof(int))};
    if (!g->x || !g->label)
        return false;
    g->N = g->x + n;
    g->t = g->N + n;
    g->slip = g->t + n;
    g->end = g->slip + n;
    return true;
}

void rw_growth_destroy(rw_growth *growth)
{
    free(growth->x);
    free(growth->label);
    *growth = (rw_growth){.count = 0};
}

/* Cells are so much wider away from the start: their ends are powers of whole numbers. */
static const double GRADE = 1.5;

/* The cells of a patch with the start in it, about half of them on either side. */
static void set_ends(rw_growth *g, rw_patch all)
{
    const double left = pow(g->start - all.left, 1 / GRADE),
                 right = pow(all.right - g->start, 1 / GRADE);
    g->scale = pow((left + right) / (double)g->count, GRADE);
    g->before = (size_t)((double)g->count * left / (left + right) + 0.5);
    for (size_t i = 0; i <= g->count; i++) {
        const double away = (double)i - (double)g->before;
        g->end[i] = g->start + copysign(g->scale * pow(fabs(away), GRADE), away);
    }
    for (size_t i = 0; i < g->count; i++)
        g->x[i] = (g->end[i] + g->end[i + 1]) / 2;
}

bool rw_growth_cells(rw_growth *g, double f, size_t count, double start, rw_patch all)
{
    if (!allocate(g, count)) {
        rw_growth_destroy(g);
        return false;
    }
    g->f = f;
    g->start = start;
    set_ends(g, all);
    return true;
}

/* ---- The shear at a place ---- */

static double ratio_of_cell(const rw_growth *g, size_t i)
{
    return g->label[i] != 0 ? g->label[i] : g->t[i] / (g->f * g->N[i]);
}

/* The cell with a place. */
static double cell_of(const rw_growth *g, double x)
{
    const double away = (x - g->start) / g->scale;
    return floor((double)g->before + copysign(pow(fabs(away), 1 / GRADE), away));
}

/* A parabola through three neighbours. */
static double parabola(const double x[3], const double y[3], double at)
{
    const double chord = (y[1] - y[0]) / (x[1] - x[0]), next = (y[2] - y[1]) / (x[2] - x[1]);
    return y[0] + (at - x[0]) * (chord + (at - x[1]) * (next - chord) / (x[2] - x[0]));
}

/* The outermost cells have just come into contact, and are left out: beyond them it goes straight
 * on. */
double rw_growth_ratio(const rw_growth *g, double x)
{
    const double first = (double)g->from + 2, last = (double)g->to - 3;
    const size_t i = (size_t)fmax(first, fmin(last, cell_of(g, x)));
    const double ratio[3] = {ratio_of_cell(g, i - 1), ratio_of_cell(g, i), ratio_of_cell(g, i + 1)};
    const double *at = g->x + i - 1;
    const double sum = x < at[0] ? ratio[0] + (x - at[0]) * (ratio[1] - ratio[0]) / (at[1] - at[0])
                       : x > at[2]
                           ? ratio[2] + (x - at[2]) * (ratio[2] - ratio[1]) / (at[2] - at[1])
                           : parabola(at, ratio, x);
    return fmax(-1, fmin(1, sum));
}

double rw_growth_slip(const rw_growth *g, double x)
{
    const size_t i = (size_t)fmax((double)g->from, fmin((double)g->to - 1, cell_of(g, x)));
    return g->slip[i];
}
