/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The potential in balls, compared with reference values, and with its own derivatives. */
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

/* Columns: a/b, f, c/b if something sticks, the place, Q/(fP) if something sticks, the stresses. */
static void assert_reference(const char *file, bool sticks)
{
    const precision here(400);
    reference table = reference_open(file);
    while (reference_next(&table)) {
        const double *c = table.cell, *place = c + 2 + sticks;
        const complex_ball z(place[0], place[1]);
        const potentials N = patch(c[0], 1).at(z);
        const potentials slip = sticks ? N - patch(c[0], c[2]).at(z) : N;
        assert_stress(superposed(N, ball(c[1]) * slip), z, place + 2 + sticks);
    }
}

CLAIM(stresses_are_the_reference_values)
{
    assert_reference("stress_sliding.csv", false);
    assert_reference("stress_partial_slip.csv", true);
}

/* Those that were checked against quadrature of the paper's Eq. (3). */
CLAIM(pressures_and_loads_are_the_reference_values)
{
    const precision here(400);
    reference pressures = reference_open("pressure.csv"), laws = reference_open("contact_law.csv");
    const double *p = pressures.cell, *law = laws.cell;
    while (reference_next(&pressures))
        assert_close(middle(im(patch(p[0], 1).potential(p[1]))), p[2], 1e-15);
    while (reference_next(&laws))
        assert_close(middle(patch(law[0], 1).load()), law[1], 1e-15);
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
