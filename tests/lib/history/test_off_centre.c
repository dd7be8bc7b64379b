/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contacts with moment and bulk tension: known answers, equilibrium, slip and energy. */
#include "histories.h"
#include "history/gap.h"
#include "quadrature.h"

#include <fenv.h>

static const double F = 0.5;

/* NAFEMS' contact benchmark CB1: a steel cylinder of R = 50 on aluminium, 35 kN/mm. */
CLAIM(nafems_cylinder)
{
    const double compliance = rwedge_compliance(210e3, 0.3, 70e3, 0.3), a = 20;
    rwedge_contact *contact = APPLY(create_wedge(a / 50, a, compliance, 0), {35e3, 0, 0, 0});
    assert_within(edges_of(contact).right, 6.2146, 5e-5);
    assert_within(-pressure(contact, 0), 3585.36, 5e-2); /* of 3585.37 by rounding of its inputs */
}

/* ---- Slip and energy ---- */

/* The loop of Q and sigma: each cycle dissipates as much, and twice as much as the slip at its ends
 * times the traction, which is f p all the time. */
static double friction_times_slip(double x, void *contact)
{
    return F * fabs(pressure(contact, x) * slip(contact, x));
}

/* Its integral: between the edges, the ends of all patches, and those of the rounding. */
static double work_of_slip(const rwedge_contact *contact)
{
    const rw_patch whole = edges_of(contact);
    double points[32] = {-contact->geometry.a, contact->geometry.a};
    size_t n = 2;
    assert_true(2 * contact->memory.count <= sizeof points / sizeof *points);
    for (size_t i = 1; i < contact->memory.count; i++) {
        points[n++] = contact->memory.corners[i].patch.left;
        points[n++] = contact->memory.corners[i].patch.right;
    }
    for (size_t i = 0; i < n; i++)
        points[i] = fmax(whole.left, fmin(whole.right, points[i]));
    return integral(friction_times_slip, contact, n - 1, points);
}

CLAIM(energy_is_friction_times_slip)
{
    static const double moments[] = {0, 0.1, -0.2};
    for (int i = 0; i < 3; i++) {
        rwedge_contact *contact = APPLY(create(0.4, F), {0.5, moments[i], 0, 0});
        apply(contact, 0.5, moments[i], 0.2, 0.02); /* all slip has been one way */
        const double first = rwedge_contact_dissipated_energy(contact);
        assert_close(first, work_of_slip(contact), 1e-10);
        apply(contact, 0.5, moments[i], -0.2, -0.02);
        const double second = rwedge_contact_dissipated_energy(contact) - first;
        apply(contact, 0.5, moments[i], 0.2, 0.02);
        const double third = rwedge_contact_dissipated_energy(contact) - first - second;
        assert_close(second, third, 1e-11);
        assert_close(second, 2 * first, 1e-11); /* half of a Masing loop's slip, twice the way */
    }
}

/* The slip begins in the outer of two rings with shear, so that the inner one is common to before
 * and after. */
CLAIM(slip_may_leave_an_inner_ring_alone)
{
    rwedge_contact *contact = APPLY(create(0.4, F), {0.3, 0, 0.05, 0}, {0.5, 0, 0.09, 0});
    assert_true(rwedge_contact_dissipated_energy(contact) == 0);
    apply(contact, 0.5, 0, 0.11, 0.004);
    assert_close(rwedge_contact_dissipated_energy(contact), work_of_slip(contact), 1e-10);
}

CLAIM(a_ring_that_has_not_slipped_has_no_slip)
{
    rwedge_contact *contact = APPLY(create(0.4, 2), {0.5, 0.1, 0, 0}, {0.5, 0.1, 0.8, 0.08});
    const double right = edges_of(contact).right;
    apply(contact, 0.6, 0.12, 0.8, 0.08);
    const rw_patch ring = edges_of(contact);
    assert_true(slip(contact, ring.left) == 0 && slip(contact, ring.right) == 0);
    assert_true(slip(contact, right) != 0);
}

