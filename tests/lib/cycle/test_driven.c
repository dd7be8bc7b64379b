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

/* A displacement that is the same but for rounding, as where a cycle begins anew: Q went back by
 * 1e-14 of itself, and a tension after it did not converge. */
CLAIM(what_is_lost_in_rounding_does_not_turn_the_bodies_round)
{
    const double way = 2 * (mindlin(F * P) + COMPLIANCE * F * P);
    rwedge_contact *contact = cylinder();
    assert_true(drive(contact, P, way, COMPLIANCE) == F * P);
    assert_true(drive(contact, P, way * (1 - 1e-15), COMPLIANCE) == F * P);
    assert_true(drive(contact, P, way * (1 - 1e-12), COMPLIANCE) < F * P);
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

/* Also where the bodies were apart. */
CLAIM(displacements_count_from_the_first_half_width)
{
    rwedge_contact *contact = cylinder();
    drive(contact, P, 0, 0);
    const double b = rwedge_contact_half_width(contact);
    drive(contact, 0, 0, 0);
    drive(contact, 2 * P, 0.1, 0);
    assert_close(rwedge_contact_displacement(contact, b), 0.1, 1e-10);
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
}

/* ---- Full sliding off the centre ---- */

/* A cylinder under a moment is one at another place: it moves as in the middle does. */
CLAIM(a_cylinder_under_a_moment_slides_like_one_in_the_middle)
{
    const double M = 0.3, way = 0.25, limit = F * P;
    const double at_limit = mindlin(limit) + COMPLIANCE * limit;
    rwedge_contact *contact = cylinder(), *other = cylinder();
    double Q;
    apply(contact, P, M, 0, 0);
    load(other, P, 0);
    for (int i = -4; i <= 4; i++) { /* up, on and back, as far as to slide the other way */
        const double displacement = at_limit + way - i * i * 0.1;
        assert_ok(rwedge_contact_drive(contact, P, M, 0, displacement, COMPLIANCE, &Q));
        assert_within(Q, drive(other, P, displacement, COMPLIANCE), 3e-6 * limit);
        assert_within(rwedge_contact_displacement(contact, rwedge_contact_half_width(contact)) +
                          COMPLIANCE * Q,
                      displacement, 1e-10);
        assert_close(rwedge_contact_dissipated_energy(contact) + 1,
                     rwedge_contact_dissipated_energy(other) + 1, 1e-5);
    }
}

/* int q x dx; what a tension pulls at. */
static double pulled(const rwedge_contact *contact)
{
    enum { PLACES = 100 };
    double left, right, sum = 0;
    assert_ok(rwedge_contact_edges(contact, &left, &right));
    for (int i = 0; i < PLACES; i++) {
        const double angle = PI * ((i + 0.5) / PLACES - 0.5),
                     x = (left + right) / 2 + (right - left) / 2 * sin(angle);
        sum += shear(contact, x) * x * (right - left) / 2 * cos(angle) * PI / PLACES;
    }
    return sum;
}

typedef struct {
    double M, sigma, phase, variation;
} swing;

/* The work of force and tension in the second cycle over the energy; what the trapezoids of 200
 * steps lose is 3e-4. */
CLAIM(the_energy_off_the_centre_is_the_work_of_force_and_tension)
{
    enum { STEPS = 200 };
    static const swing SWINGS[] = {{0.3, 0.02, 0.3, 0}, {0, 0.04, 1.5, 0}, {0.2, 0.02, 0, 0.1}};
    for (int k = 0; k < 3; k++) {
        const swing to = SWINGS[k];
        rwedge_contact *contact = allowing(cylinder(), 1e-4);
        double d = 0, Q = 0, sigma = 0, pull = 0, work = 0, before = 0;
        apply(contact, P, to.M, 0, 0);
        for (int i = 1; i <= 2 * STEPS; i++) {
            const double angle = 2 * PI * i / STEPS, last[] = {d, Q, sigma, pull};
            d = 0.4 * sin(angle);
            sigma = to.sigma * sin(angle + to.phase);
            assert_ok(rwedge_contact_drive(contact, P * (1 + to.variation * sin(angle)), to.M,
                                           sigma, d, COMPLIANCE, &Q));
            pull = i < STEPS ? 0 : pulled(contact);
            work += (Q + last[1]) / 2 * (d - last[0]) +
                    A / 4 * (pull + last[3]) / 2 * (sigma - last[2]);
            if (i == STEPS) {
                before = rwedge_contact_dissipated_energy(contact);
                work = 0;
            }
        }
        assert_close(rwedge_contact_dissipated_energy(contact) - before, work, 7e-4);
    }
}

CLAIM(the_state_has_how_it_slid_off_the_centre)
{
    rwedge_contact *contact = allowing(cylinder(), 1e-4);
    double Q, same;
    apply(contact, P, 0.3, 0, 0);
    assert_ok(rwedge_contact_drive(contact, P, 0.3, 0.02, 1, COMPLIANCE, &Q));
    rwedge_contact *again = restored(state_of(contact));
    for (int i = 1; i < 4; i++) {
        const double there = 1 - 0.3 * i;
        assert_ok(rwedge_contact_drive(contact, P, 0.3, 0.02 - 0.01 * i, there, COMPLIANCE, &Q));
        assert_ok(rwedge_contact_drive(again, P, 0.3, 0.02 - 0.01 * i, there, COMPLIANCE, &same));
        assert_true(Q == same);
        assert_state(again, state_of(contact));
    }
}

/* Unlike bodies, pressed first: in partial slip, with the tolerance of their computed loads. */
CLAIM(unlike_bodies_reach_what_is_prescribed_in_partial_slip)
{
    rwedge_contact *contact = cylinder();
    double Q;
    assert_ok(rwedge_contact_set_beta(contact, -0.1));
    assert_ok(rwedge_contact_allow_error(contact, 1e-2));
    assert_ok(rwedge_contact_drive(contact, P, 0, 0, 0, COMPLIANCE, &Q));
    assert_true(Q == 0);
    const double b = rwedge_contact_half_width(contact);
    assert_ok(rwedge_contact_drive(contact, P, 0, 0, 0.1, COMPLIANCE, &Q));
    assert_within(rwedge_contact_displacement(contact, b) + COMPLIANCE * Q, 0.1, 1e-9);
    assert_true(Q > 0.2 * F * P && Q < F * P);
    assert_int_equal(rwedge_contact_drive(contact, P, 0, 0, 9, COMPLIANCE, &Q), RWEDGE_EPATH);
}

/* Without a rig that prescribes it nothing tells how far it slides. */
CLAIM(without_a_rig_the_slip_of_sliding_off_the_centre_is_not_known)
{
    rwedge_contact *contact = cylinder();
    double slip;
    const double x = 0;
    apply(contact, P, 0.3, 0, 0);
    apply(contact, P, 0.3, F * P, 0);
    assert_int_equal(rwedge_contact_slip(contact, 1, &x, &slip), RWEDGE_EPATH);
}

/* ---- A cycle ---- */

enum { LOADS = 40 };

typedef struct {
    double P[LOADS], M[LOADS], sigma[LOADS], displacement[LOADS];
    double Q[LOADS];
} rig_loads;

/* To and fro about the displacement of the contact, P as well where it varies. */
static rig_loads rig_cycle(double amplitude, double variation)
{
    rig_loads to = {.P = {0}};
    for (int i = 0; i < LOADS; i++) {
        const double phase = 2 * PI * (i + 1) / LOADS;
        to.P[i] = P * (1 + variation * sin(phase));
        to.displacement[i] = amplitude * cos(phase);
    }
    return to;
}

static void destroy_cycle(void *cycle)
{
    rwedge_cycle_destroy(cycle);
}

static rwedge_cycle *driven_cycle(const rwedge_contact *contact, rig_loads *to, double compliance)
{
    rwedge_cycle *cycle = NULL;
    assert_ok(rwedge_cycle_create_driven(contact, LOADS, to->P, to->M, to->sigma, to->displacement,
                                         compliance, &cycle));
    free_after_claim(cycle, destroy_cycle);
    assert_ok(rwedge_cycle_forces(cycle, LOADS, to->Q));
    return cycle;
}

/* The same loads on the contact itself. */
static void drive_all(rwedge_contact *contact, const rig_loads *to, double compliance)
{
    for (int i = 0; i < LOADS; i++)
        assert_true(drive(contact, to->P[i], to->displacement[i], compliance) == to->Q[i]);
}

/* In gross slip the middle of a cylinder slips what is left of the way, twice in a cycle, under f
 * times the largest pressure. */
CLAIM(in_gross_slip_all_places_slip_what_is_left_of_the_way)
{
    const double amplitude = 2, at_reversal = mindlin(F * P) + COMPLIANCE * F * P;
    rig_loads to = rig_cycle(amplitude, 0);
    rwedge_contact *contact = cylinder();
    drive(contact, P, amplitude, COMPLIANCE);
    rwedge_cycle *cycle = driven_cycle(contact, &to, COMPLIANCE);
    const double slid = 2 * amplitude - 2 * at_reversal, x = 0,
                 p0 = 2 * P / (PI * rwedge_contact_half_width(contact));
    double slip, f1, f2, energy, left, right;
    assert_ok(rwedge_cycle_friction(cycle, 1, &x, &slip, &f1, &f2, &energy));
    assert_close(slip, slid, 1e-9);
    assert_close(energy, 2 * F * p0 * slid, 1e-9);
    assert_int_equal(rwedge_cycle_permanent_stick(cycle, &left, &right), RWEDGE_EABSENT);
    assert_close(to.Q[LOADS - 1], F * P, 1e-12);
}

/* The integral over the contact; of 4000 places it errs by 2e-6, of 1000 by 1e-5. */
static double energy_of_places(const rwedge_contact *contact, const rwedge_cycle *cycle, int places)
{
    const double b = 1.2 * rwedge_contact_half_width(contact);
    double sum = 0;
    for (int i = 0; i < places; i++) {
        const double x = b * sin(PI * ((i + 0.5) / places - 0.5));
        double slip, f1, f2, energy;
        assert_ok(rwedge_cycle_friction(cycle, 1, &x, &slip, &f1, &f2, &energy));
        sum += energy * b * cos(PI * ((i + 0.5) / places - 0.5)) * PI / places;
    }
    return sum;
}

/* Under constant P, and under a P that changes while it slides, whose steps are cut into parts. */
CLAIM(a_driven_cycle_has_the_forces_and_the_energy_of_its_contact)
{
    static const double variation[] = {0, 0.1}, tolerance[] = {1e-5, 2e-3};
    for (int i = 0; i < 2; i++) {
        rig_loads to = rig_cycle(0.5, variation[i]);
        rwedge_contact *contact = cylinder();
        drive(contact, P, 0.5, COMPLIANCE);
        rwedge_cycle *cycle = driven_cycle(contact, &to, COMPLIANCE);
        const double sum = energy_of_places(contact, cycle, 4000);
        const double before = rwedge_contact_dissipated_energy(contact);
        drive_all(contact, &to, COMPLIANCE);
        assert_close(sum, rwedge_contact_dissipated_energy(contact) - before, tolerance[i]);
    }
}

/* Off the centre: under a moment and a tension, in gross slip both ways. */
CLAIM(a_driven_cycle_off_the_centre_has_the_energy_of_its_contact)
{
    static const double variation[] = {0, 0.05}, tolerance[] = {1e-4, 1e-4};
    for (int i = 0; i < 2; i++) {
        rig_loads to = rig_cycle(0.5, variation[i]);
        for (int k = 0; k < LOADS; k++) {
            to.M[k] = 0.3;
            to.sigma[k] = 0.02 * cos(2 * PI * (k + 1) / LOADS + 0.5);
        }
        rwedge_contact *contact = allowing(cylinder(), 1e-4);
        double displacement[LOADS], Q;
        apply(contact, P, 0.3, 0, 0);
        const double b = rwedge_contact_half_width(contact);
        assert_ok(rwedge_contact_drive(contact, P, 0.3, to.sigma[LOADS - 1], 0.5, COMPLIANCE, &Q));
        rwedge_cycle *cycle = driven_cycle(contact, &to, COMPLIANCE);
        const double sum = energy_of_places(contact, cycle, 1000);
        const double before = rwedge_contact_dissipated_energy(contact);
        assert_ok(rwedge_cycle_displacement(cycle, LOADS, b, displacement));
        for (int k = 0; k < LOADS; k++) {
            assert_ok(rwedge_contact_drive(contact, to.P[k], to.M[k], to.sigma[k],
                                           to.displacement[k], COMPLIANCE, &Q));
            assert_within(Q, to.Q[k], 1e-12);
            assert_within(displacement[k] + COMPLIANCE * Q, to.displacement[k], 1e-6);
        }
        assert_close(sum, rwedge_contact_dissipated_energy(contact) - before, tolerance[i]);
    }
}

CLAIM(a_driven_cycle_tells_the_displacement_less_what_the_rig_gives)
{
    double displacement[LOADS];
    rig_loads to = rig_cycle(0.5, 0);
    rwedge_contact *contact = cylinder();
    drive(contact, P, 0.5, COMPLIANCE);
    const double b = rwedge_contact_half_width(contact);
    rwedge_cycle *cycle = driven_cycle(contact, &to, COMPLIANCE);
    assert_ok(rwedge_cycle_displacement(cycle, LOADS, b, displacement));
    for (int i = 0; i < LOADS; i++)
        assert_within(displacement[i] + COMPLIANCE * to.Q[i] - to.displacement[i], 0, 1e-12);
}

CLAIM(a_driven_cycle_that_is_refused_leaves_all_as_it_was)
{
    rig_loads to = rig_cycle(0.5, 0);
    rwedge_contact *contact = cylinder();
    rwedge_cycle *cycle = NULL;
    load(contact, P, 0.1);
    to.P[LOADS - 1] = -1;
    assert_int_equal(rwedge_cycle_create_driven(contact, LOADS, to.P, to.M, to.sigma,
                                                to.displacement, 0, &cycle),
                     RWEDGE_EDOMAIN);
    to.P[LOADS - 1] = P;
    assert_int_equal(rwedge_cycle_create_driven(contact, LOADS, to.P, to.M, to.sigma,
                                                to.displacement, -1, &cycle),
                     RWEDGE_EDOMAIN);
    assert_int_equal(
        rwedge_cycle_create_driven(contact, 0, to.P, to.M, to.sigma, to.displacement, 0, &cycle),
        RWEDGE_ERANGE);
    assert_int_equal(
        rwedge_cycle_create_driven(contact, LOADS, to.P, to.M, to.sigma, NULL, 0, &cycle),
        RWEDGE_ENULL);
    assert_true(cycle == NULL);
    rwedge_cycle *good = driven_cycle(contact, &to, 0);
    assert_int_equal(rwedge_cycle_forces(good, LOADS - 1, to.Q), RWEDGE_ERANGE);
    assert_int_equal(rwedge_cycle_forces(NULL, LOADS, to.Q), RWEDGE_ENULL);
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
