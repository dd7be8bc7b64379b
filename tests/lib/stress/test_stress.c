/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "claims.h"
#include "rwedge.h"

CLAIM(surface_is_free_outside)
{
    const double outside[] = {1, -1, 1 + 1e-15, 1.5, -3, 1e9, -1e60};
    for (size_t i = 0; i < sizeof outside / sizeof outside[0]; i++) {
        double s[3];
        assert_ok(rwedge_stress(0.3, 0.5, 0.2, outside[i], 0, &s[0], &s[1], &s[2]));
        assert_within(s[1], 0, 0);
        assert_within(s[2], 0, 0);
    }
}

/* ---- Derivatives ---- */

static int32_t gradient(const double v[5], double d[6])
{
    return rwedge_stress_gradient(v[0], v[1], v[2], v[3], v[4], &d[0], &d[1], &d[2], &d[3], &d[4],
                                  &d[5]);
}

static int32_t sensitivity(const double v[5], double d[9])
{
    return rwedge_stress_sensitivity(v[0], v[1], v[2], v[3], v[4], d, d + 3, d + 6);
}

CLAIM(derivatives_end_at_the_edges)
{
    const double singular[][5] = {
        {0.5, 0.3, 0.7, 1, 0},   {0.5, 0.3, 0.7, -0.5, 0}, {0.5, 0.3, 0.7, 0.7, 0},
        {0, 0.3, 0, 0, 0},       {0.5, 0.3, 2, 0, 1},      {0.5, -1, 0, 0, 1},
        {0.5, 0.3, 0.7, NAN, 1}, {0.5, 0.3, 0.7, 0, -1},
    };
    for (size_t i = 0; i < sizeof singular / sizeof singular[0]; i++) {
        double d[9] = {7, 7, 7, 7, 7, 7, 7, 7, 7};
        assert_int_equal(gradient(singular[i], d), RWEDGE_EDOMAIN);
        assert_int_equal(sensitivity(singular[i], d), RWEDGE_EDOMAIN);
        for (int k = 0; k < 9; k++)
            assert_true(d[k] == 7);
    }
    const double beside[5] = {0.5, 0.3, 0, 0, 0}; /* no stick zone, so no edge of it */
    double d[9];
    assert_ok(gradient(beside, d));
    assert_ok(sensitivity(beside, d));
}

/* Its stick zone grows from 0 as the load does: q changes by a flat punch's force. */
CLAIM(a_sharp_wedge_that_slides_has_the_rates_of_the_smallest_stick_zone)
{
    const double sliding[5] = {0, 0.3, 0, 0.6, 0.4}, soon[5] = {0, 0.3, 1e-9, 0.6, 0.4};
    double d[9], next[9];
    assert_ok(sensitivity(sliding, d));
    assert_ok(sensitivity(soon, next));
    for (int i = 0; i < 9; i++)
        assert_within(d[i], next[i], 1e-8);
}
