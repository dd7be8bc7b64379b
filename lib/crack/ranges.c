/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a cycle changes of K: loads change straight from one to the next, and from the last to the
 * first. While K_I < 0 the crack is taken for closed. */
#include "base/domain.h"
#include "crack/ranges.h"

#include <rwedge.h>

/* Largest and smallest of what was seen. */
typedef struct {
    double most, least;
} span;

static const span NOTHING = {-HUGE_VAL, HUGE_VAL};

static void see(span *seen, double value)
{
    seen->most = fmax(seen->most, value);
    seen->least = fmin(seen->least, value);
}

static double range_of(const span *seen)
{
    return seen->most > seen->least ? seen->most - seen->least : 0;
}

/* K_II where K_I passes 0 between two loads. */
static double passing_of(const rw_cycle_of_K *cycle, size_t here, size_t next)
{
    if (cycle->passing)
        return cycle->passing[here];
    const double share = cycle->I[here] / (cycle->I[here] - cycle->I[next]);
    return (1 - share) * cycle->II[here] + share * cycle->II[next];
}

/* While it is open: K_II, and the largest of sqrt(K_I^2 + K_II^2). A step has its ends, and the
 * place where K_I passes 0. */
static span open_span(const rw_cycle_of_K *cycle, double *K_max)
{
    span open = NOTHING;
    *K_max = 0;
    for (size_t i = 0; i < cycle->loads; i++) {
        const size_t here = i * cycle->stride, next = (i + 1) % cycle->loads * cycle->stride;
        const double I = cycle->I[here], II = cycle->II[here];
        if (I > 0) {
            see(&open, II);
            *K_max = fmax(*K_max, hypot(I, II));
        }
        if ((I > 0) != (cycle->I[next] > 0)) {
            const double passing = passing_of(cycle, here, next);
            see(&open, passing);
            *K_max = fmax(*K_max, fabs(passing));
        }
    }
    return open;
}

rw_crack_range rw_crack_range_of(const rw_cycle_of_K *cycle, int32_t shear)
{
    span I = NOTHING, II = NOTHING;
    for (size_t i = 0; i < cycle->loads; i++) {
        see(&I, cycle->I[i * cycle->stride]);
        see(&II, cycle->II[i * cycle->stride]);
    }
    rw_crack_range range = {.I = fmax(I.most, 0) - fmax(I.least, 0)};
    const span open = open_span(cycle, &range.K_max);
    if (shear != RWEDGE_FACES_MODE_I)
        range.II = range_of(shear == RWEDGE_FACES_FREE ? &II : &open);
    range.R = I.most > 0 ? I.least / I.most : 0;
    return range;
}

bool rw_is_crack_shear(int32_t shear)
{
    return shear >= RWEDGE_FACES_MODE_I && shear <= RWEDGE_FACES_FREE;
}

static bool are_intensities(size_t n, const double K[])
{
    for (size_t i = 0; i < n; i++)
        if (!rw_is_signed(K[i]))
            return false;
    return true;
}

int32_t rwedge_crack_ranges(size_t loads, size_t n, const double K_I[], const double K_II[],
                            int32_t shear, double range_I[], double range_II[], double K_max[],
                            double R[])
{
    if (!K_I || !K_II || !range_I || !range_II || !K_max || !R)
        return RWEDGE_ENULL;
    if (loads == 0 || (n > 0 && loads > SIZE_MAX / n))
        return RWEDGE_ERANGE;
    if (!rw_is_crack_shear(shear) || !are_intensities(loads * n, K_I) ||
        !are_intensities(loads * n, K_II))
        return RWEDGE_EDOMAIN;
    for (size_t j = 0; j < n; j++) {
        const rw_cycle_of_K cycle = {loads, n, K_I + j, K_II + j, NULL};
        const rw_crack_range range = rw_crack_range_of(&cycle, shear);
        range_I[j] = range.I;
        range_II[j] = range.II;
        K_max[j] = range.K_max;
        R[j] = range.R;
    }
    return RWEDGE_OK;
}
