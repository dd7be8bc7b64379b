/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far a contact with a history is from yield. */
#include "yield/marks.h"
#include "yield/neighbourhood.h"
#include "histories.h"

#include <fenv.h>

static double yield_factor(const rwedge_contact *contact, double nu, double k, double *x, double *y)
{
    double factor = -1;
    assert_ok(rwedge_contact_yield_factor(contact, nu, k, &factor, x, y));
    return factor;
}

CLAIM(factors_of_histories_are_the_reference_values)
{
    reference rows = reference_open("yield_factor.csv");
    while (reference_next(&rows)) {
        const double *c = rows.cell;
        double factor;
        assert_ok(rwedge_contact_yield_factor(recorded(c, c + 7), c[4], 1, &factor, NULL, NULL));
        assert_within(factor, c[5], c[6]);
    }
}

/* Tips, frictions and Poisson's ratios where J2 has ridges that are flat to 1e-9, or a maximum
 * as near to the edge as b/f^2. */
CLAIM(in_sliding_the_factor_is_the_elastic_limit_over_the_load)
{
    uint64_t seed = 5;
    for (int i = 0; i < 2000; i++) {
        const double alpha = pow(10, 15 * random_fraction(&seed) - 13.9),
                     kind = random_fraction(&seed);
        const double exponent =
            kind < 0.6 ? 12 * random_fraction(&seed) - 12 : 6 * random_fraction(&seed);
        const double f = kind < 0.2 ? 0 : pow(10, exponent);
        const double nu = i % 2 ? 0.5 : 0.5 - pow(10, -12 * random_fraction(&seed)) / 2;
        const double b = 0.7, P = rwedge_normal_load(THETA, alpha * b, A, b);
        rwedge_contact *contact = APPLY(create(alpha * b, f), {P, 0, f * P, 0});
        const double expected = rwedge_elastic_limit(alpha, f, nu) * b / P;
        assert_close(yield_factor(contact, nu, 1, NULL, NULL), expected, 1e-13);
        load(contact, P, -f * P); /* the mirror image */
        assert_close(yield_factor(contact, nu, 3, NULL, NULL), 3 * expected, 1e-13);
    }
}

/* Around the apex of a tilted sharp wedge J2 is constant but for a ridge that turns, and rises by
 * 9e-6, beside the angles of the grid. The value is that of tests/proof/test_yield_survey.c, whose
 * search is another. */
CLAIM(a_ridge_beside_the_grid_is_followed)
{
    const double P = 0.98755269117723787, M = -0.16595399389051149;
    rwedge_contact *contact = APPLY(create_wedge(0.1, 0, 0.1, 0.01043908085530201), {P, M, 0, 0},
                                    {P, M, 0.0062538432218377021, 0.005317738877638669});
    assert_close(yield_factor(contact, 0.5, 1, NULL, NULL), 1.56740088124900, 1e-12);
}

/* Below a tiny rounding at nu = 0.5, J2 is so flat that a climb takes a hundred steps. It is broken
 * off; the grids of other marks find the same top. With nu a little below 0.5 there is less of a
 * plateau, and J2 differs by less than 1e-13. */
CLAIM(a_long_climb_is_broken_off_without_harm)
{
    rwedge_contact *contact = create_wedge(0.11871519035629816, 4.8339965423190293e-15,
                                           3.9616415245691163e-08, 0.99667353322652019);
    APPLY(contact, {0.36913862821393151, 0, 0, 0},
          {0.36913862821393151, 0, 0.13581005141048719, 0});
    const double factor = yield_factor(contact, 0.5, 1, NULL, NULL);
    assert_close(yield_factor(contact, 0.4999999, 1, NULL, NULL), factor, 1e-12);
}

CLAIM(the_sharp_wedge_yields_at_once_unless_its_apex_sticks)
{
    rwedge_contact *contact = APPLY(create(0, 0.5), {0.2, 0, 0, 0});
    assert_true(yield_factor(contact, 0.3, 1, NULL, NULL) == 0);
    assert_close(yield_factor(contact, 0.5, 1, NULL, NULL), PI / 2 * A / THETA, 1e-12);
    load(contact, 0.2, 0.05);
    assert_true(yield_factor(contact, 0.5, 1, NULL, NULL) > 0);
    load(contact, 0.2, 0.1);
    assert_true(yield_factor(contact, 0.5, 1, NULL, NULL) == 0);
}

