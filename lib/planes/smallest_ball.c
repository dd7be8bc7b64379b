/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The ball grows from one point. While a point is outside, the smallest ball around that point and
 * the support replaces it: a larger one, so that no support comes twice. Around so few points it is
 * found by trying every choice of those that lie on it, as in the programs of linear type of
 * Matousek, Sharir and Welzl (1996). */
#include "planes/smallest_ball.h"

#include "base/linear.h"
#include "base/select.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>

enum { DIMENSIONS = 3, SUPPORT = 4 };

/* A point is outside if it is by more than this part of the largest coordinate: a few roundings. */
static const double OUTSIDE = 8 * DBL_EPSILON;

/* The points of the support lie on the ball, and no smaller ball is around them. */
typedef struct {
    rw_ball ball;
    int count;
    size_t support[SUPPORT];
} supported;

static size_t farthest(size_t n, const rw_point points[], const rw_point *centre, double *square)
{
    size_t best = 0;
    *square = 0;
    for (size_t i = 0; i < n; i++) {
        const double d = rw_squared_distance(&points[i], centre);
        if (d > *square) {
            *square = d;
            best = i;
        }
    }
    return best;
}

/* ---- The ball through all points of a support ---- */

/* The centre from the first point of the support is a sum of the edges to the others, with these
 * weights; false where the edges are dependent. */
static bool weigh(int size, double edge[][DIMENSIONS], double weight[])
{
    double gram[DIMENSIONS * DIMENSIONS];
    for (int i = 0; i < size; i++) {
        for (int j = 0; j < size; j++) {
            gram[i * size + j] = 0;
            for (int k = 0; k < DIMENSIONS; k++)
                gram[i * size + j] += edge[i][k] * edge[j][k];
        }
        weight[i] = gram[i * size + i] / 2;
    }
    if (!rw_cholesky((size_t)size, gram))
        return false;
    rw_cholesky_solve((size_t)size, gram, weight);
    return true;
}

/* The smallest ball with these points on it; false where it is not the smallest around them. */
static bool ball_through(const rw_point points[], supported *s)
{
    const rw_point *origin = &points[s->support[0]];
    double edge[DIMENSIONS][DIMENSIONS], weight[DIMENSIONS], first = 1;
    for (int i = 1; i < s->count; i++)
        for (int k = 0; k < DIMENSIONS; k++)
            edge[i - 1][k] = points[s->support[i]].x[k] - origin->x[k];
    if (!weigh(s->count - 1, edge, weight))
        return false;
    s->ball.centre = *origin;
    for (int i = 0; i < s->count - 1; i++) {
        if (!(weight[i] > 0))
            return false;
        first -= weight[i];
        for (int k = 0; k < DIMENSIONS; k++)
            s->ball.centre.x[k] += weight[i] * edge[i][k];
    }
    s->ball.radius = sqrt(rw_squared_distance(&s->ball.centre, origin));
    return first > 0;
}

/* ---- One more point ---- */

static bool holds(const rw_ball *ball, double slack, const rw_point points[], const supported *all,
                  size_t more)
{
    for (int i = 0; i <= all->count; i++) {
        const rw_point *p = &points[i < all->count ? all->support[i] : more];
        if (sqrt(rw_squared_distance(p, &ball->centre)) > ball->radius + slack)
            return false;
    }
    return true;
}

/* The smallest ball around the support and one more point, which is on it. False if rounding
 * leaves none that is larger. */
static bool grow(supported *s, double slack, const rw_point points[], size_t more)
{
    const unsigned choices = (1u << s->count) - (s->count == SUPPORT); /* not all, and one more */
    for (unsigned choice = 1; choice < choices; choice++) { /* one is the ball, to rounding */
        supported next = {.count = 1, .support = {more}};
        for (int i = 0; i < s->count; i++)
            if (choice >> i & 1)
                next.support[next.count++] = s->support[i];
        if (ball_through(points, &next) && holds(&next.ball, slack, points, s, more)) {
            const bool is_larger = next.ball.radius > s->ball.radius;
            *s = is_larger ? next : *s;
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
    supported s = {.ball = {.centre = points[0]}, .count = 1};
    for (;;) {
        double square;
        const size_t more = farthest(n, points, &s.ball.centre, &square);
        const double distance = sqrt(square);
        if (distance <= s.ball.radius + slack || !grow(&s, slack, points, more)) {
            s.ball.radius = fmax(s.ball.radius, distance);
            return s.ball;
        }
    }
}
