/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Quantities with units of one contact. */
#include "claims.h"
#include "rwedge.h"

static const double PI = 3.14159265358979323846;
static const double THETA = 0.1, A = 0.5; /* theta/A = 0.2 */

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

CLAIM(half_width_and_load_are_inverse)
{
    uint64_t seed = 4;
    for (int i = 0; i < 20000; i++) {
        const double a = i % 7 == 0 ? 0 : pow(10, 30 * random_fraction(&seed) - 15);
        const double b = pow(10, 30 * random_fraction(&seed) - 15);
        assert_close(rwedge_half_width(THETA, a, A, rwedge_normal_load(THETA, a, A, b)), b, 1e-14);
    }
    assert_true(rwedge_half_width(THETA, 0.1, A, 0) == 0 &&
                rwedge_normal_load(THETA, 0.1, A, 0) == 0);
    assert_close(rwedge_half_width(THETA, 0, A, 0.2), A * 0.2 / (2 * THETA), 1e-15);
    assert_close(rwedge_half_width(THETA, 1e-59, A, 0.2), A * 0.2 / (2 * THETA), 1e-15);
}

CLAIM(nothing_has_no_size)
{
    assert_true(rwedge_radius(0.1, 0) == 0 && rwedge_rounding(0.1, 0) == 0);
    assert_true(rwedge_radius(0.1, 1) == 1 / 0.1 && rwedge_rounding(0.1, 1) == 0.1);
}

CLAIM(sizes_end_with_the_domain)
{
    assert_true(rwedge_rounding(0.5, 2e-60) == 1e-60 && rwedge_radius(0.5, 5e59) == 1e60);
    assert_nan(rwedge_rounding(0.5, 1e-60));
    assert_nan(rwedge_radius(0.5, 1e60));
    assert_nan(rwedge_half_width(1, 0, 1e-40, 1e-40)); /* b = 5e-81 */
    assert_nan(rwedge_half_width(1, 1e60, 1, 1e-60));  /* b = 0.8, a/b = 1.3e60 */
    assert_nan(rwedge_normal_load(1, 0, 1e-50, 1e20)); /* P = 2e70 */
    assert_nan(rwedge_normal_load(1, 1e40, 1, 1e-25)); /* a/b = 1e65 */
}
