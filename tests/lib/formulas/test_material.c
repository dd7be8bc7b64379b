/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "claims.h"
#include "rwedge.h"

#include <float.h>

CLAIM(compliance_is_equation_2)
{
    /* 4 * 0.91 / 200e3 */
    assert_close(rwedge_compliance(200e3, 0.3, 200e3, 0.3), 1.82e-5, 4 * DBL_EPSILON);
    /* 0.01 + 0.015 */
    assert_close(rwedge_compliance(200, 0, 100, 0.5), 0.025, 4 * DBL_EPSILON);
    /* rigid wedge */
    assert_close(rwedge_compliance(HUGE_VAL, 0.3, 100, 0.5), 0.015, 4 * DBL_EPSILON);
}

/* Dundurs' definition with shear moduli and Kolosov constants. */
static double beta_by_definition(double E1, double nu1, double E2, double nu2)
{
    const double mu1 = E1 / (2 * (1 + nu1)), mu2 = E2 / (2 * (1 + nu2)), k1 = 3 - 4 * nu1,
                 k2 = 3 - 4 * nu2;
    return (mu1 * (k2 - 1) - mu2 * (k1 - 1)) / (mu1 * (k2 + 1) + mu2 * (k1 + 1));
}

CLAIM(beta_is_dundurs)
{
    uint64_t seed = 1;
    for (int i = 0; i < 1000; i++) {
        const double E1 = 1 + 9 * random_fraction(&seed), E2 = 1 + 9 * random_fraction(&seed);
        const double nu1 = -0.9 + 1.4 * random_fraction(&seed), nu2 = 0.5 * random_fraction(&seed);
        const double beta = rwedge_dundurs_beta(E1, nu1, E2, nu2);
        assert_within(beta, beta_by_definition(E1, nu1, E2, nu2), 8 * DBL_EPSILON);
        assert_within(beta, -rwedge_dundurs_beta(E2, nu2, E1, nu1), 4 * DBL_EPSILON);
    }
    assert_within(rwedge_dundurs_beta(7, 0.3, 7, 0.3), 0, 0);
    /* the corner of Dundurs' parallelogram */
    assert_within(rwedge_dundurs_beta(HUGE_VAL, 0.1, 7, 0), 0.5, DBL_EPSILON);
}
