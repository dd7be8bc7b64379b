/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "computed/growing_cells.h"

#include "base/domain.h"
#include "base/linear.h"

#include <rwedge.h>
#include <stdlib.h>
#include <string.h>

/* ---- Cells ---- */

typedef struct {
    rw_growth *g;
    const rw_frame *frame;
    rw_scaled_loads rates; /* per load */
    double P, load;        /* all; so far */
    double *gap;           /* between the bodies at each cell, now */
    double *influence;     /* of the traction of a cell on the displacement of another */
    double *dN, *dt;       /* the changes of a step; and of dt what does not depend on the load: */
    double *jump;
    size_t *stuck; /* the cells that stick */
    size_t sticks;
    double d_approach, d_tilt, d_move, d_load;
    double *A, *b;
} work;

/* x ln|x| - x, the integral of the logarithm. */
static double integral_of_log(double x)
{
    return x == 0 ? 0 : x * log(fabs(x)) - x;
}

static double width_of(const work *w, size_t i)
{
    return w->g->end[i + 1] - w->g->end[i];
}

/* On the displacement of the same direction. */
static double along(const work *w, size_t i, size_t j)
{
    return w->influence[i * w->g->count + j];
}

/* On that of the other direction, but for B. */
static double across(const work *w, size_t i, size_t j)
{
    return i > j ? width_of(w, j) : i == j ? width_of(w, j) / 2 : 0;
}

/* The height of a profile, over theta. */
static double height(const rw_arcs *arcs, double x)
{
    double sum = 0;
    for (size_t i = 0; i < arcs->count; i++) {
        const rw_arc arc = rw_arc_at(arcs, i);
        const double middle = arc.left / 2 + arc.right / 2;
        sum += rw_arc_weight(arcs, i) * rw_wedge_height(rw_arc_half_length(arc), fabs(x - middle));
    }
    return sum;
}

