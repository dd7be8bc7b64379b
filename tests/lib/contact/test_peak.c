/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The largest pressure and the largest slip of a contact, and where they are. */
#include "histories.h"

static const double F = 0.5;

typedef struct {
    double value, x;
} peak;

static peak pressure_peak(const rwedge_contact *contact)
{
    peak p;
    assert_ok(rwedge_contact_peak_pressure(contact, &p.value, &p.x));
    return p;
}

static peak slip_peak(const rwedge_contact *contact)
{
    peak p;
    assert_ok(rwedge_contact_largest_slip(contact, &p.value, &p.x));
    return p;
}

/* ---- Another route: even steps over the contact, and then around the best of them ---- */

typedef double quantity(const rwedge_contact *contact, double x);

enum { STEPS = 5000 };

static peak at_steps(const rwedge_contact *contact, quantity *of, double left, double right)
{
    peak best = {-1, NAN};
    for (int i = 0; i <= STEPS; i++) {
        const double x = i < STEPS ? left + i * ((right - left) / STEPS) : right;
        const double value = fabs(of(contact, x));
        if (value > best.value)
            best = (peak){value, x};
    }
    return best;
}

/* The last steps are 1e-10 of the width. */
static peak dense(const rwedge_contact *contact, quantity *of)
{
    const rw_patch edges = edges_of(contact);
    double left = edges.left, right = edges.right;
    peak best = {-1, NAN};
    for (int round = 0; round < 3; round++) {
        const double step = (right - left) / STEPS;
        best = at_steps(contact, of, left, right);
        left = fmax(edges.left, best.x - step);
        right = fmin(edges.right, best.x + step);
    }
    return best;
}

static void assert_dense(const rwedge_contact *contact)
{
    const peak found = pressure_peak(contact);
    assert_close(found.value, dense(contact, pressure).value, 1e-12);
    assert_close(found.value, -pressure(contact, found.x), 1e-14);
}

static double width_of(const rwedge_contact *contact)
{
    return edges_of(contact).right - edges_of(contact).left;
}

/* ---- Pressure ---- */

/* A cylinder of R = 10: p0 = sqrt(2 P/(pi A R)), above the resultant, x = M/P. */
CLAIM(the_largest_pressure_of_a_cylinder_is_that_of_Hertz)
{
    const double x[] = {-1, 1}, slope[] = {-0.1, 0.1}, P = 0.01;
    for (double shift = -0.2; shift < 0.3; shift += 0.2) {
        const rw_loads to = {P, shift * P, 0, 0};
        rwedge_contact *cylinder = APPLY(create_flat(0, 10, A, F), to),
                       *same = APPLY(create_profile(2, x, slope, F), to);
        const double p0 = sqrt(2 * P / (PI * A * 10)), b = width_of(cylinder) / 2;
        assert_close(pressure_peak(cylinder).value, p0, 1e-14);
        assert_within(pressure_peak(cylinder).x, shift, 1e-14 * b);
        assert_close(pressure_peak(same).value, p0, 1e-13);
        assert_within(pressure_peak(same).x, shift, 1e-7 * b);
    }
}

CLAIM(the_largest_pressure_of_a_wedge_without_moment_is_in_the_middle)
{
    const double a = 0.4;
    for (double P = 1e-4; P < 10; P *= 3) {
        const rwedge_contact *contact = APPLY(create(a, F), {P, 0, F * P / 2, 0});
        const double alpha = a / rwedge_contact_half_width(contact);
        assert_true(pressure_peak(contact).x == 0);
        assert_true(pressure_peak(contact).value == THETA / A * rwedge_peak_pressure(alpha));
    }
}

CLAIM(the_largest_pressure_of_a_tilted_wedge_is_found)
{
    for (double a = 0.4; a > 1e-6; a /= 7) {
        rwedge_contact *contact = APPLY(create(a, F), {0.3, 0.05, 0, 0}),
                       *mirrored = APPLY(create(a, F), {0.3, -0.05, 0, 0});
        assert_dense(contact);
        assert_true(fabs(pressure_peak(contact).x) < a && pressure_peak(contact).x != 0);
        assert_close(pressure_peak(mirrored).value, pressure_peak(contact).value, 1e-13);
        assert_within(pressure_peak(mirrored).x, -pressure_peak(contact).x,
                      1e-7 * width_of(contact));
    }
}

