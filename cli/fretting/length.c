/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "length.h"

#include "text/memory.h"
#include "text/pi.h"

#include <math.h>
#include <stdlib.h>

/* The rule of tanh-sinh: equal steps of t, depths that crowd towards the ends of the line, where
 * stresses have roots and logarithms. Steps are halved until the means settle. */
enum { FIRST_LEVEL = 3, LAST_LEVEL = 9 };
static const double T_MAX = 3.6, SETTLED = 1e-11;

typedef struct {
    size_t count;
    double *x, *y, *weight;
} nodes;

static nodes nodes_of(int level, double x, double end)
{
    const double step = ldexp(1, -level);
    const int half = (int)(T_MAX / step);
    const size_t count = (size_t)(2 * half + 1);
    double *room = memory_resized(NULL, 3 * count * sizeof *room);
    const nodes all = {count, room, room + count, room + 2 * count};
    for (size_t i = 0; i < count; i++) {
        const double t = step * ((double)i - half), share = 1 / (1 + exp(-PI * sinh(t)));
        all.x[i] = x;
        all.y[i] = end * share;
        all.weight[i] = step * PI * cosh(t) * share / (1 + exp(PI * sinh(t)));
    }
    return all;
}

/* Means of sxx, syy, txy of each load. */
static int32_t means(const last_cycle *cycle, int level, double x, double end, double mean[])
{
    const nodes at = nodes_of(level, x, end);
    double *stress = memory_resized(NULL, 3 * cycle->loads * at.count * sizeof *stress);
    const int32_t status = last_cycle_stresses(cycle, at.count, at.x, at.y, stress);
    for (size_t row = 0; row < 3 * cycle->loads && status == RWEDGE_OK; row++) {
        mean[row] = 0;
        for (size_t i = 0; i < at.count; i++)
            mean[row] += at.weight[i] * stress[row * at.count + i];
    }
    free(stress);
    free(at.x);
    return status;
}

static bool is_settled(size_t n, const double before[], const double mean[])
{
    double change = 0, largest = 0;
    for (size_t i = 0; i < n; i++) {
        change = fmax(change, fabs(mean[i] - before[i]));
        largest = fmax(largest, fabs(mean[i]));
    }
    return change <= SETTLED * largest;
}

static int32_t settled_means(const last_cycle *cycle, double x, double end, double mean[])
{
    const size_t n = 3 * cycle->loads;
    double *before = memory_resized(NULL, n * sizeof *before);
    int32_t status = means(cycle, FIRST_LEVEL, x, end, mean);
    for (int level = FIRST_LEVEL + 1; status == RWEDGE_OK; level++) {
        for (size_t i = 0; i < n; i++)
            before[i] = mean[i];
        status = level > LAST_LEVEL ? RWEDGE_ENOCONV : means(cycle, level, x, end, mean);
        if (status == RWEDGE_OK && is_settled(n, before, mean))
            break;
    }
    free(before);
    return status;
}

int32_t length_measure(const last_cycle *cycle, const distance *below, double x, measures *at)
{
    const double depth = below->length / 2;
    double *stress = memory_resized(NULL, 3 * cycle->loads * sizeof *stress);
    int32_t status = below->is_line ? settled_means(cycle, x, 2 * below->length, stress)
                                    : last_cycle_stresses(cycle, 1, &x, &depth, stress);
    if (status == RWEDGE_OK)
        status = last_cycle_criteria(cycle, 1, stress, at);
    free(stress);
    return status;
}
