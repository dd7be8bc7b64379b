/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A pad that is held at a tilt. A tilted cylinder is the same cylinder beside: its contact is that
 * without tilt, moved by R times the tilt. */
#include "histories.h"

static const double F = 0.5, R = 100, TILT = 0.02, MOVED = 2; /* R times the tilt */

static rwedge_contact *held(rwedge_contact *contact)
{
    assert_ok(rwedge_contact_set_rotation(contact, 1));
    return contact;
}

static void guide(rwedge_contact *contact, double P, double tilt, double Q, double sigma)
{
    assert_ok(rwedge_contact_guide(contact, P, tilt, Q, sigma));
}

static double moment_of(const rwedge_contact *contact)
{
    double P, M, Q, sigma;
    assert_ok(rwedge_contact_loads(contact, &P, &M, &Q, &sigma));
    return M;
}

static rwedge_contact *trapezoid(void)
{
    static const double x[] = {-3, -2, 1, 2.5}, slope[] = {-0.1, -0.02, 0, 0.12};
    return create_profile(4, x, slope, F);
}

/* Of a wedge, a cylinder, a flat pad and a profile. */
static rwedge_contact *pad(int kind)
{
    return kind == 0   ? create(0.4, F)
           : kind == 1 ? create_flat(0, R, A, F)
           : kind == 2 ? create_flat(1, 20, A, F)
                       : trapezoid();
}

static void assert_same_edges(const rwedge_contact *actual, const rwedge_contact *expected,
                              double moved, double within)
{
    const rw_patch a = edges_of(actual), e = edges_of(expected);
    const double width = e.right - e.left;
    assert_within(a.left - moved, e.left, within * width);
    assert_within(a.right - moved, e.right, within * width);
}

static double peak_friction(const rwedge_contact *contact)
{
    double p0, x0;
    assert_ok(rwedge_contact_peak_pressure(contact, &p0, &x0));
    return F * p0;
}

/* The shear of the contact at 199 places, that of the other one being moved. */
static void assert_moved_shear(const rwedge_contact *actual, const rwedge_contact *expected,
                               double within)
{
    const rw_patch e = edges_of(expected);
    for (int i = 1; i < 200; i++) {
        const double x = e.left + i / 200.0 * (e.right - e.left);
        assert_within(shear(actual, x + MOVED), shear(expected, x),
                      within * peak_friction(expected));
    }
}

/* (P, M) and (P, tilt) are two names of one contact. */
CLAIM(the_moment_that_holds_a_pad_makes_its_tilt)
{
    for (int kind = 0; kind < 4; kind++) {
        rwedge_contact *by_tilt = held(pad(kind)), *by_moment = pad(kind);
        guide(by_tilt, 1.5, 0.03, 0, 0);
        apply(by_moment, 1.5, moment_of(by_tilt), 0, 0);
        assert_same_edges(by_tilt, by_moment, 0, 1e-13);
        assert_close(rwedge_contact_tilt(by_tilt), 0.03, 1e-14);
        assert_close(rwedge_contact_tilt(by_moment), 0.03, 1e-12);
    }
}

/* Loads P, Q, sigma: slip to and fro, and a growing and a receding contact. */
static const double STEPS[][3] = {{1, 0, 0},   {1, 0.3, 0},    {1, -0.2, 0},
                                  {2, 0.4, 0}, {1.2, -0.4, 0}, {1.2, 0.1, 0.002}};
enum { COUNT = sizeof STEPS / sizeof *STEPS };

CLAIM(a_level_pad_that_is_held_has_the_same_bits)
{
    for (int kind = 0; kind < 3; kind++) {
        rwedge_contact *guided = held(pad(kind)), *free_pad = pad(kind);
        for (int i = 0; i < COUNT; i++) {
            guide(guided, STEPS[i][0], 0, STEPS[i][1], STEPS[i][2]);
            apply(free_pad, STEPS[i][0], 0, STEPS[i][1], STEPS[i][2]);
            assert_true(rw_patch_is_same(edges_of(guided), edges_of(free_pad)));
            assert_true(rw_patch_is_same(stick_zone_of(guided), stick_zone_of(free_pad)));
            assert_true(shear(guided, 0.1) == shear(free_pad, 0.1));
            assert_true(rwedge_contact_dissipated_energy(guided) ==
                        rwedge_contact_dissipated_energy(free_pad));
            assert_true(moment_of(guided) == 0);
        }
    }
}

