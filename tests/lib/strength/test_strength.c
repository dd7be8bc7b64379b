/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "claims.h"
#include "rwedge.h"

/* The reversal of the smallest tips: at the surface without friction, below it with a little, at
 * the surface with more. */
CLAIM(tiny_tips_yield_below_with_a_little_friction)
{
    const double frictions[] = {0, 0.1, 0.3};
    for (int i = 0; i < 3; i++) {
        double limit, x, y;
        assert_ok(rwedge_yield_point(1e-5, frictions[i], 0.36, &limit, &x, &y));
        assert_int_equal(y > 0, i == 1);
    }
    for (double alpha = 0.0027; alpha < 1; alpha *= 1.3) /* larger tips have none */
        for (double nu = 0.01; nu < 0.5; nu += 0.007) {
            double limit, x, y;
            assert_ok(rwedge_yield_point(alpha, 0, nu, &limit, &x, &y));
            for (double f = 0.02; y == 0 && f < 0.3; f += 0.02) {
                assert_ok(rwedge_yield_point(alpha, f, nu, &limit, &x, &y));
                assert_true(y == 0);
            }
        }
}

/* The search below does not begin beyond f = 0.6. */
CLAIM(no_fold_is_beyond_0_556)
{
    double limit, x, y;
    assert_ok(rwedge_subsurface_yield(0.82, 0.5556, 0.47, &limit, &x, &y));
    for (double alpha = 1e-6; alpha <= 1; alpha = alpha < 0.1 ? alpha * 3 : alpha + 0.005)
        for (double nu = 0; nu <= 0.5; nu += 0.005)
            assert_int_equal(rwedge_subsurface_yield(alpha, 0.557, nu, &limit, &x, &y),
                             RWEDGE_EABSENT);
}

/* Past the fold the branch is gone; before it, it is there, up to the fold's last bits. */
CLAIM(subsurface_branch_ends_at_a_fold)
{
    double there = 0, gone = 1, limit = 7, x = 7, y = 7;
    while (gone - there > 1e-13) {
        const double f = (there + gone) / 2;
        if (rwedge_subsurface_yield(0.5, f, 0.3, &limit, &x, &y) == RWEDGE_OK)
            there = f;
        else
            gone = f;
    }
    assert_true(there > rwedge_critical_friction(0.5, 0.3));
    double before_limit, before_x, before_y;
    assert_ok(rwedge_subsurface_yield(0.5, there - 1e-8, 0.3, &before_limit, &before_x, &before_y));
    /* a square-root approach: 1e-8 in f moves the point by about 1e-4 */
    assert_true(hypot(x - before_x, y - before_y) > 1e-6 &&
                hypot(x - before_x, y - before_y) < 1e-2);
    limit = x = y = 7;
    assert_int_equal(rwedge_subsurface_yield(0.5, gone + 1e-6, 0.3, &limit, &x, &y),
                     RWEDGE_EABSENT);
    assert_true(limit == 7 && x == 7 && y == 7);
}

CLAIM(sharp_wedge_yields_at_its_apex)
{
    double limit = 7, x = 7, y = 7;
    assert_ok(rwedge_yield_point(0, 0.2, 0.3, &limit, &x, &y));
    assert_true(limit == 0 && x == 0 && y == 0);
    assert_within(rwedge_elastic_limit(0, 0, 0.3), 0, 0);
    assert_close(rwedge_elastic_limit(0, 0, 0.5), PI, 1e-15);
    /* continuously: the yield point is at sqrt(alpha) */
    assert_close(rwedge_elastic_limit(1e-12, 0, 0.5), PI, 1e-5);
    assert_true(rwedge_elastic_limit(1e-14, 0.2, 0.3) < 0.4);
    assert_within(rwedge_critical_friction(0, 0.3), 0, 0);
    assert_int_equal(rwedge_subsurface_yield(0, 0, 0.5, &limit, &x, &y), RWEDGE_EABSENT);
    assert_ok(rwedge_surface_yield(0, 0.1, 0.5, &limit, &x));
    assert_true(limit == 0 && x == 0);
}

/* Where J2 is so flat that rounding moves its maximum, the branch was lost and the surface taken
 * for the place of yield. Values of a search of the half-plane by the stresses alone. */
