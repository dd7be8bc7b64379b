/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Let dt be the change of traction, x = middle - half cos(theta) and tau = dt half sin(theta) at
 * the N angles theta_i of Chebyshev. The displacement dw is then sum_j K_ij tau_j pi/N, up to a
 * constant, with K_ij = (1/pi) [ln 2 + sum (2/k) cos(k theta_i) cos(k theta_j)]: a function of i -
 * j plus one of i + j. In `matrix` the factor pi/N is included. The sum of tau over N is the load
 * over pi.
 *
 * The method is that of an active set: the places that stick are solved for, together with their
 * rigid move lambda. A place that passes its bound is set to the bound; a place that slips against
 * its traction is released. Each change of the set lowers the energy of a convex problem. In
 * practice 3 to 20 turns are enough. A set that still changes then has places at their bounds to
 * rounding, and either choice will do. */
#include "fronts/grid.h"

#include "base/domain.h"
#include "base/linear.h"
#include "base/processor.h"

#include <stdlib.h>
#include <string.h>

enum { TURNS = 100 };

/* Smaller differences, over the scale of traction and slip, are rounding. */
static const double NOTHING = 1e-12;

/* The matrix K, from sums of cos(pi k d/N)/k. */
bool rw_grid_init(rw_grid *g, int n)
{
    double wave[2 * RW_MOST_ANGLES], cosine[2 * RW_MOST_ANGLES]; /* for i - j and i + j + 1 */
    double per[RW_MOST_ANGLES];
    const size_t places = (size_t)n * (size_t)n;
    g->n = 0;
    g->matrix = malloc(2 * places * sizeof *g->matrix);
    if (!g->matrix)
        return false;
    g->factor = g->matrix + places;
    g->n = n;
    for (int i = 0; i < 2 * n; i++)
        cosine[i] = cos(RW_PI * i / n);
    for (int k = 1; k < n; k++)
        per[k] = 1.0 / k;
    for (int d = 0; d <= n; d++) {
        wave[d] = 0;
        for (int k = 1, turn = d; k < n; k++, turn += turn + d < 2 * n ? d : d - 2 * n)
            wave[d] += cosine[turn] * per[k];
        wave[(2 * n - d) % (2 * n)] = wave[d];
    }
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            g->matrix[i * n + j] = (1 + wave[i > j ? i - j : j - i] + wave[i + j + 1]) / n;
    return true;
}

void rw_grid_destroy(rw_grid *g)
{
    if (g->n > 0)
        free(g->matrix);
}

static double angle_of(const rw_grid *g, int i)
{
    return RW_PI * (i + 0.5) / g->n;
}

/* After full sliding all places stick at first. */
static void release_where_nothing_sticks(rw_grid *g)
{
    for (int i = 0; i < g->n; i++)
        if (g->label[i] == 0)
            return;
    for (int i = 0; i < g->n; i++)
        if (g->label[i] != RW_GONE)
            g->label[i] = 0;
}

static double prepare(rw_grid *g, const rw_problem *p, const rw_layers *layers, double stretch)
{
    double scale = 0, *F = g->upper, *t = g->lower;
    g->middle = rw_patch_middle(p->both);
    g->half = rw_patch_half_width(p->both);
    for (int i = 0; i < g->n; i++)
        g->x[i] = g->middle - g->half * cos(angle_of(g, i));
    rw_friction_after(p, (size_t)g->n, g->x, F);
    for (int i = 0; i < g->n; i += RW_TERMS)
        rw_base_traction(p, layers, RW_TERMS, g->x + i, t + i);
    for (int i = 0; i < g->n; i++) {
        const double x = g->x[i], stretching = g->half * sin(angle_of(g, i));
        const double friction = F[i], base = t[i];
        g->upper[i] = (friction - base) * stretching;
        g->lower[i] = (-friction - base) * stretching;
        g->strain[i] = stretch * (x - p->middle);
        g->label[i] = !(friction > 0)            ? RW_GONE
                      : rw_patch_has(p->from, x) ? rw_zones_label(&p->old->zones, x)
                                                 : 0;
        scale = fmax(scale, fmax(fabs(g->upper[i]), fabs(g->lower[i])));
    }
    release_where_nothing_sticks(g);
    return scale;
}

static double sum_of(int n, const double v[])
{
    double sum = 0;
    for (int i = 0; i < n; i++)
        sum += v[i];
    return sum;
}

/* What the changes of places that stick, or of all others, add to the moves. */
RW_INLINE void add_columns(rw_grid *g, bool sticks)
{
    for (int j = 0; j < g->n; j++)
        if ((g->label[j] == 0) == sticks)
            for (int i = 0; i < g->n; i++)
                g->move[i] += g->matrix[j * g->n + i] * g->change[j];
}

RW_DISPATCH(add_moves, add_columns, (rw_grid * g, bool sticks), (g, sticks))

/* The change of places that slip is at its bound; that of places that stick is set to 0 first. */
static void set_bounds(rw_grid *g)
{
    for (int i = 0; i < g->n; i++)
        g->change[i] = g->label[i] == 1    ? g->upper[i]
                       : g->label[i] == -1 ? g->lower[i]
                       : g->label[i] == 0  ? 0
                                           : (g->upper[i] + g->lower[i]) / 2;
}

/* Solves for the places that stick: they move by lambda, and the sum of all changes carries the
 * load. The moves are those by the changes. */
