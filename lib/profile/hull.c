/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The lower convex hull of heights, corner by corner from the left (Andrew's monotone chain). */
#include "profile/profile.h"

#include "base/domain.h"
#include "rwedge.h"

#include <float.h>
#include <stdlib.h>

bool rw_are_heights(size_t n, const double x[], const double height[], bool apart)
{
    for (size_t i = 0; i < n; i++)
        if (!rw_is_signed(x[i]) || !rw_is_signed(height[i]) ||
            (i > 0 && !(apart ? x[i] > x[i - 1] : x[i] >= x[i - 1])))
            return false;
    return true;
}

static double rise(const double x[], const double h[], size_t i, size_t j)
{
    return (h[j] - h[i]) / (x[j] - x[i]);
}

/* Heights in a straight line stay on it to rounding. */
size_t rw_hull(size_t n, const double x[], const double h[], size_t corner[])
{
    size_t count = 0;
    for (size_t i = 0; i < n; i++) {
        while (count > 1) {
            const size_t before = corner[count - 2], last = corner[count - 1];
            const double size = fabs(h[before]) + fabs(h[last]) + fabs(h[i]);
            const double rounding =
                4 * DBL_EPSILON * size / fmin(x[i] - x[last], x[last] - x[before]);
            if (rise(x, h, last, i) >= rise(x, h, before, last) - rounding)
                break;
            count--;
        }
        corner[count++] = i;
    }
    return count;
}

static void take_heights(size_t corners, const size_t corner[], const double x[], const double h[],
                         double hull[])
{
    for (size_t k = 1; k < corners; k++) {
        const size_t from = corner[k - 1], to = corner[k];
        for (size_t i = from + 1; i < to; i++)
            hull[i] = h[from] + rise(x, h, from, to) * (x[i] - x[from]);
        hull[to] = h[to];
    }
    hull[0] = h[0];
}

/* Rounding may have let a slope fall. */
static void take_slopes(size_t corners, const size_t corner[], const double x[], const double h[],
                        double slope[])
{
    for (size_t k = 1; k < corners; k++) {
        double next = rise(x, h, corner[k - 1], corner[k]);
        if (k > 1)
            next = fmax(next, slope[corner[k - 1] - 1]);
        for (size_t i = corner[k - 1]; i < corner[k]; i++)
            slope[i] = next;
    }
}

/* The corners of the hull, which the caller frees; the heights must be a profile's. */
static int32_t find_corners(size_t n, const double x[], const double height[], size_t **corner,
                            size_t *corners)
{
    if (n < 2 || n > RW_MOST_HEIGHTS || !rw_are_heights(n, x, height, true))
        return RWEDGE_EDOMAIN;
    *corner = malloc(n * sizeof **corner);
    if (!*corner)
        return RWEDGE_ENOMEM;
    *corners = rw_hull(n, x, height, *corner);
    return RWEDGE_OK;
}

int32_t rwedge_profile_hull(size_t n, const double x[], const double height[], double hull[])
{
    size_t *corner, corners;
    if (!x || !height || !hull)
        return RWEDGE_ENULL;
    const int32_t status = find_corners(n, x, height, &corner, &corners);
    if (status != RWEDGE_OK)
        return status;
    take_heights(corners, corner, x, height, hull);
    free(corner);
    return RWEDGE_OK;
}

int32_t rwedge_profile_slopes(size_t n, const double x[], const double height[], double place[],
                              double slope[])
{
    size_t *corner, corners;
    if (!x || !height || !place || !slope)
        return RWEDGE_ENULL;
    const int32_t status = find_corners(n, x, height, &corner, &corners);
    if (status != RWEDGE_OK)
        return status;
    take_slopes(corners, corner, x, height, slope);
    free(corner);
    for (size_t i = 1; i < n; i++)
        place[i - 1] = x[i - 1] / 2 + x[i] / 2;
    place[n - 1] = x[n - 1];
    slope[n - 1] = slope[n - 2];
    return RWEDGE_OK;
}
