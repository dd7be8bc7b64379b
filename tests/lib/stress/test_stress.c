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

CLAIM(sliding_stresses_match_reference)
{
    reference table = reference_open("stress_sliding.csv");
    while (reference_next(&table)) {
        const double *v = table.cell;
        double s[3];
        stress(v[0], v[1], 0, v[2], v[3], s);
        assert_within(relative_error(s, &v[4], v[2], v[3]), 0, 1e-13);
    }
    assert_int_equal(table.row, 600);
}

CLAIM(partial_slip_stresses_match_reference)
{
    reference table = reference_open("stress_partial_slip.csv");
    while (reference_next(&table)) {
        const double *v = table.cell;
        double s[3];
        stress(v[0], v[1], v[2], v[3], v[4], s);
        assert_within(relative_error(s, &v[6], v[3], v[4]), 0, 1e-13);
    }
    assert_int_equal(table.row, 600);
}

/* Points next to the edge of a stick zone that ends next to the corner x = a. A coordinate
 * divided by c lost the distance to the edge there, and with it half of the digits. Values from
 * ball arithmetic with 600 bits. */
CLAIM(stick_edges_keep_their_digits)
{
    static const double cases[][8] = {
        /* alpha, f, c, x, y, sxx, syy, txy */
        {0.469067885573485, 1.0062261138521063, 0.4690678855862623, 0.46906788557350104,
         2.837767323274999e-14, -1.0671389332130914, -1.0671389002046025, -1.0737756144907830},
        {0.999999999029367, 1.2081250743995966, 0.9999999990220022, 0.999999999149257,
         2.7844330093869515e-11, -7.7817234072758381e-5, -4.1834016533245682e-5,
         -4.6359747807493800e-5},
        {0.9999996299575209, 1.9677218165559982, 0.9999996299574303, 0.9999996299574908,
         1.4537391473804766e-14, -0.00086143477351121438, -0.00086003709971822665,
         -0.0016921703089923644},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const double *v = cases[i];
        double s[3];
        stress(v[0], v[1], v[2], v[3], v[4], s);
        assert_within(relative_error(s, &v[5], v[3], v[4]), 0, 1e-13);
    }
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

typedef struct {
    double alpha, f, c, y;
    int component;
} level;

static double stress_on_level(double x, const void *context)
{
    const level *l = context;
    double s[3];
    stress(l->alpha, l->f, l->c, x, l->y, s);
    return s[l->component];
}

/* What crosses any level below the contact is P and Q. */
CLAIM(levels_carry_the_forces)
{
    for (double y = 0.5; y < 4; y += 0.7) {
        level l = {.alpha = 0.3, .f = 0.6, .c = 0.4, .y = y, .component = 1};
        const double P = rwedge_load(0.3);
        assert_close(integral_over_line(stress_on_level, &l), -P, 1e-9);
        l.component = 2;
        assert_close(integral_over_line(stress_on_level, &l),
                     -0.6 * rwedge_shear_ratio(0.3, 0.4) * P, 1e-9);
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

CLAIM(derivatives_are_difference_quotients)
{
    reference table = reference_open("stress_gradient.csv");
    while (reference_next(&table)) {
        const double *v = table.cell, far = 1 + hypot(v[3], v[4]);
        double d[15];
        assert_ok(gradient(v, d));
        assert_ok(sensitivity(v, d + 6));
        for (int i = 0; i < 15; i += 3)
            assert_within(distance(&d[i], &v[5 + i], 1 / far / (i < 6 ? far : 1)), 0, 1e-13);
    }
    assert_int_equal(table.row, 67);
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