static bool allocate(work *w, size_t n)
{
    const size_t most = 2 * n + 4;
    rw_growth *g = w->g;
    *g = (rw_growth){.count = n,
                     .f = w->frame->f,
                     .x = calloc(5 * n + 1, sizeof *g->x),
                     .label = calloc(n, sizeof(int))};
    w->gap = calloc((5 + n) * n + (most + 1) * most, sizeof *w->gap);
    w->stuck = malloc(n * sizeof *w->stuck);
    if (!g->x || !g->label || !w->gap || !w->stuck)
        return false;
    g->N = g->x + n;
    g->t = g->N + n;
    g->slip = g->t + n;
    g->end = g->slip + n;
    w->influence = w->gap + n;
    w->dN = w->influence + n * n;
    w->dt = w->dN + n;
    w->jump = w->dt + n;
    w->b = w->jump + n;
    w->A = w->b + most;
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

static void set_gap(work *w, double tilt)
{
    const rw_growth *g = w->g;
    double least = HUGE_VAL;
    for (size_t i = 0; i < g->count; i++) {
        w->gap[i] = height(&w->frame->arcs, g->x[i]) - tilt * g->x[i];
        least = fmin(least, w->gap[i]);
        for (size_t j = 0; j < g->count; j++)
            w->influence[i * g->count + j] =
                (integral_of_log(g->x[i] - g->end[j + 1]) - integral_of_log(g->x[i] - g->end[j])) /
                RW_PI;
    }
    for (size_t i = 0; i < g->count; i++)
        w->gap[i] -= least;
}

/* The cells of a patch that is the first to touch, at least so many. false where they are not
 * inside of all. */
static bool begin(work *w, rw_patch touching)
{
    enum { LEAST = 4 };
    rw_growth *g = w->g;
    while (g->from < g->count && g->x[g->from] < touching.left)
        g->from++;
    g->to = g->from;
    while (g->to < g->count && g->x[g->to] < touching.right)
        g->to++;
    while (g->to - g->from < LEAST && g->from > 0 && g->to < g->count) {
        const double left = w->gap[g->from - 1], right = w->gap[g->to];
        g->from -= left <= right;
        g->to += right <= left;
    }
    return g->to - g->from >= LEAST;
}

/* ---- One step ---- */

/* Unknowns: dN of the cells in contact, dt of those that stick, and four numbers. */
typedef struct {
    size_t N, t, approach, tilt, move, load, count;
} places;

static places places_of(const work *w)
{
    const size_t cells = w->g->to - w->g->from, t = cells + w->sticks;
    return (places){0, cells, t, t + 1, t + 2, t + 3, t + 4};
}

/* What the shear of a cell that slips has per change of its pressure. */
static double slope(const work *w, size_t i)
{
    return w->frame->f * w->g->label[i];
}

/* The gap at a cell closes. */
static void close_gap(const work *w, size_t i, double row[], double *b)
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
static void stick(const work *w, size_t i, double row[], double *b)
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
static void carry(const work *w, double row_P[], double row_Q[], double row_M[], double *b_Q)
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
static void list_cells(work *w)
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
static void set_equations(work *w, size_t next)
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

static void read_solution(work *w)
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

static bool solve(work *w, size_t next)
{
    list_cells(w);
    set_equations(w, next);
    const bool is_solved = rw_solve(places_of(w).count, 1, w->A, w->b);
    if (is_solved)
        read_solution(w);
    return is_solved;
}

/* The gap at a cell after the step; how far it slips in it. */
static double gap_after(const work *w, size_t i)
{
    double sum = w->gap[i] - w->d_approach - w->d_tilt * w->g->x[i];
    for (size_t j = w->g->from; j < w->g->to; j++)
        sum += along(w, i, j) * w->dN[j] + w->frame->B * across(w, i, j) * w->dt[j];
    return sum;
}

static double slip_of(const work *w, size_t i)
{
    double sum = w->d_load * w->rates.stretch * w->g->x[i] - w->d_move;
    for (size_t j = w->g->from; j < w->g->to; j++)
        sum += along(w, i, j) * w->dt[j] - w->frame->B * across(w, i, j) * w->dN[j];
    return sum;
}

/* Over the peak friction, and over the load: what is rounding. */
static const double ROUNDING = 1e-9, NO_GAP = 1e-11;

static double friction_after(const work *w, size_t i)
{
    return w->frame->f * (w->g->N[i] + w->dN[i]);
}

/* The label that a cell asks for. */
static int label_after(const work *w, size_t i, double rounding)
{
    const int label = w->g->label[i];
    const double t = w->g->t[i] + w->dt[i], friction = friction_after(w, i) + rounding;
    if (label == 0)
        return t > friction ? 1 : t < -friction ? -1 : 0;
    return slip_of(w, i) * label > NO_GAP * w->d_load ? 0 : label;
}

/* The cell that slips least. */
static size_t slowest(const work *w)
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
static bool relabel(work *w, bool one)
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
static void accept(work *w)
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
static bool step(work *w)
{
    rw_growth *g = w->g;
    const bool is_small = g->to - g->from < FEW;
    size_t next = w->gap[g->to] < w->gap[g->from - 1] ? g->to : g->from - 1;
    bool is_changed = true;
    for (int turn = 0; is_changed && !(is_small && turn == TURNS_OF_FEW); turn++) {
        if (turn == MOST_TURNS || !solve(w, next))
            return false;
        const size_t other = next == g->to ? g->from - 1 : g->to;
        if (next < g->count && !(w->load + w->d_load < w->P * (1 - NO_GAP)))
            next = g->count;
        else if (next < g->count && gap_after(w, other) < -NO_GAP * w->P)
            next = other;
        else
            is_changed = relabel(w, turn > AT_ONCE);
    }
    accept(w);
    return true;
}

/* ---- All the way ---- */

/* The part of the line under which the bodies are taken to touch. */
static const double TOUCHES = 0x1p-20;

/* How far the cells reach beyond the contact of similar bodies, over its half-width: it swings by
 * 1.2 |B Q|/P at most. */
static double margin(const rw_frame *frame, rw_scaled_loads to)
{
    return 0.2 + 1.2 * fabs(frame->B * to.shear / to.P);
}

static bool is_inside(const rw_growth *g)
{
    return g->from > 0 && g->to < g->count;
}

/* Cells that closed in the last step carry nothing yet. */
static void drop_empty(rw_growth *g)
{
    while (g->to > g->from && g->N[g->to - 1] == 0)
        g->to--;
    while (g->from < g->to && g->N[g->from] == 0)
        g->from++;
}

/* false where it does not reach the load, or a cell is pulled. */
static bool grow(work *w)
{
    rw_growth *g = w->g;
    while (w->load < w->P * (1 - NO_GAP))
        if (!is_inside(g) || !step(w) || !(w->d_load > 0))
            return false;
    drop_empty(g);
    for (size_t i = g->from; i < g->to; i++)
        if (!(g->N[i] > 0))
            return false;
    return true;
}

/* Sets the cells, with the first in contact. */
static bool set_cells(work *w, rw_scaled_loads to, rw_patch touching, rw_patch last, double beside)
{
    rw_growth *g = w->g;
    const double tilt =
        w->frame->is_held ? to.turn : rw_arcs_pressing(&w->frame->arcs, touching).tilt;
    g->start = rw_patch_middle(touching);
    set_ends(g, (rw_patch){fmin(last.left, touching.left) - beside,
                           fmax(last.right, touching.right) + beside});
    set_gap(w, tilt);
    return begin(w, touching);
}

int32_t rw_growth_create(rw_growth *growth, const rw_frame *frame, rw_scaled_loads from,
                         rw_scaled_loads to, size_t cells)
{
    const rw_patch touching = rw_patch_of_loads(frame, rw_part_of_line(from, to, TOUCHES)),
                   last = rw_patch_of_loads(frame, to);
    const double more = margin(frame, to);
    work w = {.g = growth, .frame = frame, .P = to.P};
    w.rates =
        (rw_scaled_loads){1, to.turn / to.P, to.shear / to.P, (to.stretch - from.stretch) / to.P};
    int32_t status = RWEDGE_ENOMEM;
    if (isnan(touching.left) || isnan(last.left))
        return RWEDGE_ENOCONV;
    if (allocate(&w, 2 * (size_t)((double)cells / 2 * (1 + more))))
        status = set_cells(&w, to, touching, last, more * rw_patch_half_width(last)) && grow(&w)
                     ? RWEDGE_OK
                     : RWEDGE_ENOCONV;
    free(w.gap);
    free(w.stuck);
    if (status != RWEDGE_OK)
        rw_growth_destroy(growth);
    return status;
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
