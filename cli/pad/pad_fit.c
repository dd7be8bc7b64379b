/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pad.h"

#include "text/text.h"

#include <math.h>
#include <stdlib.h>

double pad_fit_residue(const pad_profile *profile, double left, double right, double *x)
{
    double most = 0;
    *x = left;
    for (size_t i = 0; i < profile->scanned; i++)
        if (profile->scan_x[i] >= left && profile->scan_x[i] <= right &&
            fabs(profile->above[i]) > most) {
            most = fabs(profile->above[i]);
            *x = profile->scan_x[i];
        }
    return most;
}

/* The arc before a place: from the place i - 1 to the place i. */
static double rate_before(const pad_profile *profile, size_t i)
{
    return (profile->slope[i] - profile->slope[i - 1]) / (profile->x[i] - profile->x[i - 1]);
}

static double lobe(double inner, double edge, double rate, double rate_beside)
{
    return rate > rate_beside ? rate * (edge - inner) * (edge - inner) / 2 : HUGE_VAL;
}

double pad_fit_lobe(const pad_profile *profile, double left, double right, bool is_right)
{
    const double *x = profile->x;
    const size_t last = profile->count - 1;
    for (size_t i = 1; i < last; i++) {
        const double before = rate_before(profile, i), after = rate_before(profile, i + 1);
        if (!(x[i] > left && x[i] < right))
            continue;
        if (!is_right)
            return left >= x[i - 1] ? lobe(x[i], left, before, after) : HUGE_VAL;
        if (right <= x[i + 1])
            return lobe(x[i], right, after, before);
    }
    return HUGE_VAL;
}

bool pad_fit_again(const pad_profile *profile, int32_t arcs, pad_profile *to)
{
    double *height = memory_zeroed(profile->scanned, sizeof *height);
    int64_t *line = memory_zeroed(profile->scanned, sizeof *line);
    for (size_t i = 0; i < profile->scanned; i++)
        height[i] = profile->above[i] + pad_profile_height(profile, profile->scan_x[i]);
    const scan heights = {profile->scanned, profile->scan_x, height, line};
    const profile_making how = {.fits = true, .arcs = arcs};
    profile_remark remark = {0, ""};
    *to = (pad_profile){0};
    const bool done = pad_profile_of_heights(&heights, &how, to, &remark);
    free(height);
    free(line);
    return done && to->arcs == arcs;
}
