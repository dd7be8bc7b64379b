/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The load at which a pad of any kind first yields in full sliding. */
#include "histories.h"

static const double K = 0.1;

static double yield_load(const rwedge_contact *contact, double nu, double k, double *x, double *y)
{
    double P = -1;
    assert_ok(rwedge_contact_yield_load(contact, nu, k, &P, x, y));
    return P;
}

CLAIM(of_a_wedge_it_is_the_yield_load)
{
    for (double f = 0; f < 0.7; f += 0.2)
        for (double nu = 0.2; nu < 0.5; nu += 0.15)
            for (double k = 0.02; k < 1; k *= 5) {
                double x, y, limit, expected_x, expected_y;
                const rwedge_contact *contact = create(1, f);
                const double P = rwedge_yield_load(THETA, 1, A, f, nu, k),
                             b = rwedge_half_width(THETA, 1, A, P);
                assert_close(yield_load(contact, nu, k, &x, &y), P, 1e-11);
                assert_ok(rwedge_yield_point(1 / b, f, nu, &limit, &expected_x, &expected_y));
                assert_within(x, expected_x * b, 1e-5 * b);
                assert_within(y, expected_y * b, 1e-5 * b);
            }
}

/* b^2 = 2 R A P/pi, and P/(b k) is the elastic limit of Hertz' contact. */
CLAIM(a_cylinder_yields_where_hertz_contact_does)
{
    for (double R = 1e-6; R < 1e7; R *= 1e3) {
        const double limit = rwedge_elastic_limit(1, 0.2, 0.3);
        assert_close(yield_load(create_flat(0, R, A, 0.2), 0.3, 1e-4, NULL, NULL),
                     limit * 1e-4 * limit * 1e-4 * 2 * R * A / PI, 1e-11);
    }
}

static const double X[] = {-2, -0.5, 0.3, 3}, SLOPE[] = {-0.1, -0.01, 0.02, 0.15};
static const double TURNED_X[] = {-3, -0.3, 0.5, 2}, TURNED[] = {-0.15, -0.02, 0.01, 0.1};

CLAIM(under_it_the_factor_is_one_to_either_side)
{
    const double f = 0.3;
    for (int side = -1; side <= 1; side += 2) {
        rwedge_contact *contact = create_profile(4, X, SLOPE, f),
                       *turned = create_profile(4, TURNED_X, TURNED, f);
        double x, y, there, factor;
        load(contact, 0.01, side * f * 0.01);
        load(turned, 0.02, -side * f * 0.02);
        const double P = yield_load(contact, 0.3, 0.03, &x, &y);
        assert_close(yield_load(turned, 0.3, 0.03, &there, NULL), P, 1e-11);
        assert_within(there, -x, 1e-5);
        load(contact, P, side * f * P);
        assert_ok(rwedge_contact_yield_factor(contact, 0.3, 0.03, &factor, NULL, NULL));
        assert_close(factor, 1, 1e-11);
    }
}

/* What the contact has been through does not matter, and stays. */
CLAIM(the_contact_stays_as_it_was)
{
    rwedge_contact *contact = APPLY(allowing(create_flat(0.5, 10, A, 0.4), 1e-3), {0.2, 0, 0, 0},
                                    {0.2, 0.01, 0.02, 0.1}, {0.1, 0, 0.03, -0.05});
    const contact_state before = state_of(contact);
    const double P = yield_load(contact, 0.3, K, NULL, NULL);
    assert_close(yield_load(create_flat(0.5, 10, A, 0.4), 0.3, K, NULL, NULL), P, 1e-15);
    assert_state(contact, before);
}

/* A held pad keeps its tilt: the peak is that of such a contact. */
CLAIM(a_held_pad_keeps_its_tilt)
{
    rwedge_contact *contact = create_flat(0.5, 10, A, 0.2);
    double factor;
    assert_ok(rwedge_contact_set_rotation(contact, 1));
    assert_ok(rwedge_contact_guide(contact, 0, 0.01, 0, 0));
    const double P = yield_load(contact, 0.3, K, NULL, NULL);
    assert_ok(rwedge_contact_guide(contact, P, 0.01, 0.2 * P, 0));
    assert_ok(rwedge_contact_yield_factor(contact, 0.3, K, &factor, NULL, NULL));
    assert_close(factor, 1, 1e-11);
    assert_true(P < 0.99 * yield_load(create_flat(0.5, 10, A, 0.2), 0.3, K, NULL, NULL));
}

CLAIM(the_coupling_of_unlike_bodies_counts)
{
    rwedge_contact *contact = create(1, 0.5);
    double limit, x, y, factor;
    assert_ok(rwedge_contact_set_beta(contact, 0.2));
    const double P = yield_load(contact, 0.3, K, &x, &y);
    load(contact, P, 0.5 * P);
    assert_ok(rwedge_contact_yield_factor(contact, 0.3, K, &factor, NULL, NULL));
    assert_close(factor, 1, 1e-11);
    const double b = rwedge_contact_half_width(contact);
    assert_ok(rwedge_sliding_limit(1 / b, 0.1, 0.5, 0.3, 0, &limit, &x, &y));
    assert_close(P, limit * b * K, 1e-9);
}

CLAIM(a_kink_yields_at_once_or_where_the_contact_comes_to_it)
{
    double x = 7, y = 7;
    assert_true(yield_load(create(0, 0.3), 0.3, K, &x, &y) == 0);
    assert_true(x == 0 && y == 0);
    assert_true(yield_load(create(0, 0), 0.3, K, NULL, NULL) == 0);
    /* a circle, whose slope jumps at +-1: b = 1 at P = pi/(2 A R), R = 100 */
    const double kinked[] = {-1, -1, 1, 1}, slope[] = {-0.1, -0.01, 0.01, 0.1};
    assert_close(yield_load(create_profile(4, kinked, slope, 0), 0.3, 1, NULL, NULL),
                 PI / (2 * A * 100), 1e-6);
}

CLAIM(what_no_load_yields_is_absent)
{
    double P = 7, x = 7, y = 7;
    assert_int_equal(rwedge_contact_yield_load(create_flat(0, 1, A, 0.2), 0.3, 100, &P, &x, &y),
                     RWEDGE_EABSENT);
    /* the sharp wedge without friction and volume change has a finite peak, (2/pi) theta/A */
    const double bound = 2 / PI * THETA / A;
    assert_int_equal(rwedge_contact_yield_load(create(0, 0), 0.5, 1.001 * bound, &P, &x, &y),
                     RWEDGE_EABSENT);
    assert_true(P == 7 && x == 7 && y == 7);
    assert_true(yield_load(create(0, 0), 0.5, 0.999 * bound, NULL, NULL) == 0);
}

CLAIM(arguments_outside_their_domain_are_refused)
{
    double P = 7;
    const rwedge_contact *contact = create(1, 0.2);
    assert_int_equal(rwedge_contact_yield_load(contact, 0.6, K, &P, NULL, NULL), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_yield_load(contact, 0.3, 0, &P, NULL, NULL), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_yield_load(contact, 0.3, K, NULL, NULL, NULL), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_yield_load(NULL, 0.3, K, &P, NULL, NULL), RWEDGE_ENULL);
    assert_true(P == 7);
}
