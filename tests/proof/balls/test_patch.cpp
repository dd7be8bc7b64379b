/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The potential in balls, compared with the reference stresses, and with its own derivative and
 * limits. */
#include "balls/patch.hpp"

#include <initializer_list>

extern "C" {
#include "claims.h"
}

static void assert_stress(const superposition &at, const complex_ball &z, const double expected[3])
{
    const ball &s = at.s;
    assert_true(arb_rel_accuracy_bits(s.raw()) > 60 || middle(s) == 0 ||
                arb_contains_zero(s.raw()));
    const double mean = middle(s), half = middle(re(at.D));
    const double largest = hypot(hypot(expected[0], expected[1]), expected[2]);
    const double norm = fmax(largest, 1 / (1 + middle(abs(z))));
    assert_within(mean - half, expected[0], 1e-15 * norm);
    assert_within(mean + half, expected[1], 1e-15 * norm);
    assert_within(middle(im(at.D)), expected[2], 1e-15 * norm);
}

CLAIM(stresses_in_full_sliding_are_the_reference_values)
{
    const precision here(400);
    reference table = reference_open("stress_sliding.csv");
    while (reference_next(&table)) {
        const double *c = table.cell;
        const complex_ball z(c[2], c[3]);
        const potentials N = patch(c[0], 1).at(z);
        assert_stress(superposed(N, ball(c[1]) * N), z, c + 4);
    }
}

CLAIM(stresses_in_partial_slip_are_the_reference_values)
{
    const precision here(400);
    reference table = reference_open("stress_partial_slip.csv");
    while (reference_next(&table)) {
        const double *c = table.cell;
        const complex_ball z(c[3], c[4]);
        const potentials N = patch(c[0], 1).at(z), stick = patch(c[0], c[2]).at(z);
        assert_stress(superposed(N, ball(c[1]) * (N - stick)), z, c + 6);
    }
}

/* Whether what a wide ball gives is finite, or contains what thin balls within it give. */
static void assert_contains(const complex_ball &wide, const complex_ball &thin,
                            bool may_be_infinite)
{
    assert_true(acb_is_finite(wide.raw()) || may_be_infinite);
    if (acb_is_finite(thin.raw()) && acb_is_finite(wide.raw()))
        assert_true(acb_overlaps(wide.raw(), thin.raw()));
}

static void wide_balls_contain_thin_ones(const patch &p, double centre, double r)
{
    const complex_ball square(widened(centre, r), widened(r, r));
    const complex_ball G = p.potential(square), H = p.depth_slope(square);
    const bool may_be_infinite = r > 1e-3 || (p.is_sharp() && centre == 0); /* at its apex */
    for (int m = 0; m < 25; m++) {
        const complex_ball z(centre + r * (m % 5 - 2) / 2, r * (m / 5) / 2);
        assert_contains(G, p.potential(z), may_be_infinite);
        assert_contains(H, p.depth_slope(z), may_be_infinite);
    }
}

/* Small ones are finite at the special points too. */
CLAIM(wide_balls_contain_thin_ones_and_small_ones_are_finite)
{
    for (const double alpha : {0.0, 0.01, 0.3, 0.99, 1.0, 2.0})
        for (const double centre : {-1.0, -0.3, 0.0, 0.01, 0.3, 0.7, 0.99, 1.0, 1.5})
            for (int k = 2; k < 40; k += 3)
                wide_balls_contain_thin_ones(patch(alpha, 1), centre, ldexp(1, -k));
}

/* (f(z+h) - f(z-h))/2h, h = 2^-40, is f'(z) to 2^-60 or so. */
template <typename Function>
static void assert_derivative(const complex_ball &derivative, const complex_ball &z, Function f)
{
    const ball h = ldexp(1, -40);
    const complex_ball secant = (f(z + h) - f(z - h)) / (2 * h);
    assert_within(middle(abs(secant - derivative) / abs(derivative)), 0, 1e-14);
}

CLAIM(each_derivative_is_that_of_the_one_before)
{
    const precision here(400);
    for (const double alpha : {0.0, 0.01, 0.3, 0.99, 1.0, 2.0})
        for (int k = 0; k < 20; k++) {
            const patch p(alpha, 0.75);
            const complex_ball z(-1.27 + 0.13 * k, 0.05 + 0.1 * (k % 7));
            const higher_derivatives at = p.bends(z);
            assert_derivative(p.slope(z), z, [&](auto w) { return p.potential(w); });
            assert_derivative(at.second, z, [&](auto w) { return p.slope(w); });
            assert_derivative(at.third, z, [&](auto w) { return p.bends(w).second; });
            assert_derivative(at.fourth, z, [&](auto w) { return p.bends(w).third; });
        }
}
