/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A rig that prescribes a displacement. The expected displacement of a cylinder is Mindlin's sum of
 * flat punches; energies are force times displacement. */
#include "histories.h"

static const double F = 0.5, R = 100, P = 1, COMPLIANCE = 0.3;

static rwedge_contact *cylinder(void)
{
    return create_flat(0, R, A, F);
}

static double drive(rwedge_contact *contact, double load, double displacement, double compliance)
{
    double Q = NAN;
    assert_ok(rwedge_contact_drive(contact, load, 0, 0, displacement, compliance, &Q));
    return Q;
}

/* dQ moves remote points by (A dQ/pi) ln(b/c) further than a bonded contact does, c being the stick
 * zone under Q, b sqrt(1 - Q/(f P)); the integral to Q. */
static double mindlin(double Q)
{
    const double limit = F * P, rest = 1 - Q / limit;
    return A / (2 * PI) * (rest > 0 ? limit * rest * log(rest) + Q : Q);
}

CLAIM(partial_slip_under_a_displacement_is_mindlins)
{
    for (int i = 1; i < 20; i++) {
        const double Q = i / 20.0 * F * P;
        rwedge_contact *contact = cylinder();
        load(contact, P, 0);
        assert_close(drive(contact, P, mindlin(Q) + COMPLIANCE * Q, COMPLIANCE), Q, 1e-11);
        assert_close(rwedge_contact_stick_half_width(contact) / rwedge_contact_half_width(contact),
                     sqrt(1 - Q / (F * P)), 1e-11);
    }
}

/* To and fro with full sliding: the area of force times displacement is the energy. The rig is a
 * spring, which gives its energy back. */
CLAIM(the_energy_is_force_times_displacement)
{
    enum { STEPS = 4000 };
    for (int k = 0; k < 2; k++) {
        const double compliance = k * COMPLIANCE, most = 3 * (mindlin(F * P) + compliance * F * P);
        rwedge_contact *contact = cylinder();
        double before = most, last = drive(contact, P, most, compliance), area = 0;
        const double energy = rwedge_contact_dissipated_energy(contact);
        for (int i = 1; i <= STEPS; i++) {
            const double d = most * cos(2 * PI * i / STEPS), Q = drive(contact, P, d, compliance);
            area += (Q + last) / 2 * (d - before);
            before = d;
            last = Q;
        }
        assert_close(last, F * P, 1e-12);
        assert_close(rwedge_contact_dissipated_energy(contact) - energy, area, 7e-4);
    }
}

/* The rest beyond f P is sliding: f P times it is dissipated, and the way back begins there. */
CLAIM(beyond_friction_the_rest_is_sliding)
{
    const double way = 0.25, at_limit = mindlin(F * P) + COMPLIANCE * F * P;
    rwedge_contact *contact = cylinder(), *other = cylinder();
    load(contact, P, 0);
    load(other, P, 0);
    load(other, P, F * P);
    assert_true(drive(contact, P, at_limit + way, COMPLIANCE) == F * P);
    assert_close(rwedge_contact_dissipated_energy(contact),
                 rwedge_contact_dissipated_energy(other) + F * P * way, 1e-9);
    /* half of the way down: twice the shape of the way up, of half the size */
    const double Q = 0.2 * F * P, change = F * P - Q;
    const double back = 2 * mindlin(change / 2) + COMPLIANCE * change;
    assert_close(drive(contact, P, at_limit + way - back, COMPLIANCE), Q, 1e-10);
}

/* A stiff rig on a contact that has been separated begins where it is then. */
CLAIM(a_contact_that_touches_anew_begins_where_the_rig_is)
{
    rwedge_contact *contact = cylinder();
    drive(contact, P, 7, 0);
    assert_true(drive(contact, 0, 5, 0) == 0);
    assert_within(drive(contact, P, 5, 0), 0, 1e-13);
    assert_close(drive(contact, P, 5 + mindlin(0.1), 0), 0.1, 1e-10);
}

CLAIM(the_state_has_what_the_rig_did)
{
    rwedge_contact *contact = cylinder();
    drive(contact, P, 7, COMPLIANCE);
    rwedge_contact *again = restored(state_of(contact));
    drive(contact, 1.2 * P, 6.99, COMPLIANCE);
    drive(again, 1.2 * P, 6.99, COMPLIANCE);
    assert_state(again, state_of(contact));
}

/* A wedge off the centre, to the error of its displacement. */
CLAIM(what_is_prescribed_is_reached_off_the_centre)
{
    rwedge_contact *contact = create(0.4, F);
    apply(contact, P, 0.05, 0, 0);
    const double b = rwedge_contact_half_width(contact), wanted = 0.01 * THETA;
    double Q;
    assert_ok(rwedge_contact_drive(contact, P, 0.05, 0, wanted, COMPLIANCE, &Q));
    assert_true(Q > 0 && Q < F * P);
    assert_close(rwedge_contact_displacement(contact, b) + COMPLIANCE * Q, wanted, 1e-10);
    assert_int_equal(rwedge_contact_drive(contact, P, 0.05, 0, 1, COMPLIANCE, &Q), RWEDGE_EPATH);
}

CLAIM(what_is_refused_leaves_the_contact)
{
    rwedge_contact *contact = cylinder();
    load(contact, P, 0.1);
    const contact_state before = state_of(contact);
    double Q = 3;
    assert_int_equal(rwedge_contact_drive(contact, -1, 0, 0, 0, 0, &Q), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_drive(contact, P, NAN, 0, 0, 0, &Q), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_drive(contact, P, 0, NAN, 0, 0, &Q), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_drive(contact, P, 0, 0, HUGE_VAL, 0, &Q), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_drive(contact, P, 0, 0, 0, -1, &Q), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_drive(contact, 0, 1, 0, 0, 0, &Q), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_drive(contact, 1e-12, 0, 0, 0, 0, &Q), RWEDGE_ERANGE);
    assert_int_equal(rwedge_contact_drive(NULL, P, 0, 0, 0, 0, &Q), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_drive(contact, P, 0, 0, 0, 0, NULL), RWEDGE_ENULL);
    assert_true(Q == 3);
    assert_state(contact, before);
}