/* A flat presses most beyond its corners, with a moment on one side. */
CLAIM(the_largest_pressure_of_a_flat_pad_is_beyond_a_corner)
{
    const double flat[] = {0.1, 0.5, 0.9, 0.99};
    for (int i = 0; i < 8; i++) {
        const double a = flat[i / 2], M = i % 2 * 1e-4;
        const rwedge_contact *contact = APPLY(create_flat(a, 10, A, F), {0.02, M, 0, 0});
        assert_dense(contact);
        const double x = pressure_peak(contact).x;
        assert_true(M > 0 ? x > a : fabs(x) > a);
        assert_true(pressure_peak(contact).value > -pressure(contact, 0));
    }
}

/* Each of the corners of high curvature has a top; the highest is the one that the load presses. */
CLAIM(the_highest_of_several_tops_is_found)
{
    const double x[] = {-1, -0.61, -0.6, -0.21, -0.2, 0.2, 0.202, 0.5, 0.51, 1},
                 slope[] = {-0.1, -0.09, -0.05, -0.045, -0.015, -0.01, 0.02, 0.025, 0.06, 0.1};
    double highest[3];
    for (int i = 0; i < 3; i++) {
        const rwedge_contact *contact =
            APPLY(create_profile(10, x, slope, F), {0.1, 0.02 * (i - 1), 0, 0});
        assert_dense(contact);
        highest[i] = pressure_peak(contact).x;
    }
    assert_true(highest[0] < highest[2]);
}

/* Along the history the pressure is that of P and M alone. */
CLAIM(the_largest_pressure_does_not_depend_on_shear)
{
    const rwedge_contact *plain = APPLY(create(0.1, F), {0.3, 0.02, 0, 0}),
                         *computed = APPLY(allowing(create(0.1, F), 1e-3), {0.3, 0.02, 0.05, 0},
                                           {0.3, 0.02, -0.02, 0.3});
    assert_true(pressure_peak(plain).value == pressure_peak(computed).value);
    assert_true(pressure_peak(plain).x == pressure_peak(computed).x);
}

static void assert_no_largest_pressure(const rwedge_contact *contact)
{
    double value = 7, x = 7;
    assert_int_equal(rwedge_contact_peak_pressure(contact, &value, &x), RWEDGE_EABSENT);
    assert_true(value == 7 && x == 7);
}

CLAIM(there_is_no_largest_pressure_where_it_is_infinite_or_nothing_touches)
{
    const double x[] = {-1, -0.5, -0.5, 1}, slope[] = {-0.1, -0.05, -0.03, 0.1};
    assert_no_largest_pressure(create(0.4, F));
    assert_no_largest_pressure(APPLY(create(0, F), {0.3, 0, 0, 0}));
    assert_no_largest_pressure(APPLY(create(0, F), {0.3, 0.02, 0, 0}));
    rwedge_contact *with_kink = create_profile(4, x, slope, F);
    apply(with_kink, 1e-4, 0, 0, 0);
    assert_dense(with_kink); /* the kink is not in contact */
    apply(with_kink, 0.2, 0, 0, 0);
    assert_true(edges_of(with_kink).left < -0.5);
    assert_no_largest_pressure(with_kink);
    double value;
    assert_int_equal(rwedge_contact_peak_pressure(NULL, &value, &value), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_peak_pressure(with_kink, NULL, &value), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_peak_pressure(with_kink, &value, NULL), RWEDGE_ENULL);
}

/* ---- Slip ---- */

CLAIM(the_largest_slip_is_found)
{
    rwedge_contact *contact = APPLY(create(0.1, F), {0.3, 0, 0, 0});
    assert_true(slip_peak(contact).value == 0 && slip_peak(contact).x == edges_of(contact).left);
    const double Q[] = {0.1, -0.05, 0.02};
    for (int i = 0; i < 3; i++) {
        load(contact, 0.3, Q[i]);
        const peak found = slip_peak(contact), expected = dense(contact, slip);
        assert_true(found.value > 0);
        assert_close(found.value, expected.value, 1e-9); /* with a corner where slip turned */
        assert_true(found.value == fabs(slip(contact, found.x)));
    }
}

CLAIM(there_is_no_largest_slip_where_slip_is_not_known_or_nothing_touches)
{
    double value = 7, x = 7;
    assert_int_equal(rwedge_contact_largest_slip(create(0.4, F), &value, &x), RWEDGE_EABSENT);
    const rwedge_contact *slid =
        APPLY(create(0.4, F), {0.3, 0.02, 0, 0}, {0.3, 0.02, F * 0.3, 0}, {0.3, 0.02, 0.1, 0});
    assert_int_equal(rwedge_contact_largest_slip(slid, &value, &x), RWEDGE_EPATH);
    assert_true(value == 7 && x == 7);
    assert_int_equal(rwedge_contact_largest_slip(NULL, &value, &x), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_largest_slip(slid, NULL, &x), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_largest_slip(slid, &value, NULL), RWEDGE_ENULL);
}
