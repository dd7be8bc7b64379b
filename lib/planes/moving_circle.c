/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "planes/moving_circle.h"

static rw_vector mean_rate(const rw_ball *ball, const rw_vector rate[])
{
    rw_vector mean = {0, 0};
    for (int i = 0; i < ball->count; i++) {
        mean.x += ball->weight[i] * rate[i].x;
        mean.y += ball->weight[i] * rate[i].y;
    }
    return mean;
}

/* The rate of the centre with which its distances to the points of the support change alike. For
 * one point, or two opposite ones, it is the mean of their rates. */
static rw_vector rate_of_centre(const rw_ball *ball, const rw_point points[],
                                const rw_vector rate[])
{
    if (ball->count < 3)
        return mean_rate(ball, rate);
    double xx = 0, xy = 0, yy = 0, common = 0;
    rw_vector right = {0, 0}, out[RW_SUPPORT];
    for (int i = 0; i < ball->count; i++) {
        const rw_point *p = &points[ball->support[i]];
        out[i] = (rw_vector){(p->x[0] - ball->centre.x[0]) / ball->radius,
                             (p->x[1] - ball->centre.x[1]) / ball->radius};
        common += ball->weight[i] * (out[i].x * rate[i].x + out[i].y * rate[i].y);
    }
    for (int i = 0; i < ball->count; i++) {
        const double along = out[i].x * rate[i].x + out[i].y * rate[i].y - common;
        xx += out[i].x * out[i].x, xy += out[i].x * out[i].y, yy += out[i].y * out[i].y;
        right.x += out[i].x * along, right.y += out[i].y * along;
    }
    const double determinant = xx * yy - xy * xy;
    return (rw_vector){(yy * right.x - xy * right.y) / determinant,
                       (xx * right.y - xy * right.x) / determinant};
}

rw_circle rw_circle_of(rw_plane_cycle *cycle, size_t n)
{
    for (size_t i = 0; i < n; i++)
        cycle->point[i] = (rw_point){{cycle->local[i].at.x, cycle->local[i].at.y, 0}};
    rw_circle c = {.ball = rw_smallest_ball(n, cycle->point)};
    rw_vector by_chi[RW_SUPPORT], by_beta[RW_SUPPORT];
    for (int i = 0; i < c.ball.count; i++) {
        by_chi[i] = cycle->local[c.ball.support[i]].by_chi;
        by_beta[i] = cycle->local[c.ball.support[i]].by_beta;
    }
    c.by_chi = rate_of_centre(&c.ball, cycle->point, by_chi);
    c.by_beta = rate_of_centre(&c.ball, cycle->point, by_beta);
    return c;
}
