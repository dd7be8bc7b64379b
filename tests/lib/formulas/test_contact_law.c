/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "claims.h"
#include "quadrature.h"
#include "rwedge.h"

#include <float.h>

CLAIM(load_matches_reference)
{
    reference table = reference_open("contact_law.csv");
    while (reference_next(&table))
        assert_close(rwedge_load(table.cell[0]), table.cell[1], 4 * DBL_EPSILON);
    assert_int_equal(table.row, 300);
}

static double slope_times_t(double tau, const void *alpha)
{
    const double t = sin(tau);
    return fmin(t / *(const double *)alpha, 1) * t;
}

/* Eq. (5), integrated. */
CLAIM(load_is_the_integral_of_the_profile)
{
    for (double alpha = 0.05; alpha < 1.01; alpha += 0.05) {
        const double points[] = {0, asin(fmin(alpha, 1)), PI / 2};
        assert_close(2 * integral(slope_times_t, &alpha, 2, points), rwedge_load(alpha), 1e-12);
    }
}

CLAIM(load_has_the_hertz_and_the_sharp_limit)
{
    assert_close(rwedge_load(0), 2, 0);                /* Eq. (13) */
    assert_close(rwedge_load(1), PI / 2, DBL_EPSILON); /* Eq. (11) */
    assert_close(rwedge_load(4), PI / 8, DBL_EPSILON);
    assert_close(rwedge_load(1e-5), 2 - 1e-10 / 3, DBL_EPSILON); /* Eq. (15) and its next term */
    assert_close(rwedge_load(1e-60), 2, 0);
}

CLAIM(a_over_b_inverts_the_load)
{
    reference table = reference_open("contact_law.csv");
    while (reference_next(&table)) {
        const double alpha = table.cell[0];
        assert_close(rwedge_a_over_b(table.cell[1] / alpha), alpha, 1e-14);
    }
}

CLAIM(load_derivative_matches_reference)
{
    reference table = reference_open("contact_law_derivatives.csv");
    while (reference_next(&table))
        assert_close(rwedge_load_derivative(table.cell[0]), table.cell[1], 1e-14);
    assert_int_equal(table.row, 40);
    assert_close(rwedge_load_derivative(0), 0, 0);
    assert_close(rwedge_load_derivative(1), -PI / 2, DBL_EPSILON); /* from both sides */
    assert_close(rwedge_load_derivative(nextafter(1, 0)), -PI / 2, 1e-7);
    assert_close(rwedge_load_derivative(1e-60), -2e-60 / 3, DBL_EPSILON);
}
