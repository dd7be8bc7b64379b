/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The ball grows from one point. While a point is outside, the smallest ball around that point and
 * the support replaces it: a larger one, so that no support comes twice. Around so few points it is
 * found by trying every choice of those that lie on it, as in the programs of linear type of
 * Matousek, Sharir and Welzl (1996). */
#include "planes/smallest_ball.h"

#include "base/always.h"
#include "base/select.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>

enum { DIMENSIONS = 3, CANDIDATES = RW_SUPPORT + 1 };

/* A point is outside if it is by more than this part of the largest coordinate: a few roundings. */
static const double OUTSIDE = 8 * DBL_EPSILON;

/* Edges whose Gram determinant is this small, relative to their lengths, are dependent. */
static const double DEPENDENT = 1e-24;

static double squared_distance(const rw_point *p, const rw_point *q)
{
    double sum = 0;
    for (int k = 0; k < DIMENSIONS; k++)
        sum += (p->x[k] - q->x[k]) * (p->x[k] - q->x[k]);
    return sum;
}

static size_t farthest(size_t n, const rw_point points[], const rw_point *centre, double *square)
{
    size_t best = 0;
    *square = 0;
    for (size_t i = 0; i < n; i++) {
        const double d = squared_distance(&points[i], centre);
        if (d > *square) {
            *square = d;
            best = i;
        }
    }
    return best;
}

/* ---- The ball through all points of a support ---- */

/* The edges from the first point of the support, their Gram matrix and half their squares. */
typedef struct {
    int size;
    double gram[DIMENSIONS][DIMENSIONS], half[DIMENSIONS];
} edges;

static edges edges_of(const rw_point points[], int count, const size_t support[])
{
    edges e = {.size = count - 1};
    double edge[DIMENSIONS][DIMENSIONS];
    for (int i = 0; i < e.size; i++)
        for (int k = 0; k < DIMENSIONS; k++)
            edge[i][k] = points[support[i + 1]].x[k] - points[support[0]].x[k];
    for (int i = 0; i < e.size; i++) {
        for (int j = 0; j < e.size; j++) {
            e.gram[i][j] = 0;
            for (int k = 0; k < DIMENSIONS; k++)
                e.gram[i][j] += edge[i][k] * edge[j][k];
        }
        e.half[i] = e.gram[i][i] / 2;
    }
    return e;
}

/* Solves gram w = half by Cholesky's elimination; false where the edges are dependent. */
static bool solve(edges *e, double w[DIMENSIONS])
{
    for (int i = 0; i < e->size; i++) {
        const double length = 2 * e->half[i];
        for (int j = 0; j < i; j++) {
            const double factor = e->gram[i][j] / e->gram[j][j];
            for (int k = j; k < e->size; k++)
                e->gram[i][k] -= factor * e->gram[j][k];
            w[i] = (j == 0 ? e->half[i] : w[i]) - factor * w[j];
        }
        if (i == 0)
            w[0] = e->half[0];
        if (!(e->gram[i][i] > DEPENDENT * length))
            return false;
    }
    for (int i = e->size - 1; i >= 0; i--) {
        for (int k = i + 1; k < e->size; k++)
            w[i] -= e->gram[i][k] * w[k];
        w[i] /= e->gram[i][i];
    }
    return true;
}

/* The smallest ball with these points on it; false where it is not the smallest around them. */
static bool ball_through(const rw_point points[], int count, const size_t support[], rw_ball *ball)
{
    edges e = edges_of(points, count, support);
    double w[DIMENSIONS];
    if (!solve(&e, w))
        return false;
    *ball = (rw_ball){.centre = points[support[0]], .count = count};
    double first = 1;
    for (int i = 0; i < count; i++) {
        ball->support[i] = support[i];
        if (i == 0)
            continue;
        ball->weight[i] = w[i - 1];
        first -= w[i - 1];
        if (!(w[i - 1] > 0))
            return false;
        for (int k = 0; k < DIMENSIONS; k++)
            ball->centre.x[k] += w[i - 1] * (points[support[i]].x[k] - points[support[0]].x[k]);
    }
    ball->weight[0] = first;
    ball->radius = sqrt(squared_distance(&ball->centre, &points[support[0]]));
    return first > 0;
}

/* ---- One more point ---- */

static bool holds(const rw_ball *ball, double slack, const rw_point points[], int count,
                  const size_t index[])
{
    for (int i = 0; i < count; i++)
        if (sqrt(squared_distance(&points[index[i]], &ball->centre)) > ball->radius + slack)
            return false;
    return true;
}

/* The smallest ball around the support and one more point, which is on it. False if rounding
 * leaves none that is larger. */
static bool grow(rw_ball *ball, double slack, const rw_point points[], size_t more)
{
    size_t index[CANDIDATES];
    for (int i = 0; i < ball->count; i++)
        index[i] = ball->support[i];
    index[ball->count] = more;
    const int others = ball->count;
    rw_ball candidate;
    const unsigned choices = (1u << others) - (others == RW_SUPPORT); /* not all, and one more */
    for (unsigned choice = 1; ALWAYS(choice < choices); choice++) {   /* one of them is the ball */
        size_t support[CANDIDATES] = {more};
        int count = 1;
        for (int i = 0; i < others; i++)
            if (choice >> i & 1)
                support[count++] = index[i];
        if (ball_through(points, count, support, &candidate) &&
            holds(&candidate, slack, points, others + 1, index)) {
            const bool is_larger = candidate.radius > ball->radius;
            *ball = is_larger ? candidate : *ball;
            return is_larger;
        }
    }
    return false;
}

static double largest_coordinate(size_t n, const rw_point points[])
{
    double largest = 0;
    for (size_t i = 0; i < n; i++)
        for (int k = 0; k < DIMENSIONS; k++)
            largest = rw_larger(largest, fabs(points[i].x[k]));
    return largest;
}

rw_ball rw_smallest_ball(size_t n, const rw_point points[])
{
    const double slack = OUTSIDE * largest_coordinate(n, points);
    rw_ball ball = {.centre = points[0], .count = 1, .support = {0}, .weight = {1}};
    for (;;) {
        double square;
        const size_t more = farthest(n, points, &ball.centre, &square);
        const double distance = sqrt(square);
        if (distance <= ball.radius + slack || !grow(&ball, slack, points, more)) {
            ball.radius = fmax(ball.radius, distance);
            return ball;
        }
    }
}
