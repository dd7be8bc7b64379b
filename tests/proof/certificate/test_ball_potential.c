/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The potential in balls, compared with the reference stresses, and with its own derivative and
 * limits. */
#include "ball_potential.h"
#include "claims.h"

enum { PREC = 400 };

typedef struct {
    acb_t G, H;
} field;

static void field_init(field *at, double a, double c, double x, double y)
{
    ball_patch patch;
    arb_t a_ball, c_ball;
    acb_t z;
    arb_init(a_ball), arb_init(c_ball), acb_init(z);
    acb_init(at->G), acb_init(at->H);
    arb_set_d(a_ball, a);
    arb_set_d(c_ball, c);
    acb_set_d_d(z, x, y);
    ball_patch_init(&patch, a_ball, c_ball, PREC);
    ball_potential(at->G, &patch, z, PREC);
    ball_potential_slope_by_depth(at->H, &patch, z, PREC);
    ball_patch_clear(&patch);
    arb_clear(a_ball), arb_clear(c_ball), acb_clear(z);
}

static void field_clear(field *at)
{
    acb_clear(at->G), acb_clear(at->H);
}

static double middle(const arb_t ball)
{
    return arf_get_d(arb_midref(ball), ARF_RND_NEAR);
}

/* Stresses of the normal field N and the shear field f (N - C): s, D of the superposition. */
typedef struct {
    double sxx, syy, txy;
} stress;

static stress superposed(const field *N, const field *C, double f)
{
    acb_t GT, HT, D;
    arb_t s;
    acb_init(GT), acb_init(HT), acb_init(D), arb_init(s);
    acb_set(GT, N->G);
    acb_set(HT, N->H);
    if (C) {
        acb_sub(GT, GT, C->G, PREC);
        acb_sub(HT, HT, C->H, PREC);
    }
    arb_set_d(s, f);
    acb_mul_arb(GT, GT, s, PREC);
    acb_mul_arb(HT, HT, s, PREC);
    arb_sub(s, acb_imagref(N->G), acb_realref(GT), PREC);
    acb_mul_onei(D, HT);
    acb_sub(D, D, N->H, PREC);
    acb_add(D, D, GT, PREC);
    assert_true(arb_rel_accuracy_bits(s) > 60 || middle(s) == 0 || arb_contains_zero(s));
    const double mean = middle(s), half = middle(acb_realref(D));
    const stress result = {mean - half, mean + half, middle(acb_imagref(D))};
    acb_clear(GT), acb_clear(HT), acb_clear(D), arb_clear(s);
    return result;
}

static void assert_stress(stress actual, const double expected[3], double x, double y)
{
    const double norm =
        fmax(hypot(hypot(expected[0], expected[1]), expected[2]), 1 / (1 + hypot(x, y)));
    assert_within(actual.sxx, expected[0], 1e-15 * norm);
    assert_within(actual.syy, expected[1], 1e-15 * norm);
    assert_within(actual.txy, expected[2], 1e-15 * norm);
}

static void stresses_in_full_sliding_are_the_reference_values(void **state)
{
    (void)state;
    reference table = reference_open("stress_sliding.csv");
    while (reference_next(&table)) {
        const double *c = table.cell;
        field N;
        field_init(&N, c[0], 1, c[2], c[3]);
        assert_stress(superposed(&N, NULL, c[1]), c + 4, c[2], c[3]);
        field_clear(&N);
    }
}

static void stresses_in_partial_slip_are_the_reference_values(void **state)
{
    (void)state;
    reference table = reference_open("stress_partial_slip.csv");
    while (reference_next(&table)) {
        const double *c = table.cell;
        field N, C;
        field_init(&N, c[0], 1, c[3], c[4]);
        field_init(&C, c[0], c[2], c[3], c[4]);
        assert_stress(superposed(&N, &C, c[1]), c + 6, c[3], c[4]);
        field_clear(&N), field_clear(&C);
    }
}

/* A wide ball contains what thin balls within it give; small ones are finite at the special
 * points too. */