static bool solve_stuck(rw_grid *g, double load)
{
    const int n = g->n;
    size_t count = 0;
    int place[RW_MOST_ANGLES]; /* those that stick */
    double right[RW_MOST_ANGLES], unit[RW_MOST_ANGLES];
    set_bounds(g);
    memset(g->move, 0, (size_t)n * sizeof *g->move);
    add_moves(g, false);
    for (int i = 0; i < n; i++) {
        if (g->label[i] != 0)
            continue;
        right[count] = -g->strain[i] - g->move[i];
        unit[count] = 1;
        place[count++] = i;
    }
    if (count == 0)
        return false;
    for (size_t i = 0; i < count; i++)
        for (size_t j = 0; j <= i; j++)
            g->factor[i * count + j] = g->matrix[place[i] * n + place[j]];
    rw_cholesky(count, g->factor); /* positive: tractions do work */
    rw_cholesky_solve(count, g->factor, right);
    rw_cholesky_solve(count, g->factor, unit);
    g->multiplier = (load * n / RW_PI - sum_of(n, g->change) - sum_of((int)count, right)) /
                    sum_of((int)count, unit);
    for (size_t i = 0; i < count; i++)
        g->change[place[i]] = right[i] + g->multiplier * unit[i];
    add_moves(g, true);
    return true;
}

/* Between two ways of slip one place sticks at least: after the last one that did, the nearest one
 * that slips the other way. */
static void stick_between(rw_grid *g, int last)
{
    int nearest = last;
    for (int i = 0; i < g->n; i++)
        if (g->label[i] == -g->label[last] &&
            (nearest == last || abs(i - last) < abs(nearest - last)))
            nearest = i;
    g->label[nearest] = 0;
}

/* Relabels the places. Whether no label changed. */
static bool settle(rw_grid *g, double scale)
{
    const double nothing = NOTHING * scale;
    int stuck = 0, last = 0;
    bool is_settled = true;
    for (int i = 0; i < g->n; i++) {
        g->move[i] += g->strain[i] - g->multiplier;
        const int before = g->label[i];
        if (before == 0 && g->change[i] > g->upper[i] + nothing)
            g->label[i] = 1;
        else if (before == 0 && g->change[i] < g->lower[i] - nothing)
            g->label[i] = -1;
        else if ((before == 1 || before == -1) && before * g->move[i] > nothing)
            g->label[i] = 0;
        is_settled = is_settled && g->label[i] == before;
        stuck += g->label[i] == 0;
        last = before == 0 ? i : last;
    }
    if (stuck == 0)
        stick_between(g, last);
    return is_settled;
}

bool rw_grid_solve(rw_grid *g, const rw_problem *p, const rw_layers *layers)
{
    double load, stretch;
    rw_beside_layers(p, layers, &load, &stretch);
    const double scale = prepare(g, p, layers, stretch);
    for (g->turns = 0; g->turns < TURNS; g->turns++) {
        if (!solve_stuck(g, load))
            return false;
        if (settle(g, scale))
            break;
    }
    return true;
}

void rw_grid_zones(const rw_grid *g, const rw_problem *p, rw_zones *zones)
{
    zones->count = 0;
    int last = -1; /* the place before that is in contact */
    for (int i = 0; i < g->n; i++) {
        if (g->label[i] == RW_GONE)
            continue;
        if (last < 0 || g->label[last] != g->label[i]) {
            const double middle = (angle_of(g, i) + angle_of(g, last)) / 2;
            const double from = last < 0 ? p->to.left : g->middle - g->half * cos(middle);
            if (zones->count > 0)
                zones->zone[zones->count - 1].right = from;
            rw_zones_insert(zones, zones->count, (rw_zone){g->label[i], from, p->to.right});
        }
        last = i;
    }
    zones->zone[zones->count - 1].right = p->to.right;
}

static void append_zone(rw_zones *zones, int label, double left, double right)
{
    rw_zone *last = &zones->zone[zones->count - 1];
    if (zones->count > 0 && last->label == label)
        last->right = right;
    else
        rw_zones_insert(zones, zones->count, (rw_zone){label, left, right});
}

void rw_grid_zones_met(const rw_grid *g, const rw_problem *p, rw_zones *zones)
{
    zones->count = 0;
    double at = p->to.left;
    int last = RW_GONE;
    for (int i = 0; i < g->n; i++) {
        const int label = g->label[i];
        if (label == RW_GONE)
            continue;
        append_zone(zones, label == last || last == RW_GONE ? label : 0, at, g->x[i]);
        at = g->x[i];
        last = label;
    }
    append_zone(zones, last, at, p->to.right);
}

/* Linear in the angle between two places, of which it returns the first. */
static int place_of(const rw_grid *g, double x, double *part)
{
    const double cosine = fmax(-1, fmin(1, (g->middle - x) / g->half));
    const double place = acos(cosine) * g->n / RW_PI - 0.5;
    const int i = (int)fmax(0, fmin(g->n - 2, floor(place)));
    *part = fmax(0, fmin(1, place - i));
    return i;
}

double rw_grid_change(const rw_grid *g, double x)
{
    double density[2], part;
    const int i = place_of(g, x, &part);
    for (int k = 0; k < 2; k++)
        density[k] = g->change[i + k] / (g->half * sin(angle_of(g, i + k)));
    return density[0] + part * (density[1] - density[0]);
}

double rw_grid_slip(const rw_grid *g, double x)
{
    double part;
    const int i = place_of(g, x, &part);
    return g->move[i] + part * (g->move[i + 1] - g->move[i]);
}
