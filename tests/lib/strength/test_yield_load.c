/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The load at which a given contact first yields, in full sliding. */
#include "claims.h"
#include "rwedge.h"

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
