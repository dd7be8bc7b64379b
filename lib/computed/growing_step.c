/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "computed/growing_step.h"

#include "base/domain.h"
#include "base/linear.h"

#include <stdlib.h>
#include <string.h>

/* ---- What cells do to each other ---- */

/* x ln|x| - x, the integral of the logarithm. */
static double integral_of_log(double x)
{
    return x == 0 ? 0 : x * log(fabs(x)) - x;
}

static void set_influence(rw_growing *w)
{
    const rw_growth *g = w->g;
    for (size_t i = 0; i < g->count; i++)
        for (size_t j = 0; j < g->count; j++)
            w->influence[i * g->count + j] =
                (integral_of_log(g->x[i] - g->end[j + 1]) - integral_of_log(g->x[i] - g->end[j])) /
                RW_PI;
}

bool rw_growing_create(rw_growing *w)
{
    const size_t n = w->g->count, most = 2 * n + 4;
    w->gap = calloc((5 + n) * n + (most + 1) * most, sizeof *w->gap);
    w->stuck = malloc(n * sizeof *w->stuck);
    if (!w->gap || !w->stuck)
        return false;
    w->influence = w->gap + n;
    w->dN = w->influence + n * n;
    w->dt = w->dN + n;
    w->jump = w->dt + n;
    w->b = w->jump + n;
    w->A = w->b + most;
    set_influence(w);
    return true;
}

void rw_growing_destroy(rw_growing *w)
{
    free(w->gap);
    free(w->stuck);
}

static double width_of(const rw_growing *w, size_t i)
{
    return w->g->end[i + 1] - w->g->end[i];
}

/* What the traction of cell j displaces at cell i, in its own direction. */
static double along(const rw_growing *w, size_t i, size_t j)
{
    return w->influence[i * w->g->count + j];
}

/* In the other direction, but for B. */
static double across(const rw_growing *w, size_t i, size_t j)
{
    return i > j ? width_of(w, j) : i == j ? width_of(w, j) / 2 : 0;
}

/* ---- The equations ---- */

/* Unknowns: dN of the cells in contact, dt of those that stick, and four numbers. */
typedef struct {
    size_t N, t, approach, tilt, move, load, count;
} places;

static places places_of(const rw_growing *w)
{
    const size_t cells = w->g->to - w->g->from, t = cells + w->sticks;
    return (places){0, cells, t, t + 1, t + 2, t + 3, t + 4};
}

/* What the shear of a cell that slips has per change of its pressure. */
static double slope(const rw_growing *w, size_t i)
{
    return w->frame->f * w->g->label[i];
}

/* The gap at a cell closes. */
static void close_gap(const rw_growing *w, size_t i, double row[], double *b)
{
    const places at = places_of(w);
    const double B = w->frame->B;
    *b = -w->gap[i];
    for (size_t j = w->g->from; j < w->g->to; j++) {
        row[at.N + j - w->g->from] = along(w, i, j) + B * across(w, i, j) * slope(w, j);
        *b -= B * across(w, i, j) * w->jump[j];
    }
    for (size_t k = 0; k < w->sticks; k++)
        row[at.t + k] = B * across(w, i, w->stuck[k]);
    row[at.approach] = -1;
    row[at.tilt] = -w->g->x[i];
}

/* A cell sticks. */
static void stick(const rw_growing *w, size_t i, double row[], double *b)
{
    const places at = places_of(w);
    *b = 0;
    for (size_t j = w->g->from; j < w->g->to; j++) {
        row[at.N + j - w->g->from] = along(w, i, j) * slope(w, j) - w->frame->B * across(w, i, j);
        *b -= along(w, i, j) * w->jump[j];
    }
    for (size_t k = 0; k < w->sticks; k++)
        row[at.t + k] = along(w, i, w->stuck[k]);
    row[at.move] = -1;
    row[at.load] = w->rates.stretch * w->g->x[i];
}

