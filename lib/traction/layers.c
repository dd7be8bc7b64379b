/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "traction/layers.h"

#include "base/domain.h"

/* The slope of layer k in powers of u = (x - m)/s, m the middle and s the half-width of the
 * patch. */
static void slope_of(rw_power_scale scale, rw_patch patch, int k, double c[])
{
    const double off = (rw_patch_middle(patch) - scale.middle) / scale.half;
    const double stretch = rw_patch_half_width(patch) / scale.half;
    c[0] = 1;
    for (int n = 1; n <= k + 1; n++) {
        c[n] = c[n - 1] * stretch;
        for (int i = n - 1; i > 0; i--)
            c[i] = off * c[i] + stretch * c[i - 1];
        c[0] *= off;
    }
}

/* The slopes 1, u, u^2, u^3, u^4 have the pressures sqrt(1 - u^2) times 0, 1, u, u^2 + 1/2, u^3 +
 * u/2. */
double rw_power_pressure(rw_power_scale scale, rw_patch patch, int k, double x)
{
    double c[RW_LAYERS + 1] = {0};
    slope_of(scale, patch, k, c);
    const double u = (x - rw_patch_middle(patch)) / rw_patch_half_width(patch);
    return c[1] + c[3] / 2 + u * (c[2] + c[4] / 2 + u * (c[3] + u * c[4]));
}

rw_pressing rw_power_pressing(rw_power_scale scale, rw_patch patch, int k)
{
    double c[RW_LAYERS + 1] = {0};
    slope_of(scale, patch, k, c);
    return (rw_pressing){.load = RW_HALF_PI * rw_patch_half_width(patch) * (c[1] + 0.75 * c[3]),
                         .tilt = c[0] + c[2] / 2 + 0.375 * c[4]};
}
