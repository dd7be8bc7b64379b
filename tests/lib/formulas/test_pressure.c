/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "claims.h"
#include "quadrature.h"
#include "rwedge.h"

CLAIM(pressure_matches_reference)
{
    reference table = reference_open("pressure.csv");
    while (reference_next(&table))
        assert_close(rwedge_pressure(table.cell[0], table.cell[1]), table.cell[2], 1e-14);
    assert_int_equal(table.row, 600);
}

CLAIM(named_pressures_match_reference)
{
    reference table = reference_open("contact_law.csv");
    while (reference_next(&table)) {
        assert_close(rwedge_peak_pressure(table.cell[0]), table.cell[2], 1e-14);
        assert_close(rwedge_transition_pressure(table.cell[0]), table.cell[3], 1e-14);
    }
}

typedef struct {
    double alpha, at;
} inversion;

/* Eq. (3) with t = sin(tau); the factor makes the kernel 1/(tau - at). */
static double profile_in_tau(double tau, const void *context)
{
    const inversion *c = context;
    const double slope = -fmax(-1, fmin(1, sin(tau) / c->alpha));
    const double half_difference = (tau - c->at) / 2;
    const double ratio =
        fabs(half_difference) < 1e-150 ? 1 : half_difference / sin(half_difference);
    return slope * ratio / cos((tau + c->at) / 2);
}

CLAIM(pressure_is_the_inverted_integral)
{
    for (double alpha = 0.1; alpha < 1; alpha += 0.2)
        for (double x = 0.03; x < 1; x += 0.11) {
            const inversion c = {alpha, asin(x)};
            const double value = principal_value(profile_in_tau, &c, -PI / 2, PI / 2, c.at);
            /* limited by the kinks at +-alpha */
            assert_close(rwedge_pressure(alpha, x), sqrt(1 - x * x) / PI * value, 1e-8);
        }
}

static double pressure_in_phi(double phi, const void *alpha)
{
    return rwedge_pressure(*(const double *)alpha, sin(phi)) * cos(phi);
}

CLAIM(pressure_integrates_to_the_load)
{
    const double alphas[] = {1e-6, 1e-3, 0.05, 0.3, 0.9, 1 - 1e-9, 1, 3};
    for (size_t i = 0; i < sizeof alphas / sizeof alphas[0]; i++) {
        const double points[] = {0, asin(fmin(1, alphas[i])), PI / 2};
        assert_close(-2 * integral(pressure_in_phi, &alphas[i], 2, points), rwedge_load(alphas[i]),
                     1e-12);
    }
}

CLAIM(pressure_vanishes_outside)
{
    assert_within(rwedge_pressure(0.3, 1), 0, 0);
    assert_within(rwedge_pressure(0, -1.5), 0, 0);
    assert_within(rwedge_pressure(7, 1e60), 0, 0);
    assert_true(rwedge_pressure(0.3, nextafter(1, 0)) < 0);
    assert_within(rwedge_transition_pressure(1), 0, 0);
}