/* The loads, each with what the cells carry: P, Q, the moment or no rotation. */
static void carry(const rw_growing *w, double row_P[], double row_Q[], double row_M[], double *b_Q)
{
    const places at = places_of(w);
    const rw_growth *g = w->g;
    *b_Q = 0;
    for (size_t j = g->from; j < g->to; j++) {
        const size_t k = at.N + j - g->from;
        row_P[k] = width_of(w, j);
        row_Q[k] = width_of(w, j) * slope(w, j);
        row_M[k] = w->frame->is_held ? 0 : width_of(w, j) * g->x[j];
        *b_Q -= width_of(w, j) * w->jump[j];
    }
    for (size_t k = 0; k < w->sticks; k++)
        row_Q[at.t + k] = width_of(w, w->stuck[k]);
    row_P[at.load] = -1;
    row_Q[at.load] = -w->rates.shear;
    if (w->frame->is_held)
        row_M[at.tilt] = 1;
    else
        row_M[at.load] = -w->rates.turn;
}

/* Which cells stick, and what the others lack to friction. */
static void list_cells(rw_growing *w)
{
    const rw_growth *g = w->g;
    w->sticks = 0;
    for (size_t i = g->from; i < g->to; i++) {
        if (g->label[i] == 0)
            w->stuck[w->sticks++] = i;
        w->jump[i] = g->label[i] == 0 ? 0 : slope(w, i) * g->N[i] - g->t[i];
    }
}

/* Until the gap at a cell closes too, or to the end, next == count. */
static void set_equations(rw_growing *w, size_t next)
{
    const rw_growth *g = w->g;
    const size_t n = places_of(w).count;
    double *row = w->A, *b = w->b;
    memset(w->A, 0, n * n * sizeof *w->A);
    memset(w->b, 0, n * sizeof *w->b);
    for (size_t i = g->from; i < g->to; i++, row += n)
        close_gap(w, i, row, b++);
    for (size_t k = 0; k < w->sticks; k++, row += n)
        stick(w, w->stuck[k], row, b++);
    carry(w, row, row + n, row + 2 * n, b + 1);
    if (next < g->count)
        close_gap(w, next, row + 3 * n, b + 3);
    else {
        row[3 * n + places_of(w).load] = 1;
        b[3] = w->P - w->load;
    }
}

static void read_solution(rw_growing *w)
{
    const rw_growth *g = w->g;
    const places at = places_of(w);
    for (size_t i = g->from; i < g->to; i++) {
        w->dN[i] = w->b[at.N + i - g->from];
        w->dt[i] = w->jump[i] + slope(w, i) * w->dN[i];
    }
    for (size_t k = 0; k < w->sticks; k++)
        w->dt[w->stuck[k]] = w->b[at.t + k];
    w->d_approach = w->b[at.approach];
    w->d_tilt = w->b[at.tilt];
    w->d_move = w->b[at.move];
    w->d_load = w->b[at.load];
}

static bool solve(rw_growing *w, size_t next)
{
    list_cells(w);
    set_equations(w, next);
    const bool is_solved = rw_solve(places_of(w).count, 1, w->A, w->b);
    if (is_solved)
        read_solution(w);
    return is_solved;
}

/* The gap at a cell after the step; how far it slips in it. */
static double gap_after(const rw_growing *w, size_t i)
{
    double sum = w->gap[i] - w->d_approach - w->d_tilt * w->g->x[i];
    for (size_t j = w->g->from; j < w->g->to; j++)
        sum += along(w, i, j) * w->dN[j] + w->frame->B * across(w, i, j) * w->dt[j];
    return sum;
}

static double slip_of(const rw_growing *w, size_t i)
{
    double sum = w->d_load * w->rates.stretch * w->g->x[i] - w->d_move;
    for (size_t j = w->g->from; j < w->g->to; j++)
        sum += along(w, i, j) * w->dt[j] - w->frame->B * across(w, i, j) * w->dN[j];
    return sum;
}

/* Over the peak friction, and over the load: what is rounding. */
static const double ROUNDING = 1e-9, NO_GAP = 1e-11;

