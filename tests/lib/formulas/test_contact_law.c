/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "claims.h"
#include "rwedge.h"

#include <float.h>

CLAIM(load_matches_reference)
{
    reference table = reference_open("contact_law.csv");
    while (reference_next(&table))
        assert_close(rwedge_load(table.cell[0]), table.cell[1], 4 * DBL_EPSILON);
    assert_int_equal(table.row, 300);
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
