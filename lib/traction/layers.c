/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "traction/layers.h"

#include "base/domain.h"

/* Coefficients of A u^k + sum_(j<k) u^(k-1-j) m_j/(pi half), with A the tilt and m_j the
 * moments. */
static double coefficient(rw_power_scale scale, double tilt, const double moment[], int k, int n)
{
    return n == k ? tilt : moment[k - 1 - n] / (RW_PI * scale.half);
}

/* Horner's rule gives powers of the place in the patch. */
rw_layer_rest rw_layer_rest_of(rw_power_scale scale, rw_patch patch, double tilt,
                               const double moment[], int k)
{
    const double off = (rw_patch_middle(patch) - scale.middle) / scale.half;
    const double stretch = rw_patch_half_width(patch) / scale.half;
    rw_layer_rest rest = {.patch = patch};
    for (int n = k; n >= 0; n--) {
        for (int i = k - n; i > 0; i--)
            rest.c[i] = off * rest.c[i] + stretch * rest.c[i - 1];
        rest.c[0] = off * rest.c[0] + coefficient(scale, tilt, moment, k, n);
    }
    return rest;
}

/* The slopes 1, v, v^2, v^3 have the pressures sqrt(1 - v^2) times 0, 1, v, v^2 + 1/2. */
double rw_layer_rest_pressure(const rw_layer_rest *rest, double x)
{
    const double v = (x - rw_patch_middle(rest->patch)) / rw_patch_half_width(rest->patch);
    return rest->c[1] + rest->c[3] / 2 + v * (rest->c[2] + v * rest->c[3]);
}

rw_pressing rw_layer_rest_pressing(const rw_layer_rest *rest)
{
    return (rw_pressing){.load = RW_HALF_PI * rw_patch_half_width(rest->patch) *
                                 (rest->c[1] + 0.75 * rest->c[3]),
                         .tilt = rest->c[0] + rest->c[2] / 2};
}