CLAIM(flat_maxima_of_tiny_tips_are_found)
{
    static const double cases[][3] = {{1e-10, 0.001, 3.1407}, {9e-14, 0.01, 2.94}};
    for (int i = 0; i < 2; i++) {
        double limit, x, y;
        assert_ok(rwedge_yield_point(cases[i][0], cases[i][1], 0.5, &limit, &x, &y));
        assert_true(y > 0);
        assert_close(limit, cases[i][2], 2e-3);
    }
    for (double alpha = 1e-14; alpha < 1e-6;
         alpha *= 1.7) /* the limit falls steadily from pi, with no jump to the surface */
        for (double f = 1e-7; f < 0.05; f *= 2)
            assert_true(rwedge_elastic_limit(alpha, f, 0.5) > PI * (1 - 15 * f));
}

CLAIM(incompressible_surface_is_safe_without_friction)
{
    double limit, x;
    assert_int_equal(rwedge_surface_yield(0.3, 0, 0.5, &limit, &x), RWEDGE_EABSENT);
}

/* Nowhere in the half-plane is s1 above sxx at the trailing edge. */
CLAIM(max_tension_is_the_largest)
{
    for (double alpha = 0.1; alpha < 1; alpha += 0.3) {
        const double f = 0.5, largest = f * rwedge_load(alpha) * rwedge_max_tension(alpha);
        for (double x = -3; x < 3; x += 0.02)
            for (double y = 0; y < 2; y += 0.02) {
                double sxx, syy, txy;
                assert_ok(rwedge_stress(alpha, f, 0, x, y, &sxx, &syy, &txy));
                const double s1 = (sxx + syy) / 2 + hypot((sxx - syy) / 2, txy);
                assert_true(s1 <= largest * (1 + 1e-14));
            }
    }
}

/* Next to alpha = 1 the surface is that of Hertz, g^2 + p^2 = 1, where J2 = f^2 + kappa (p + f
 * g)^2 has its maximum at x = f/sqrt(1 + f^2): for large f the end of the rounding, to rounding. */
CLAIM(the_maximum_may_be_at_the_end_of_the_rounding)
{
    double limit, x;
    assert_ok(rwedge_surface_yield(1 - 1e-8, 1e6, 0.3, &limit, &x));
    assert_close(limit, PI / 2 / sqrt(1e12 * (1 + 0.16 / 3)), 1e-5);
    assert_close(x, 1 - 1e-8, 1e-15);
}

/* ---- The load at which a given contact first yields, in full sliding ---- */

static const double THETA = 0.1, A = 0.5; /* theta/A = 0.2 */

/* Far from the usual units: exact powers of two. */
CLAIM(the_yield_load_scales_with_the_units)
{
    static const struct {
        double f, nu, k;
        int length, stress; /* octaves */
    } CASES[] = {
        {0, 0.3, 1e-10, -100, 70},   {0, 0.3, 1e-20, 120, -70},   {0.1, 0.3, 2.25, 100, -40},
        {0.1, 0.3, 3.375, 100, -60}, {0.5, 0.2, 1e-3, -102, 100}, {1e-3, 0.45, 0.7, 102, -100},
    };
    for (size_t i = 0; i < sizeof CASES / sizeof *CASES; i++) {
        const double f = CASES[i].f, nu = CASES[i].nu, a = ldexp(1, CASES[i].length),
                     S = ldexp(1, CASES[i].stress);
        const double expected = rwedge_yield_load(1, 1, 1, f, nu, CASES[i].k);
        assert_true(expected > 0 && isfinite(expected));
        assert_close(rwedge_yield_load(1, a, 1 / S, f, nu, CASES[i].k * S),
                     ldexp(expected, CASES[i].length + CASES[i].stress), 1e-15);
    }
}

CLAIM(what_never_yields_has_an_infinite_yield_load)
{
    const double bound = 2 / PI * THETA / A;
    assert_true(rwedge_yield_load(THETA, 0.3, A, 0, 0.5, 1.001 * bound) == HUGE_VAL);
    assert_true(isfinite(rwedge_yield_load(THETA, 0.3, A, 0, 0.5, 0.999 * bound)));
    assert_true(rwedge_yield_load(THETA, 0, A, 0, 0.5, 1.001 * bound) == HUGE_VAL);
    assert_true(rwedge_yield_load(THETA, 0, A, 1e-59, 0.5, 1.001 * bound) == 0);
    assert_true(rwedge_yield_load(THETA, 0, A, 0, 0.5, 0.999 * bound) == 0);
    assert_true(rwedge_yield_load(THETA, 0, A, 0.1, 0.3, 1e9) == 0);
    assert_true(rwedge_yield_load(THETA, 0, A, 0, 0.3, 1e9) == 0);
    /* A k/theta = 1e150 */
    assert_true(rwedge_yield_load(1e-50, 1, 1e50, 0.1, 0.3, 1e50) == HUGE_VAL);
}
