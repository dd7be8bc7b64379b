/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Marching squares. A rim of low values around the grid closes every contour. Its points have the
 * coordinates of the border. The contour keeps the higher values on one side. So it leaves each
 * crossed edge into exactly one cell, and one table is enough to follow a loop. */
#include "contour.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

enum { NONE = -1, DONE = -2 };

typedef struct {
    const contour_grid *grid;
    double height;
    int across, down; /* nodes, with the rim */
    /* the edge that follows an edge on a loop; 2 n is the edge from node n to its right, 2 n + 1
     * the one to the node below */
    int *next;
} tracer;

static int clamp(int i, int count)
{
    return i < 1 ? 0 : i > count ? count - 1 : i - 1;
}

static bool on_rim(const tracer *t, int i, int j)
{
    return i == 0 || j == 0 || i == t->across - 1 || j == t->down - 1;
}

static double value_at(const tracer *t, int i, int j)
{
    return t->grid->value[clamp(j, t->grid->rows) * t->grid->columns + clamp(i, t->grid->columns)];
}

static bool is_high(const tracer *t, int i, int j)
{
    return !on_rim(t, i, j) && value_at(t, i, j) >= t->height;
}

/* The corners of a cell in turn; side k is from corner k to k + 1. */
static const int corner_i[] = {0, 1, 1, 0}, corner_j[] = {0, 0, 1, 1};

static int side(const tracer *t, int i, int j, int k)
{
    static const int of_i[] = {0, 1, 0, 0}, of_j[] = {0, 0, 1, 0};
    return 2 * ((j + of_j[k]) * t->across + i + of_i[k]) + (k % 2);
}

/* In a saddle two opposite corners are high. The mean of the four decides whether they are
 * joined. */
static void link_cell(tracer *t, int i, int j)
{
    bool high[4];
    double mean = 0;
    bool rim = false;
    for (int k = 0; k < 4; k++) {
        high[k] = is_high(t, i + corner_i[k], j + corner_j[k]);
        rim = rim || on_rim(t, i + corner_i[k], j + corner_j[k]);
        mean += 0.25 * value_at(t, i + corner_i[k], j + corner_j[k]);
    }
    const bool saddle = high[0] == high[2] && high[1] == high[3] && high[0] != high[1];
    const bool joined = saddle && !rim && mean >= t->height;
    /* The loop leaves through the side k, where the high corners end. It came in through the side
     * where they begin. */
    for (int k = 0; k < 4; k++) {
        if (!high[k] || high[(k + 1) % 4])
            continue;
        int in = (k + 1) % 4; /* joined: the high corners begin behind the next low one */
        if (!joined)
            for (in = (k + 3) % 4; high[in];)
                in = (in + 3) % 4;
        t->next[side(t, i, j, in)] = side(t, i, j, k);
    }
}

static contour_point crossing(const tracer *t, int edge)
{
    const int node = edge / 2, i = node % t->across, j = node / t->across;
    const int k = i + (edge % 2 == 0), l = j + edge % 2;
    const double x0 = t->grid->x[clamp(i, t->grid->columns)],
                 x1 = t->grid->x[clamp(k, t->grid->columns)];
    const double y0 = t->grid->y[clamp(j, t->grid->rows)], y1 = t->grid->y[clamp(l, t->grid->rows)];
    const double v0 = value_at(t, i, j), v1 = value_at(t, k, l);
    const bool border = on_rim(t, i, j) || on_rim(t, k, l);
    const double part = border || v1 == v0 ? 0.5 : (t->height - v0) / (v1 - v0);
    return (contour_point){x0 + part * (x1 - x0), y0 + part * (y1 - y0), border};
}

static double twice_area(const contour_loop *one)
{
    double sum = 0;
    for (size_t i = 0; i < one->count; i++) {
        const contour_point *a = &one->point[i], *b = &one->point[(i + 1) % one->count];
        sum += a->x * b->y - b->x * a->y;
    }
    return sum;
}

static bool add_loop(const tracer *t, int start, int level, contour_loops *loops)
{
    size_t count = 1;
    for (int edge = t->next[start]; edge != start; edge = t->next[edge])
        count++;
    contour_loop *longer = realloc(loops->loop, (loops->count + 1) * sizeof *longer);
    if (longer == NULL)
        return false;
    loops->loop = longer;
    contour_loop *one = &longer[loops->count];
    *one = (contour_loop){.level = level, .point = malloc(count * sizeof *one->point)};
    if (one->point == NULL)
        return false;
    loops->count++;
    for (int edge = start; one->count < count; one->count++) {
        const int next = t->next[edge];
        one->point[one->count] = crossing(t, edge);
        t->next[edge] = DONE;
        edge = next;
    }
    const double area = twice_area(one);
    one->hole = area > 0; /* the higher values are on the right of the path, seen with y upwards */
    one->area = fabs(area);
    return true;
}

bool contour_trace(const contour_grid *grid, double height, int level, contour_loops *loops)
{
    tracer t = {grid, height, grid->columns + 2, grid->rows + 2, NULL};
    const int edges = 2 * t.across * t.down;
    t.next = malloc((size_t)edges * sizeof *t.next);
    if (t.next == NULL)
        return false;
    for (int i = 0; i < edges; i++)
        t.next[i] = NONE;
    for (int j = 0; j + 1 < t.down; j++)
        for (int i = 0; i + 1 < t.across; i++)
            link_cell(&t, i, j);
    bool sound = true;
    for (int i = 0; i < edges && sound; i++)
        if (t.next[i] >= 0)
            sound = add_loop(&t, i, level, loops);
    free(t.next);
    return sound;
}

static int larger_first(const void *one, const void *other)
{
    const contour_loop *a = one, *b = other;
    if (a->area != b->area)
        return a->area > b->area ? -1 : 1;
    return a->level - b->level; /* two levels around the whole grid */
}

void contour_sort(contour_loops *loops)
{
    if (loops->count > 0)
        qsort(loops->loop, loops->count, sizeof *loops->loop, larger_first);
}

void contour_free(contour_loops *loops)
{
    for (size_t i = 0; i < loops->count; i++)
        free(loops->loop[i].point);
    free(loops->loop);
    *loops = (contour_loops){NULL, 0};
}
