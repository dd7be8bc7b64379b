/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The ball grows from one point. While a point is outside, the smallest ball around that point and
 * the support replaces it: a larger one, so that no support comes twice. Around so few points it is
 * found by trying every choice of those that lie on it, as in the programs of linear type of
 * Matousek, Sharir and Welzl (1996). */
#include "planes/smallest_ball.h"

#include "base/linear.h"
#include "base/processor.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>

enum { DIMENSIONS = 3 };

/* A point is outside if it is by more than this part of the largest coordinate: a few roundings. */
static const double OUTSIDE = 8 * DBL_EPSILON;

RW_INLINE void square_all(size_t n, const rw_point *restrict points, const rw_point *centre,
                          double *restrict squares)
{
    const rw_point from = *centre;
    for (size_t i = 0; i < n; i++)
        squares[i] = rw_squared_distance(&points[i], &from);
}

RW_DISPATCH(square_distances, square_all,
            (size_t n, const rw_point points[], const rw_point *centre, double squares[]),
            (n, points, centre, squares))

static size_t farthest(size_t n, const rw_point points[], const rw_point *centre, double *square)
{
    enum { BLOCK = 64 };
    double squares[BLOCK];
    size_t best = 0;
    *square = 0;
    for (size_t first = 0; first < n; first += BLOCK) {
        const size_t count = n - first < BLOCK ? n - first : BLOCK;
        square_distances(count, points + first, centre, squares);
        for (size_t i = 0; i < count; i++)
            if (squares[i] > *square) {
                *square = squares[i];
                best = first + i;
            }
    }
    return best;
}

/* ---- The ball through all points of a support ---- */

/* The centre from the first point of the support is a sum of the edges to the others, with these
 * weights; false where the edges are dependent. Where the centre is on x[2] = 0, the edges are
 * too: a point then lies on the ball with the square of its height besides. */
static bool weigh(int dimensions, int size, double edge[][DIMENSIONS], const double rise[],
                  double weight[])
{
    double gram[DIMENSIONS * DIMENSIONS];
    for (int i = 0; i < size; i++) {
        for (int j = 0; j < size; j++) {
            gram[i * size + j] = 0;
            for (int k = 0; k < dimensions; k++)
                gram[i * size + j] += edge[i][k] * edge[j][k];
        }
        weight[i] = (gram[i * size + i] + rise[i]) / 2;
    }
    if (!rw_cholesky((size_t)size, gram))
        return false;
    rw_cholesky_solve((size_t)size, gram, weight);
    return true;
}

/* The space in which the centre may be, and the ball so far. */
typedef struct {
    int dimensions;
    const rw_point *points;
    double slack;
    rw_ball ball;
} growth;

static double rise_above(const growth *g, const rw_point *p, const rw_point *origin)
{
    return g->dimensions == DIMENSIONS ? 0 : (p->x[2] - origin->x[2]) * (p->x[2] + origin->x[2]);
}

/* The smallest ball with the points of its support on it; false where it is not the smallest around
 * them. */
static bool ball_through(const growth *g, rw_ball *ball)
{
    const rw_point *origin = &g->points[ball->support[0]];
    double edge[DIMENSIONS][DIMENSIONS], rise[DIMENSIONS], *weight = ball->weight + 1, first = 1;
    for (int i = 1; i < ball->count; i++) {
        const rw_point *p = &g->points[ball->support[i]];
        for (int k = 0; k < g->dimensions; k++)
            edge[i - 1][k] = p->x[k] - origin->x[k];
        rise[i - 1] = rise_above(g, p, origin);
    }
    if (!weigh(g->dimensions, ball->count - 1, edge, rise, weight))
        return false;
    ball->centre = *origin;
    if (g->dimensions < DIMENSIONS)
        ball->centre.x[2] = 0;
    for (int i = 0; i < ball->count - 1; i++) {
        if (!(weight[i] > 0))
            return false;
        first -= weight[i];
        for (int k = 0; k < g->dimensions; k++)
            ball->centre.x[k] += weight[i] * edge[i][k];
    }
    ball->radius = sqrt(rw_squared_distance(&ball->centre, origin));
    ball->weight[0] = first;
    return first > 0;
}

/* ---- One more point ---- */

static bool holds(const growth *g, const rw_ball *ball, size_t more)
{
    for (int i = 0; i <= g->ball.count; i++) {
        const rw_point *p = &g->points[i < g->ball.count ? g->ball.support[i] : more];
        if (sqrt(rw_squared_distance(p, &ball->centre)) > ball->radius + g->slack)
            return false;
    }
    return true;
}

/* The smallest ball around the support and one more point, which is on it. False if rounding
 * leaves none that is larger. */
static bool grow(growth *g, size_t more)
{
    const int most = g->dimensions + 1; /* points on the ball */
    /* the one point alone has a ball where its centre must be below it */
    const unsigned first = g->dimensions < DIMENSIONS ? 0 : 1;
    for (unsigned choice = first; choice < 1u << g->ball.count; choice++) {
        rw_ball next = {.count = 1, .support = {more}};
        for (int i = 0; i < g->ball.count; i++)
            if (choice >> i & 1 && next.count < RW_BALL_SUPPORT)
                next.support[next.count++] = g->ball.support[i];
        if (next.count <= most && ball_through(g, &next) && holds(g, &next, more)) {
            const bool is_larger = next.radius > g->ball.radius;
            g->ball = is_larger ? next : g->ball;
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

static rw_ball smallest_ball(int dimensions, size_t n, const rw_point points[])
{
    growth g = {
        dimensions, points, OUTSIDE * largest_coordinate(n, points), {.count = 1, .support = {0}}};
    ball_through(&g, &g.ball); /* one point */
    for (;;) {
        double square;
        const size_t more = farthest(n, points, &g.ball.centre, &square);
        const double distance = sqrt(square);
        if (distance <= g.ball.radius + g.slack || !grow(&g, more)) {
            g.ball.radius = fmax(g.ball.radius, distance);
            return g.ball;
        }
    }
}

rw_ball rw_smallest_ball(size_t n, const rw_point points[])
{
    return smallest_ball(DIMENSIONS, n, points);
}

rw_ball rw_smallest_mirrored_ball(size_t n, const rw_point points[])
{
    return smallest_ball(DIMENSIONS - 1, n, points);
}
