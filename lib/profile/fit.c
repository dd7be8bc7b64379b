/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A convex profile is a sum of arcs of one sign: the convex profile nearest to heights is a problem
 * of least squares whose unknowns must not be negative. */
#include "profile/profile.h"

#include "base/domain.h"
#include "rwedge.h"

#include <stdlib.h>

enum { LEAST_HEIGHTS = 8 };

/* Heights in units of their own: t from -1 to 1, h from 0 to 1. */
typedef struct {
    size_t n;
    const double *x, *height;
    double middle, half, lowest, range; /* of x, of the heights */
    double *t, *h;
    rw_compressed *equations;
} scan;

static bool measure(scan *s)
{
    double highest = s->height[0];
    s->lowest = s->height[0];
    for (size_t i = 1; i < s->n; i++) {
        s->lowest = fmin(s->lowest, s->height[i]);
        highest = fmax(highest, s->height[i]);
    }
    s->middle = s->x[0] / 2 + s->x[s->n - 1] / 2;
    s->half = s->x[s->n - 1] / 2 - s->x[0] / 2;
    s->range = highest - s->lowest;
    return rw_is_positive(s->half) && rw_is_positive(s->range);
}

static void forget(scan *s)
{
    free(s->t);
    free(s->h);
    free(s->equations);
}

static bool compress(scan *s)
{
    s->t = malloc(s->n * sizeof *s->t);
    s->h = malloc(s->n * sizeof *s->h);
    s->equations = malloc(sizeof *s->equations);
    if (!s->t || !s->h || !s->equations)
        return false;
    for (size_t i = 0; i < s->n; i++) {
        s->t[i] = (s->x[i] - s->middle) / s->half;
        s->h[i] = (s->height[i] - s->lowest) / s->range;
    }
    rw_compress(s->n, s->t, s->h, s->equations);
    return true;
}

/* ---- Two contacts ---- */

/* Height of the fit at t, in units of its own. */
static double height_at(const rw_arcs *fit, double t)
{
    double begin = -1, h = fit->level, slope = fit->slope;
    for (int32_t j = 0; j < fit->arcs; j++) {
        const double end = 2.0 * fit->knot[j + 1] / RW_CELLS - 1;
        const double u = (j == fit->arcs - 1 || t < end ? t : end) - begin;
        h += u * (slope + fit->rate[j] * u / 2);
        slope += fit->rate[j] * u;
        if (t < end)
            break;
        begin = end;
    }
    return h;
}

/* Means of neighbouring heights leave little of the noise. Where these are above their own convex
 * hull by far more than that, and by more than what is left on the whole, there is a pocket. */
enum { MEANS = 48 };

typedef struct {
    double t[MEANS], h[MEANS];
    double noise; /* of a mean, as neighbours differ */
} means;

static means means_of(const scan *s, const rw_arcs *fit)
{
    means all = {{0}, {0}, 0};
    double before = 0, differences = 0;
    for (size_t k = 0, i = 0; k < MEANS; k++) {
        const size_t first = i, end = s->n * (k + 1) / MEANS;
        double left_over = 0;
        for (; i < end; i++) {
            const double left = s->h[i] - height_at(fit, s->t[i]);
            all.t[k] += s->t[i];
            left_over += left;
            if (i > 0)
                differences += (left - before) * (left - before);
            before = left;
        }
        const double count = (double)(end - first);
        all.t[k] /= count;
        all.h[k] = left_over / count + height_at(fit, all.t[k]);
    }
    all.noise = sqrt(differences / 2 / (double)(s->n - 1) * MEANS / (double)s->n);
    return all;
}

static bool has_pocket(const scan *s, const rw_arcs *fit)
{
    const double NOISES = 8, LEFT_OVERS = 1.5, ROUNDING = 1e-9;
    size_t corner[MEANS];
    double most = 0;
    if (s->n < 4 * MEANS)
        return false;
    const means all = means_of(s, fit);
    for (size_t k = 1; k < MEANS; k++)
        if (!(all.t[k] > all.t[k - 1]))
            return false; /* so many heights at one place tell nothing of their neighbours */
    const size_t corners = rw_hull(MEANS, all.t, all.h, corner);
    for (size_t k = 1; k < corners; k++)
        for (size_t i = corner[k - 1], j = corner[k], m = i + 1; m < j; m++)
            most = fmax(most,
                        all.h[m] - all.h[i] -
                            (all.h[j] - all.h[i]) / (all.t[j] - all.t[i]) * (all.t[m] - all.t[i]));
    const double left_over = sqrt(fit->square / (double)s->n);
    return most > fmax(ROUNDING, fmax(NOISES * all.noise, LEFT_OVERS * left_over));
}

/* ---- The profile ---- */

/* Places that are not needed stand at the end once more: they are arcs of no length. */
static void take_places(const scan *s, const rw_arcs *fit, size_t m, double place[], double slope[])
{
    const double unit = s->range / s->half;
    double own = fit->slope;
    for (size_t i = 0; i < m; i++) {
        const int32_t k = i < (size_t)fit->arcs ? (int32_t)i : fit->arcs;
        if (i > 0 && i <= (size_t)fit->arcs)
            own += fit->rate[i - 1] * 2.0 * (fit->knot[i] - fit->knot[i - 1]) / RW_CELLS;
        place[i] = k == 0           ? s->x[0]
                   : k == fit->arcs ? s->x[s->n - 1]
                                    : s->middle + s->half * (2.0 * fit->knot[k] / RW_CELLS - 1);
        slope[i] = own * unit;
    }
}

static bool is_curved(const rw_arcs *fit)
{
    for (int32_t j = 0; j < fit->arcs; j++)
        if (fit->rate[j] > 0)
            return true;
    return false;
}

size_t rwedge_profile_places(int32_t arcs)
{
    return arcs > 0 && arcs < RW_MOST_ARCS ? (size_t)arcs + 1 : RW_MOST_ARCS + 1;
}

int32_t rwedge_profile_fit(size_t n, const double x[], const double height[], int32_t arcs,
                           size_t m, double place[], double slope[], double *level, double *rms)
{
    if (!x || !height || !place || !slope || !level || !rms)
        return RWEDGE_ENULL;
    if (n < LEAST_HEIGHTS || n > RW_MOST_HEIGHTS || arcs < 0 || arcs > RW_MOST_ARCS || m < 2 ||
        m > RW_MOST_ARCS + 1 || (size_t)arcs + 1 > m || !rw_are_heights(n, x, height, false))
        return RWEDGE_EDOMAIN;
    scan s = {.n = n, .x = x, .height = height};
    if (!measure(&s))
        return RWEDGE_EDOMAIN;
    rw_arcs fit;
    const int32_t most = m - 1 < RW_MOST_ARCS ? (int32_t)(m - 1) : RW_MOST_ARCS;
    int32_t status = compress(&s) ? rw_fit_arcs(s.equations, n, arcs, most, &fit) : RWEDGE_ENOMEM;
    if (status == RWEDGE_OK && (isinf(fit.square) || !is_curved(&fit) || has_pocket(&s, &fit)))
        status = RWEDGE_EABSENT;
    if (status == RWEDGE_OK) {
        take_places(&s, &fit, m, place, slope);
        *level = s.lowest + s.range * fit.level;
        *rms = s.range * sqrt(fit.square / (double)n);
    }
    forget(&s);
    return status;
}
