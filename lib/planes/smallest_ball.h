/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The smallest ball around points in three dimensions; around points of a plane, it is the smallest
 * circle. */
#ifndef RW_SMALLEST_BALL_H
#define RW_SMALLEST_BALL_H

#include <stddef.h>

typedef struct {
    double x[3];
} rw_point;

/* The centre is the mean of the points on the ball, with the weights, which are positive. */
enum { RW_BALL_SUPPORT = 4 };
typedef struct {
    rw_point centre;
    double radius; /* to the farthest point: no point is outside */
    int count;     /* of the points on the ball */
    size_t support[RW_BALL_SUPPORT];
    double weight[RW_BALL_SUPPORT];
} rw_ball;

static inline double rw_squared_distance(const rw_point *p, const rw_point *q)
{
    double sum = 0;
    for (int k = 0; k < 3; k++)
        sum += (p->x[k] - q->x[k]) * (p->x[k] - q->x[k]);
    return sum;
}

/* The ball of n >= 1 points, whose coordinates are between -1e30 and 1e30. Its radius and centre
 * err by less than 32 epsilon of the largest coordinate. The time grows like n. */
rw_ball rw_smallest_ball(size_t n, const rw_point points[]);

/* The same of the points and their mirror images on the other side of x[2] = 0, where the centre
 * then is. Of a point and its image on the ball only the point is counted, with both weights. */
rw_ball rw_smallest_mirrored_ball(size_t n, const rw_point points[]);

#endif