/* Slip began twice, at points that had come into contact at different times. */
CLAIM(slip_has_one_origin_or_none)
{
    rwedge_contact *contact = create(0.4, F);
    load(contact, 0.5, 0);
    load(contact, 0.5, 0.1);
    load(contact, 0.6, 0.1);
    load(contact, 0.6, 0.2);
    apply(contact, 0.6, 0, 0.25, 0.01);
    const double x = 0;
    double w;
    assert_int_equal(rwedge_contact_slip(contact, 1, &x, &w), RWEDGE_EPATH);
    load(contact, 0, 0);
    apply(contact, 0, 0, 0, 0);
    load(contact, 0.5, 0);
    load(contact, 0.6, 0.2); /* the ring slips at once */
    apply(contact, 0.6, 0, 0.25, 0.01);
    assert_int_equal(rwedge_contact_slip(contact, 1, &x, &w), RWEDGE_EPATH);
    APPLY(contact, {0, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, F, 0});
    assert_ok(rwedge_contact_slip(contact, 1, &x, &w));
    apply(contact, 1, 0, 0.6 * F, 1e-9); /* after full sliding: it was counted from there */
    assert_int_equal(rwedge_contact_slip(contact, 1, &x, &w), RWEDGE_EPATH);
}

/* A moment without slip changes no slip: that of places that came into contact after the first slip
 * was counted from before it. */
CLAIM(places_that_came_after_the_first_slip_have_none)
{
    rwedge_contact *contact = APPLY(create(0.4, F), {0.01, 0, 0, 0}, {0.01, 0, 0.003, 0},
                                    {1, 0, 0.003, 0}, {1, 0.35, 0.003, 0});
    assert_within(slip(contact, 0.4), 0, 0);
}

/* A tension that follows slip about the centre leaves it known: as after one that was always there,
 * as small as rounding. */
CLAIM(slip_about_the_centre_goes_on_off_the_centre)
{
    rwedge_contact *centred = create(0.4, F), *tense = create(0.4, F);
    static const double Q[] = {0.3, 0.4, -0.3}, sigma[] = {0, 0.01, -0.01};
    load(centred, 1, 0);
    load(tense, 1, 0);
    for (int i = 0; i < 3; i++) {
        apply(centred, 1, 0, Q[i], sigma[i]);
        apply(tense, 1, 0, Q[i], i == 0 ? 1e-11 : sigma[i]);
        for (double x = -2.2; x < 2.3; x += 0.4)
            assert_within(slip(centred, x), slip(tense, x), 1e-9 * F * THETA);
    }
}

/* Where the contact falls with moment and tension, the energy has no single integral; where rings
 * come into contact that slip at once, neither has the slip an origin. */
CLAIM(energy_and_slip_say_where_they_are_not_known)
{
    rwedge_contact *contact =
        APPLY(create(0.4, F), {0.5, 0.1, 0, 0}, {0.5, 0.1, 0.15, 0.01}, {0.45, 0.09, 0.15, 0.01});
    assert_nan(rwedge_contact_dissipated_energy(contact));
    double x = 0, w;
    assert_ok(rwedge_contact_slip(contact, 1, &x, &w));
    apply(contact, 0.6, 0.12, 0.15, 0.01);
    assert_ok(rwedge_contact_slip(contact, 1, &x, &w));
    apply(contact, 0.6, 0.12, -0.1, -0.01);
    assert_int_equal(rwedge_contact_slip(contact, 1, &x, &w), RWEDGE_EPATH);
    apply(contact, 0, 0, 0, 0); /* all is forgotten */
    APPLY(contact, {0.5, 0.1, 0, 0}, {0.5, 0.1, 0.1, 0.01});
    apply(contact, 0.52, 0.104, 0.15, 0.01); /* the ring slips at once */
    assert_int_equal(rwedge_contact_slip(contact, 1, &x, &w), RWEDGE_EPATH);
    APPLY(contact, {0, 0, 0, 0}, {0.5, 0.1, 0, 0});
    assert_ok(rwedge_contact_slip(contact, 1, &x, &w));
}

/* The integral once went on without end. */
CLAIM(a_patch_without_width_ends_the_integral_of_its_gap)
{
    assert_nan(rw_patch_gap(&(rw_geometry){.a = 0.4}, (rw_patch){0.1, 0.1}, 0.2));
    assert_nan(rw_patch_gap(&(rw_geometry){.a = 0}, (rw_patch){0.5, 0.5}, 0.6));
}

/* So small a force moves one edge of the slip by less than the rounding of its place. */
CLAIM(the_energy_of_an_edge_that_stays_divides_by_nothing)
{
    const double a = 1e-60, compliance = 0.9999, P = 1,
                 M = 0.25 * P * rwedge_half_width(1, a, compliance, P);
    rwedge_contact *contact = APPLY(create_wedge(1, a, compliance, 0.3), {P, M, 0, 0});
    const double sigma = rwedge_contact_largest_tension_step(contact, 3e-9);
    feclearexcept(FE_ALL_EXCEPT);
    apply(contact, P, M, 3e-9, sigma);
    assert_int_equal(fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW), 0);
    assert_true(rwedge_contact_dissipated_energy(contact) >= 0);
}