static void wide_balls_contain_thin_ones(void **state)
{
    (void)state;
    static const double alphas[] = {0, 0.01, 0.3, 0.99, 1, 2};
    static const double centres[] = {-1, -0.3, 0, 0.01, 0.3, 0.7, 0.99, 1, 1.5};
    for (size_t i = 0; i < sizeof alphas / sizeof *alphas; i++)
        for (size_t j = 0; j < sizeof centres / sizeof *centres; j++)
            for (int k = 2; k < 40; k += 3) {
                const double r = ldexp(1, -k);
                ball_patch patch;
                arb_t a, one;
                acb_t z, wide, thin;
                arb_init(a), arb_init(one), acb_init(z), acb_init(wide), acb_init(thin);
                arb_set_d(a, alphas[i]);
                arb_one(one);
                ball_patch_init(&patch, a, one, 128);
                for (int m = 0; m < 25; m++)
                    for (int slope = 0; slope < 2; slope++) {
                        void (*const function)(acb_t, const ball_patch *, const acb_t, slong) =
                            slope ? ball_potential_slope_by_depth : ball_potential;
                        acb_set_d_d(z, centres[j], r);
                        mag_set_d(arb_radref(acb_realref(z)), r);
                        mag_set_d(arb_radref(acb_imagref(z)), r);
                        function(wide, &patch, z, 128);
                        acb_set_d_d(z, centres[j] + r * (m % 5 - 2) / 2, r * (m / 5) / 2);
                        function(thin, &patch, z, 128);
                        const bool at_sharp_apex = alphas[i] == 0 && centres[j] == 0;
                        assert_true(acb_is_finite(wide) || r > 1e-3 || at_sharp_apex);
                        if (acb_is_finite(thin) && acb_is_finite(wide))
                            assert_true(acb_overlaps(wide, thin));
                    }
                ball_patch_clear(&patch);
                arb_clear(a), arb_clear(one), acb_clear(z), acb_clear(wide), acb_clear(thin);
            }
}

/* (G(z+h) - G(z-h))/2h, h = 2^-40, is G'(z) to 2^-60 or so. */
static void the_slope_is_the_derivative(void **state)
{
    (void)state;
    static const double alphas[] = {0, 0.01, 0.3, 0.99, 1, 2};
    for (size_t i = 0; i < sizeof alphas / sizeof *alphas; i++)
        for (int k = 0; k < 20; k++) {
            ball_patch patch;
            arb_t a, c;
            acb_t z, h, left, right, slope;
            arb_init(a), arb_init(c), acb_init(z), acb_init(h), acb_init(left), acb_init(right),
                acb_init(slope);
            arb_set_d(a, alphas[i]);
            arb_set_d(c, 0.75);
            ball_patch_init(&patch, a, c, PREC);
            acb_set_d_d(h, ldexp(1, -40), 0);
            acb_set_d_d(z, -1.27 + 0.13 * k, 0.05 + 0.1 * (k % 7));
            acb_add(right, z, h, PREC);
            acb_sub(left, z, h, PREC);
            ball_potential(right, &patch, right, PREC);
            ball_potential(left, &patch, left, PREC);
            ball_potential_slope(slope, &patch, z, PREC);
            acb_sub(right, right, left, PREC);
            acb_mul_2exp_si(right, right, 39);
            assert_within(middle(acb_realref(right)), middle(acb_realref(slope)), 1e-14);
            assert_within(middle(acb_imagref(right)), middle(acb_imagref(slope)), 1e-14);
            ball_patch_clear(&patch);
            arb_clear(a), arb_clear(c);
            acb_clear(z), acb_clear(h), acb_clear(left), acb_clear(right), acb_clear(slope);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stresses_in_full_sliding_are_the_reference_values),
        cmocka_unit_test(stresses_in_partial_slip_are_the_reference_values),
        cmocka_unit_test(wide_balls_contain_thin_ones),
        cmocka_unit_test(the_slope_is_the_derivative),
    };
    return RUN_CLAIMS("ball_potential", tests);
}