/* In closed form, which a moment would not have: Q grows with P from touching on. */
CLAIM(a_tilted_cylinder_is_a_cylinder_beside)
{
    rwedge_contact *tilted = held(pad(1)), *level = pad(1);
    guide(tilted, 0, TILT, 0, 0);
    guide(tilted, 1, TILT, 0.2, 0);
    load(level, 1, 0.2);
    for (int i = 0; i < COUNT - 1; i++) {
        apply(tilted, STEPS[i][0], 0, STEPS[i][1], 0);
        load(level, STEPS[i][0], STEPS[i][1]);
        assert_same_edges(tilted, level, MOVED, 1e-14);
        assert_within(rw_patch_middle(stick_zone_of(tilted)), MOVED, 1e-13);
        assert_moved_shear(tilted, level, 1e-12);
        assert_close(moment_of(tilted), MOVED * STEPS[i][0], 1e-13);
    }
    assert_int_equal(rwedge_contact_error(tilted), 0);
}

/* The same of any profile: its slopes less the tilt are those of another one, held level. */
CLAIM(a_tilted_profile_is_that_of_other_slopes)
{
    static const double x[] = {-3, -2, 1, 2.5},
                        slope[] = {-0.1 - TILT, -0.02 - TILT, -TILT, 0.12 - TILT};
    rwedge_contact *tilted = held(trapezoid()), *level = held(create_profile(4, x, slope, F));
    for (int i = 0; i < COUNT - 1; i++) {
        guide(tilted, STEPS[i][0], TILT, STEPS[i][1], 0);
        apply(level, STEPS[i][0], 0, STEPS[i][1], 0);
        assert_same_edges(tilted, level, 0, 1e-13);
        assert_same_shear(tilted, level, 1e-12 * peak_friction(level));
    }
}

/* Where a tension and Q have no closed form, both are computed: the same but for the tolerance. */
CLAIM(a_computed_tilted_cylinder_is_a_computed_one_beside)
{
    const double tolerance = 1e-4;
    rwedge_contact *tilted = allowing(held(pad(1)), tolerance),
                   *level = allowing(pad(1), tolerance);
    guide(tilted, 0, TILT, 0, 0);
    const double steps[][3] = {{1, 0.1, 0.001}, {2, 0.1, -0.002}, {1.5, 0.3, 0.001}};
    for (int i = 0; i < 3; i++) {
        apply(tilted, steps[i][0], 0, steps[i][1], steps[i][2]);
        apply(level, steps[i][0], 0, steps[i][1], steps[i][2]);
        assert_true(rwedge_contact_error(level) > 0);
        assert_moved_shear(tilted, level, 4 * tolerance);
        assert_close(rwedge_contact_dissipated_energy(tilted),
                     rwedge_contact_dissipated_energy(level), 50 * tolerance);
    }
}

/* Where q rises like a root, beside an edge of slip that was, both err more: at some places. */
static void assert_like_shear(const rwedge_contact *actual, const rwedge_contact *expected,
                              double within)
{
    enum { PLACES = 399, MOST = 6 };
    const rw_patch e = edges_of(expected);
    const double most = within * peak_friction(expected);
    int beyond = 0;
    for (int i = 1; i <= PLACES; i++) {
        const double x = e.left + (e.right - e.left) * i / (PLACES + 1);
        beyond += !(fabs(shear(actual, x) - shear(expected, x)) <= most);
    }

    assert_true(beyond <= MOST);
}

