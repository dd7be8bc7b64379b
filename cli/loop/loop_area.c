/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "loop.h"

#include <math.h>
#include <stdlib.h>

/* The last row is joined to the first. */
double loop_area(const load row[], size_t from, size_t to)
{
    double area = 0;
    for (size_t i = from; i <= to; i++) {
        const load *next = &row[i < to ? i + 1 : from];
        area += (row[i].Q + next->Q) / 2 * (next->displacement - row[i].displacement);
    }
    return area;
}

double loop_area_noise(const load row[], size_t from, size_t to, double noise)
{
    double sum = 0;
    for (size_t i = from; i <= to; i++) {
        const double way =
            row[i < to ? i + 1 : from].displacement - row[i > from ? i - 1 : to].displacement;
        sum += way / 2 * (way / 2);
    }
    return noise * sqrt(sum);
}

/* Of noise of 1 % of Q an area of a fiftieth of the frame around the loop never came. */
static const double NOISE_OF_FRAME = 1. / 50;

bool loop_dissipates(size_t count, const load row[], complaint *why)
{
    const log_cycles cycles = log_cycles_find(count, row, load_displacement);
    double area = 0, frame = 0;
    for (size_t k = 0; k + 1 < cycles.count; k++) {
        double way[] = {HUGE_VAL, -HUGE_VAL}, Q[] = {HUGE_VAL, -HUGE_VAL};
        for (size_t i = cycles.at[k]; i <= cycles.at[k + 1]; i++) {
            way[0] = fmin(way[0], row[i].displacement);
            way[1] = fmax(way[1], row[i].displacement);
            Q[0] = fmin(Q[0], row[i].Q);
            Q[1] = fmax(Q[1], row[i].Q);
        }
        area += loop_area(row, cycles.at[k], cycles.at[k + 1]);
        frame += (way[1] - way[0]) * (Q[1] - Q[0]);
    }
    free(cycles.at);
    return !(area < -NOISE_OF_FRAME * frame) ||
           complain(why,
                    "the loop runs backwards: its area is %.4g a cycle, where friction dissipates; "
                    "--column Q=-Q turns the sign of Q, if it is that on the other body",
                    area / (double)(cycles.count - 1));
}
