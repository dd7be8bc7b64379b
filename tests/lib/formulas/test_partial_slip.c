/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "claims.h"
#include "quadrature.h"
#include "rwedge.h"

CLAIM(shear_ratio_matches_reference)
{
    reference table = reference_open("stress_partial_slip.csv");
    while (reference_next(&table))
        assert_close(rwedge_shear_ratio(table.cell[0], table.cell[2]), table.cell[5], 1e-14);
    assert_int_equal(table.row, 600);
}

/* Where c is lost beside 1 the ratio was sometimes 1 + 2 epsilon, outside the domain of its
 * inverse. */
CLAIM(round_trips_stay_in_the_domain)
{
    uint64_t seed = 13;
    for (int i = 0; i < 20000; i++) {
        const double alpha =
            i % 2 ? random_fraction(&seed) : 1 - pow(10, -12 * random_fraction(&seed));
        const double ratio = rwedge_shear_ratio(alpha, pow(10, -60 * random_fraction(&seed)));
        assert_true(ratio >= 0 && ratio <= 1);
        assert_true(rwedge_stick_width(alpha, ratio) >= 0);
    }
}

/* Eq. (25) as printed, for c > a. */
CLAIM(shear_ratio_is_equation_25)
{
    const double alpha = 0.25, c = 0.5, omega0 = asin(alpha / c), phi0 = asin(alpha);
    const double corrective = alpha / pow(sin(omega0), 2) * (sin(2 * omega0) / 2 + omega0);
    const double whole = alpha / pow(sin(phi0), 2) * (sin(2 * phi0) / 2 + phi0);
    assert_close(rwedge_shear_ratio(alpha, c), 1 - corrective / whole, 1e-14);
    /* as a boundary-element program has it */
    assert_close(rwedge_shear_ratio(alpha, c), 0.5166107, 1e-7);
}

typedef struct {
    double alpha, c;
} partial_slip;

static double shear_in_phi(double phi, const void *context)
{
    const partial_slip *s = context;
    return rwedge_shear(s->alpha, s->c, sin(phi)) * cos(phi);
}

CLAIM(shear_integrates_to_Q)
{
    for (double alpha = 0; alpha < 1.3; alpha += 0.25)
        for (double c = 0.05; c < 1; c += 0.13) {
            const partial_slip s = {alpha, c};
            const double a = asin(fmin(alpha, 1)), stick = asin(c);
            const double points[] = {0, fmin(a, stick), fmax(a, stick), PI / 2};
            const double Q = -2 * integral(shear_in_phi, &s, 3, points);
            assert_close(Q, rwedge_shear_ratio(alpha, c) * rwedge_load(alpha), 1e-11);
        }
}
