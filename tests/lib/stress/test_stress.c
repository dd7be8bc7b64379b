/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "claims.h"
#include "quadrature.h"
#include "rwedge.h"

/* The largest error of a component over the larger of the tensor's norm and 1/(1+|z|): what the
 * header promises about. */
static double relative_error(const double stress[3], const double expected[3], double x, double y)
{
    const double norm =
        sqrt(expected[0] * expected[0] + expected[1] * expected[1] + 2 * expected[2] * expected[2]);
    double worst = 0;
    for (int i = 0; i < 3; i++)
        worst = fmax(worst, fabs(stress[i] - expected[i]));
    return worst / fmax(norm, 1 / (1 + hypot(x, y)));
}

static void stress(double alpha, double f, double c, double x, double y, double s[3])
{
    assert_ok(rwedge_stress(alpha, f, c, x, y, &s[0], &s[1], &s[2]));
}

CLAIM(stresses_are_flamant_integrated)
{
    uint64_t seed = 3;
    for (int i = 0; i < 60; i++) {
        const tractions_case t = {.alpha = 1.2 * random_fraction(&seed),
                                  .f = random_fraction(&seed),
                                  .c = i % 2 ? random_fraction(&seed) : 0};
        const double x = 4 * random_fraction(&seed) - 2, y = 0.02 + 2 * random_fraction(&seed);
        double s[3], expected[3];
        stress(t.alpha, t.f, t.c, x, y, s);
        flamant_stress(&t, x, y, expected);
        assert_within(relative_error(s, expected, x, y), 0, 1e-10);
    }
}

CLAIM(surface_is_free_outside)
{
    const double outside[] = {1, -1, 1 + 1e-15, 1.5, -3, 1e9, -1e60};
    for (size_t i = 0; i < sizeof outside / sizeof outside[0]; i++) {
        double s[3];
        stress(0.3, 0.5, 0.2, outside[i], 0, s);
        assert_within(s[1], 0, 0);
        assert_within(s[2], 0, 0);
    }
}

/* ---- Derivatives ---- */

/* How far three components are from the reference, over the larger of its norm and that scale. */
static double distance(const double d[3], const double expected[3], double scale)
{
    const double norm =
        sqrt(expected[0] * expected[0] + expected[1] * expected[1] + 2 * expected[2] * expected[2]);
    double worst = 0;
    for (int i = 0; i < 3; i++)
        worst = fmax(worst, fabs(d[i] - expected[i]));
    return worst / fmax(norm, scale);
}

static int32_t gradient(const double v[5], double d[6])
{
    return rwedge_stress_gradient(v[0], v[1], v[2], v[3], v[4], &d[0], &d[1], &d[2], &d[3], &d[4],
                                  &d[5]);
}

static int32_t sensitivity(const double v[5], double d[9])
{
    return rwedge_stress_sensitivity(v[0], v[1], v[2], v[3], v[4], &d[0], &d[1], &d[2], &d[3],
                                     &d[4], &d[5], &d[6], &d[7], &d[8]);
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

/* The sharp wedge's stick zone grows from 0 as the load does: q changes by a flat punch's force. */
CLAIM(derivatives_at_the_ends_of_the_domain)
{
    const double sharp[5] = {0, 0.3, 0, 0.6, 0.4}, hertz[5] = {2, 0.3, 0, 0.6, 0.4};
    double d[9], next[9], s[3];
    assert_ok(sensitivity(sharp, d));
    for (int i = 0; i < 3; i++)
        assert_true(d[i] == 0);
    const double soon[5] = {0, 0.3, 1e-9, 0.6, 0.4};
    assert_ok(sensitivity(soon, next));
    assert_within(distance(&d[6], &next[6], 0), 0, 1e-9);
    stress(2, 0.3, 0, 0.6, 0.4, s); /* as 1/alpha */
    assert_ok(sensitivity(hertz, d));
    for (int i = 0; i < 3; i++) {
        assert_close(d[i], -s[i] / 2, 1e-14);
        assert_true(d[6 + i] == 0);
    }
    const double ends[] = {1e-60, 3e59};
    for (int i = 0; i < 16; i++) {
        const double v[5] = {ends[i & 1], 1e6, i & 2 ? 1e-60 : 0.3, ends[i >> 2 & 1] * 3,
                             ends[i >> 3 & 1] * 0.1 + 1e-60};
        double e[15];
        assert_ok(gradient(v, e));
        assert_ok(sensitivity(v, e + 6));
        for (int k = 0; k < 15; k++)
            assert_true(isfinite(e[k]));
    }
}
