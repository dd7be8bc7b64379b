/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Quantities with units of one contact. */
#include "claims.h"
#include "rwedge.h"

CLAIM(a_cylinder_gives_the_formulas_of_hertz)
{
    const double R = 50, E = 70e3, nu = 0.3, P = 100; /* mm, N/mm^2, N/mm */
    const double compliance = rwedge_compliance(E, nu, E, nu), theta = 0.1,
                 a = rwedge_rounding(theta, R);
    assert_close(a, 5, 1e-15);
    assert_close(rwedge_radius(theta, a), R, 1e-15);
    const double E_star = E / (2 * (1 - nu * nu));
    assert_close(rwedge_half_width(theta, a, compliance, P), sqrt(4 * P * R / (PI * E_star)),
                 1e-14);
}