bool rw_growing_is_done(const rw_growing *w, double load)
{
    return !(load < w->P * (1 - NO_GAP));
}

static double friction_after(const rw_growing *w, size_t i)
{
    return w->frame->f * (w->g->N[i] + w->dN[i]);
}

/* The label that a cell asks for. */
static int label_after(const rw_growing *w, size_t i, double rounding)
{
    const int label = w->g->label[i];
    const double t = w->g->t[i] + w->dt[i], friction = friction_after(w, i) + rounding;
    if (label == 0)
        return t > friction ? 1 : t < -friction ? -1 : 0;
    return slip_of(w, i) * label > NO_GAP * w->d_load ? 0 : label;
}

/* The cell that slips least. */
static size_t slowest(const rw_growing *w)
{
    size_t best = w->g->from;
    double least = HUGE_VAL;
    for (size_t i = w->g->from; i < w->g->to; i++) {
        const double slip = w->g->label[i] == 0 ? HUGE_VAL : fabs(slip_of(w, i));
        if (slip < least) {
            least = slip;
            best = i;
        }
    }
    return best;
}

/* Changes labels that are wrong, all or the first one. Whether there are any. */
static bool relabel(rw_growing *w, bool one)
{
    rw_growth *g = w->g;
    const size_t next = slowest(w);
    double peak = 0;
    size_t changes = 0, sticks = 0;
    for (size_t i = g->from; i < g->to; i++)
        peak = fmax(peak, friction_after(w, i));
    for (size_t i = g->from; i < g->to; i++) {
        const int label = one && changes > 0 ? g->label[i] : label_after(w, i, ROUNDING * peak);
        changes += label != g->label[i];
        sticks += label == 0;
        g->label[i] = label;
    }
    if (sticks == 0) /* below full sliding some cell does */
        g->label[next] = 0;
    return changes > 0;
}

/* Takes the step over. */
static void accept(rw_growing *w)
{
    rw_growth *g = w->g;
    for (size_t i = g->from; i < g->to; i++) {
        const double slip = g->label[i] == 0 ? 0 : slip_of(w, i);
        g->slip[i] += slip;
        g->energy += width_of(w, i) * fabs(slip * (g->t[i] + w->dt[i] / 2));
    }
    for (size_t i = 0; i < g->count; i++)
        w->gap[i] = i >= g->from && i < g->to ? 0 : gap_after(w, i);
    for (size_t i = g->from; i < g->to; i++) {
        g->N[i] += w->dN[i];
        g->t[i] += w->dt[i];
    }
    w->load += w->d_load;
    if (w->gap[g->to] < NO_GAP * w->P) {
        g->label[g->to] = g->label[g->to - 1];
        g->to++;
    }
    if (w->gap[g->from - 1] < NO_GAP * w->P) {
        g->label[g->from - 1] = g->label[g->from];
        g->from--;
    }
}

/* Tries with all labels that are wrong at once, and then with one after another. Of few cells, too
 * few for three zones of slip and stick, no labels may be right: they are soon a small part. */
enum { AT_ONCE = 20, MOST_TURNS = 200, FEW = 16, TURNS_OF_FEW = 60 };

/* To the next cell, or to the end. */
bool rw_growing_step(rw_growing *w)
{
    rw_growth *g = w->g;
    const bool is_small = g->to - g->from < FEW;
    size_t next = w->gap[g->to] < w->gap[g->from - 1] ? g->to : g->from - 1;
    bool is_changed = true;
    for (int turn = 0; is_changed && !(is_small && turn == TURNS_OF_FEW); turn++) {
        if (turn == MOST_TURNS || !solve(w, next))
            return false;
        const size_t other = next == g->to ? g->from - 1 : g->to;
        if (next < g->count && rw_growing_is_done(w, w->load + w->d_load))
            next = g->count;
        else if (next < g->count && gap_after(w, other) < -NO_GAP * w->P)
            next = other;
        else
            is_changed = relabel(w, turn > AT_ONCE);
    }
    accept(w);
    return true;
}