/* Of two kinks of a profile one touches; what sticks there is finite where shape alone yields. */
CLAIM(a_kink_beside_the_contact_makes_no_infinite_stress)
{
    const double x[] = {0, 0, 1, 1}, slope[] = {-0.1, 0.05, 0.05, 0.1};
    rwedge_contact *contact = APPLY(create_profile(4, x, slope, 0.5), {0.01, 0, 0, 0});
    assert_true(rwedge_contact_half_width(contact) < 1);
    assert_true(yield_factor(contact, 0.3, 1, NULL, NULL) == 0);
    assert_true(yield_factor(contact, 0.5, 1, NULL, NULL) > 0);
}

/* A place of the search's grid around another mark is the apex itself, to the last bit. */
CLAIM(a_grid_that_meets_the_apex_raises_nothing)
{
    const double P = 0.001, f = 0.3;
    rwedge_contact *contact = APPLY(create_wedge(0.3, 0, 0.001, f), {P, 0, 0, 0});
    load(contact, P, -0.3 * (f * P));
    feclearexcept(FE_ALL_EXCEPT);
    assert_true(yield_factor(contact, 0.5, 1, NULL, NULL) > 0);
    assert_int_equal(fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW), 0);
}

CLAIM(a_factor_beyond_the_domain_is_refused)
{
    rwedge_contact *contact = create_wedge(0.1, 1e30, 1e30, 0.5);
    load(contact, 1, 0); /* stresses below 1e-30 */
    double factor = 7;
    assert_int_equal(rwedge_contact_yield_factor(contact, 0.3, 1e60, &factor, NULL, NULL),
                     RWEDGE_ERANGE);
    assert_true(factor == 7);
}

/* Many corners, off the centre where M is not 0: the patches that end far away count together. */
static rwedge_contact *worn(double a, double M, int corners)
{
    rwedge_contact *contact = APPLY(create(a, 0.5), {0.5, M, 0, 0});
    for (int i = 1; i < corners; i++)
        apply(contact, 0.5, M, (i % 2 ? 0.2 : -0.2) * (1 - i / (corners + 1.0)), 0);
    return contact;
}

static void assert_same_fields(const rwedge_contact *contact, const rw_neighbourhood *n,
                               double centre, double radius, uint64_t *seed)
{
    double x[RW_BATCH], y[RW_BATCH];
    for (int i = 0; i < RW_BATCH; i++) {
        const double angle = PI * random_fraction(seed), r = radius * random_fraction(seed);
        x[i] = centre + r * cos(angle);
        y[i] = i % 4 ? r * sin(angle) : 0;
    }
    rw_contact_fields fast, all;
    rw_neighbourhood_fields(contact, n, RW_BATCH, x, y, &fast);
    rw_contact_fields_at(contact, 1, contact->memory.count, RW_BATCH, x, y, &all);
    for (int i = 0; i < RW_BATCH; i++) {
        assert_within(fast.tangential.G_re[i], all.tangential.G_re[i], 1e-9);
        assert_within(fast.tangential.G_im[i], all.tangential.G_im[i], 1e-9);
        assert_within(fast.tangential.H_re[i], all.tangential.H_re[i], 1e-9);
        assert_within(fast.tangential.H_im[i], all.tangential.H_im[i], 1e-9);
    }
}

CLAIM(a_neighbourhood_has_the_fields_of_all_patches)
{
    uint64_t seed = 7;
    static const double CASES[][2] = {{0, 0}, {0.1, 0}, {0.1, 0.1}, {0, -0.1}, {9, 0.2}};
    for (int k = 0; k < 5; k++) {
        rwedge_contact *contact = worn(CASES[k][0], CASES[k][1], 60);
        const rw_neighbourhood whole = rw_neighbourhood_whole(contact);
        size_t fewest = contact->memory.count;
        for (size_t i = 1; i + 1 < contact->memory.count; i++) {
            const double at = rw_mark_edge(contact->memory.corners[i].patch, i % 2 ? 1 : -1);
            rw_neighbourhood n = whole;
            for (double r = 0.3; r > 1e-6; r *= 0.4) {
                n = rw_neighbourhood_within(contact, &n, at, r);
                assert_same_fields(contact, &n, at, r, &seed);
            }
            fewest = n.last - n.first < fewest ? n.last - n.first : fewest;
            n = rw_neighbourhood_within(contact, &n, at + 1, 0.1); /* it is not inside */
            assert_int_equal(n.last - n.first, whole.last - whole.first);
        }
        assert_int_equal(fewest, 1);
    }
}
