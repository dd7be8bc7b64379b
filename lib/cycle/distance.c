/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The theory of critical distances: stresses of a cycle below a place of the surface, at half of a
 * length, or their means over twice the length. Means are taken by the rule of tanh-sinh: equal
 * steps of t, distances that crowd towards the ends of the line, where stresses have roots and
 * logarithms. Steps are halved until the means settle. */
#include "cycle/states.h"

#include <stdlib.h>
#include <string.h>

enum { FIRST_LEVEL = 3, LAST_LEVEL = 9 };
static const double T_MAX = 3.6, SETTLED = 1e-11;

/* A line into the half-plane: from a place of the surface, at an angle to the normal, `end`
 * long. */
typedef struct {
    double x, angle, end;
} ray;

typedef struct {
    size_t count;
    double *x, *y, *weight;
} nodes;

static bool make_nodes(int level, const ray *line, nodes *all)
{
    const double step = ldexp(1, -level);
    const int half = (int)(T_MAX / step);
    all->count = (size_t)(2 * half + 1);
    all->x = malloc(3 * all->count * sizeof *all->x);
    if (!all->x)
        return false;
    all->y = all->x + all->count;
    all->weight = all->y + all->count;
    for (size_t i = 0; i < all->count; i++) {
        const double t = step * ((double)i - half), share = 1 / (1 + exp(-RW_PI * sinh(t)));
        all->x[i] = line->x + line->end * share * sin(line->angle);
        all->y[i] = line->end * share * cos(line->angle);
        all->weight[i] = step * RW_PI * cosh(t) * share / (1 + exp(RW_PI * sinh(t)));
    }
    return true;
}

/* The means of sxx, syy, txy for each load. */
static int32_t means(const rwedge_cycle *cycle, int level, const ray *line, double mean[])
{
    nodes at;
    if (!make_nodes(level, line, &at))
        return RWEDGE_ENOMEM;
    double *stress = malloc(3 * cycle->loads.count * at.count * sizeof *stress);
    const int32_t status =
        stress ? rw_cycle_stresses(cycle, at.count, at.x, at.y, stress) : RWEDGE_ENOMEM;
    for (size_t row = 0; row < 3 * cycle->loads.count && status == RWEDGE_OK; row++) {
        mean[row] = 0;
        for (size_t i = 0; i < at.count; i++)
            mean[row] += at.weight[i] * stress[row * at.count + i];
    }
    free(stress);
    free(at.x);
    return status;
}

static bool are_settled(size_t n, const double before[], const double mean[])
{
    double change = 0, largest = 0;
    for (size_t i = 0; i < n; i++) {
        change = fmax(change, fabs(mean[i] - before[i]));
        largest = fmax(largest, fabs(mean[i]));
    }
    return change <= SETTLED * largest;
}

static int32_t settled_means(const rwedge_cycle *cycle, const ray *line, double mean[])
{
    const size_t n = 3 * cycle->loads.count;
    double *before = malloc(n * sizeof *before);
    int32_t status = before ? means(cycle, FIRST_LEVEL, line, mean) : RWEDGE_ENOMEM;
    for (int level = FIRST_LEVEL + 1; status == RWEDGE_OK; level++) {
        memcpy(before, mean, n * sizeof *before);
        status = level > LAST_LEVEL ? RWEDGE_ENOCONV : means(cycle, level, line, mean);
        if (status == RWEDGE_OK && are_settled(n, before, mean))
            break;
    }
    free(before);
    return status;
}

static int32_t stresses_at(const rwedge_cycle *cycle, const ray *line, double stress[])
{
    const double x = line->x + line->end * sin(line->angle), y = line->end * cos(line->angle);
    return rw_cycle_stresses(cycle, 1, &x, &y, stress);
}

double rwedge_critical_distance(double dK_th, double ds0)
{
    if (!rw_is_positive(dK_th) || !rw_is_positive(ds0))
        return NAN;
    const double ratio = dK_th / ds0;
    return ratio * ratio / RW_PI;
}

int32_t rwedge_cycle_below(const rwedge_cycle *cycle, size_t loads, double x, double angle,
                           double length, int32_t line, double sxx[], double syy[], double txy[])
{
    if (!cycle || !sxx || !syy || !txy)
        return RWEDGE_ENULL;
    if (!rw_is_signed(x) || !rw_is_signed(angle) || fabs(angle) > 1.5 || !rw_is_positive(length) ||
        line < 0 || line > 1)
        return RWEDGE_EDOMAIN;
    if (loads != cycle->loads.count || loads > SIZE_MAX / 3 / sizeof *sxx)
        return RWEDGE_ERANGE;
    double *stress = malloc(3 * loads * sizeof *stress);
    if (!stress)
        return RWEDGE_ENOMEM;
    const ray way = {x, angle, line ? 2 * length : length / 2};
    const int32_t status =
        line ? settled_means(cycle, &way, stress) : stresses_at(cycle, &way, stress);
    if (status == RWEDGE_OK) {
        memcpy(sxx, stress, loads * sizeof *sxx);
        memcpy(syy, stress + loads, loads * sizeof *syy);
        memcpy(txy, stress + 2 * loads, loads * sizeof *txy);
    }
    free(stress);
    return status;
}