/* A held pad that turns under load from one goal to the next, in one step each. Another one is
 * given the moments of many parts of that way, which a third one finds. Their polygon errs by 3e-4;
 * a straight way in M is 5 to 18 % off at most places. */
static void turn_both_ways(int kind, double tolerance)
{
    enum { PARTS = 64 };
    const double goals[][3] = {{1, 0.01, 0}, {2, 0.03, 0.2}, {1.5, -0.02, 0.1}};
    rwedge_contact *guided = allowing(held(pad(kind)), tolerance), *finder = held(pad(kind)),
                   *by_moment = allowing(pad(kind), tolerance);
    guide(guided, 1, 0.01, 0, 0);
    guide(finder, 1, 0.01, 0, 0);
    apply(by_moment, 1, moment_of(finder), 0, 0);
    for (int k = 1; k < 3; k++) {
        const double *from = goals[k - 1], *to = goals[k];
        guide(guided, to[0], to[1], to[2], 0);
        for (int i = 1; i <= PARTS; i++) {
            const double part = i / (double)PARTS, P = from[0] + part * (to[0] - from[0]);
            guide(finder, 0, 0, 0, 0);
            guide(finder, P, from[1] + part * (to[1] - from[1]), 0, 0);
            apply(by_moment, P, moment_of(finder), from[2] + part * (to[2] - from[2]), 0);
        }
        assert_same_edges(guided, by_moment, 0, 1e-12);
        assert_like_shear(guided, by_moment, 1e-3);
        assert_close(rwedge_contact_dissipated_energy(guided),
                     rwedge_contact_dissipated_energy(by_moment), 0.02);
    }
}

CLAIM(a_tilt_that_changes_goes_straight)
{
    for (int kind = 0; kind < 4; kind++)
        turn_both_ways(kind, 1e-4);
}

/* A contact that is held when it is loaded keeps its tilt, and one that is let go its moment. */
CLAIM(a_pad_may_be_held_and_let_go)
{
    for (int kind = 0; kind < 4; kind++) {
        rwedge_contact *contact = pad(kind);
        apply(contact, 1, 0.1, 0, 0);
        const double tilt = rwedge_contact_tilt(contact);
        held(contact);
        apply(contact, 1.5, 7, 0, 0);
        assert_close(rwedge_contact_tilt(contact), tilt, 1e-13);
        const double M = moment_of(contact);
        assert_ok(rwedge_contact_set_rotation(contact, 0));
        rwedge_contact *other = pad(kind);
        apply(contact, 1.5, M, 0.2, 0);
        APPLY(other, {1.5, M, 0, 0}, {1.5, M, 0.2, 0});
        assert_same_edges(contact, other, 0, 1e-13);
        assert_same_shear(contact, other, 1e-12 * peak_friction(other));
        apply(contact, 0, 0, 0, 0);
        assert_true(rwedge_contact_tilt(contact) == 0);
    }
}

CLAIM(a_computed_pad_may_be_held_and_let_go)
{
    const double tolerance = 1e-4;
    rwedge_contact *contact = allowing(pad(2), tolerance), *other = allowing(pad(2), tolerance);
    APPLY(contact, {1, 0.1, 0.1, 0.01});
    APPLY(other, {1, 0.1, 0.1, 0.01});
    assert_true(rwedge_contact_error(contact) > 0);
    held(contact);
    guide(contact, 1.5, rwedge_contact_tilt(contact), 0.1, 0);
    apply(other, 1.5, moment_of(contact), 0.1, 0);
    assert_same_edges(contact, other, 0, 1e-12);
    rwedge_contact *again = restored(state_of(contact));
    assert_ok(rwedge_contact_set_rotation(contact, 0));
    assert_ok(rwedge_contact_set_rotation(again, 0));
    apply(contact, 1.2, 0, 0.1, 0);
    apply(again, 1.2, 0, 0.1, 0);
    assert_state(again, state_of(contact));
}

