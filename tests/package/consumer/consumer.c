/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A program outside the tree; the same text is C and C++. */
#include <rwedge.h>

#include <math.h>
#include <stdio.h>

int main(void)
{
    double limit = 0, x = 0, y = 0, p[3] = {-1, -0.5, -1}, at[3] = {-0.5, 0.9, 0.5};
    rwedge_series *series = NULL;
    if (rwedge_yield_point(1, 0, 0.3, &limit, &x, &y) != RWEDGE_OK || fabs(limit - 4.880036) > 1e-6)
        return 1;
    if (rwedge_series_fit(3, at, p, 2, &series) != RWEDGE_OK) /* LAPACK is there too */
        return 1;
    rwedge_series_destroy(series);
    printf("rwedge %s: P/(bk) = %.6f\n", rwedge_version(), limit);
    return 0;
}