/* Of a held pad a cycle has the same states as that of the cylinder beside. */
CLAIM(a_cycle_has_a_held_pad)
{
    rwedge_contact *tilted = held(pad(1)), *level = pad(1);
    guide(tilted, 0, TILT, 0, 0);
    const double P[] = {1, 1.5}, M[] = {0, 0}, Q[] = {-0.2, 0.4}, sigma[] = {0, 0};
    load(level, 1, 0);
    apply(tilted, 1, 0, 0, 0);
    rwedge_cycle *at_tilt, *at_level;
    assert_ok(rwedge_cycle_create(tilted, 2, P, M, Q, sigma, &at_tilt));
    assert_ok(rwedge_cycle_create(level, 2, P, M, Q, sigma, &at_level));
    double sxx[2], syy[2], txy[2], exx[2], eyy[2], exy[2];
    const double x = 0.7, beside = x + MOVED, y = 0.3;
    assert_ok(rwedge_cycle_stresses(at_tilt, 2, 1, &beside, &y, sxx, syy, txy));
    assert_ok(rwedge_cycle_stresses(at_level, 2, 1, &x, &y, exx, eyy, exy));
    for (int i = 0; i < 2; i++) {
        assert_within(sxx[i], exx[i], 1e-12);
        assert_within(txy[i], exy[i], 1e-12);
    }
    rwedge_cycle_destroy(at_tilt);
    rwedge_cycle_destroy(at_level);
}

CLAIM(a_held_pad_never_slips_where_the_one_beside_does_not)
{
    rwedge_contact *tilted = held(pad(1)), *level = pad(1);
    guide(tilted, 0, TILT, 0, 0);
    rw_patch moved, own;
    assert_ok(rwedge_contact_permanent_stick(tilted, 1, 0, -0.1, 0, 2, 0, 0.2, 0, &moved.left,
                                             &moved.right));
    assert_ok(
        rwedge_contact_permanent_stick(level, 1, 0, -0.1, 0, 2, 0, 0.2, 0, &own.left, &own.right));
    assert_close(moved.left - MOVED, own.left, 1e-13);
    assert_close(moved.right - MOVED, own.right, 1e-13);
}

CLAIM(the_state_has_the_tilt)
{
    rwedge_contact *contact = held(pad(2));
    guide(contact, 0, TILT, 0, 0.01);
    rwedge_contact *apart = restored(state_of(contact));
    assert_true(rwedge_contact_tilt(apart) == rwedge_contact_tilt(contact));
    guide(contact, 1, TILT, 0.1, 0.01);
    apply(apart, 1, 0, 0.1, 0.01);
    assert_state(apart, state_of(contact));
    rwedge_contact *again = restored(state_of(contact));
    guide(contact, 1, TILT, 0.2, 0.01);
    apply(again, 1, 5, 0.2, 0.01);
    assert_state(again, state_of(contact));
}

CLAIM(what_a_held_pad_refuses)
{
    rwedge_contact *contact = pad(0);
    assert_int_equal(rwedge_contact_guide(contact, 1, 0, 0, 0), RWEDGE_EDOMAIN); /* not held */
    assert_int_equal(rwedge_contact_set_rotation(contact, 2), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_set_rotation(contact, -1), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_set_rotation(NULL, 1), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_guide(NULL, 1, 0, 0, 0), RWEDGE_ENULL);
    held(contact);
    guide(contact, 1, 0.05, 0.1, 0);
    const contact_state before = state_of(contact);
    assert_int_equal(rwedge_contact_guide(contact, 1, THETA, 0, 0), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_guide(contact, 1, NAN, 0, 0), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_guide(contact, 1, 0.05, 0.6, 0), RWEDGE_ESLIDING);
    assert_int_equal(rwedge_contact_guide(contact, 1, 0, 0.1, 0), RWEDGE_EPATH);
    assert_state(contact, before);
    static const double x[] = {0, 1}, slope[] = {0.1, 0.2};
    rwedge_contact *leaning = create_profile(2, x, slope, F);
    assert_int_equal(rwedge_contact_set_rotation(leaning, 1), RWEDGE_EDOMAIN);
}
