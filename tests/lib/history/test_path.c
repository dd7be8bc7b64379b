/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which loads with moment and tension have a closed form, and where they lead. */
#include "histories.h"

#include <fenv.h>

static const double F = 0.5;

CLAIM(what_has_no_closed_form_is_refused)
{
    rwedge_contact *contact = APPLY(create(0.4, F), {0.5, 0.1, 0, 0});
    const double largest = rwedge_contact_largest_tension_step(contact, 0.1);
    refuse(contact, 0.5, 0.1, 0.1, 1.001 * largest, RWEDGE_EPATH); /* slips both ways */
    refuse(contact, 0.5, 0.1, 0, 1e-6, RWEDGE_EPATH);
    refuse(contact, 0.6, 0.12, 0.05, 0, RWEDGE_EPATH); /* grows with shear and tilts */
    refuse(contact, 0.5, 0.1, 0.3, 0, RWEDGE_ESLIDING);
    refuse(contact, 0, 0.1, 0, 0, RWEDGE_EDOMAIN);
    refuse(contact, 0.5, NAN, 0, 0, RWEDGE_EDOMAIN);
    refuse(contact, 0.5, 0.1, 0, HUGE_VAL, RWEDGE_EDOMAIN);
    refuse(contact, 0.5, 1e15, 0, 0, RWEDGE_EDOMAIN);      /* a flank on the surface */
    apply(contact, 0.5, 0.1, 0.1, largest);                /* at the limit */
    refuse(contact, 0.5, 0.2, 0.1, largest, RWEDGE_EPATH); /* one edge recedes */
    apply(contact, 0.6, 0.12, 0.1, largest);
    assert_string_equal(rwedge_contact_obstacle(contact, 0.6, 0.12, 0.1, largest), "");
}

/* The front ends inside the first step's at both edges, but at the left there is a part beyond it
 * that sticks. */
static rwedge_contact *contact_with_two_fronts(void)
{
    rwedge_contact *contact = APPLY(create(0.46, 0.45), {.4779, 0, 0, 0},
                                    {.4779, 0, -.1494, -.0994}, {.4779, 0, -.1029, -.0537});
    return contact;
}

CLAIM(what_sticks_between_two_fronts_is_refused)
{
    rwedge_contact *contact = contact_with_two_fronts();
    refuse(contact, .4779, 0, -.1845, -.0204, RWEDGE_EPATH);
    apply(contact, .4779, 0, -.2008, -.0137);
}

/* The least slip of a step, in its direction, next to the left edge: where the old front was. */
static double least_slip(const rwedge_contact *before, const rwedge_contact *after)
{
    const rw_patch whole = edges_of(after), stick = stick_zone_of(after);
    const double reach = stick.left - whole.left,
                 at_edge = slip(after, whole.left) - slip(before, whole.left);
    double least = HUGE_VAL;
    for (double t = 0; t < 0.9; t += 0.001) {
        const double x = whole.left + t * reach;
        least = fmin(least, (slip(after, x) - slip(before, x)) / at_edge);
    }
    return least;
}

/* Between the refused load and the next one that is not, the limit is where slip vanishes at one
 * point. */
CLAIM(the_limit_is_where_slip_vanishes)
{
    rwedge_contact *before = contact_with_two_fronts();
    double refused = 0, accepted = 1, least = 0;
    while (accepted - refused > 1e-12) {
        const double t = (accepted + refused) / 2;
        rwedge_contact *after = copy_of(before);
        const int32_t status = rwedge_contact_apply(after, .4779, 0, -.1845 + t * (-.2008 + .1845),
                                                    -.0204 + t * (-.0137 + .0204));
        if (status == RWEDGE_OK) {
            accepted = t;
            least = least_slip(before, after);
            assert_true(least > 0);
        } else {
            assert_int_equal(status, RWEDGE_EPATH);
            refused = t;
        }
    }
    assert_true(refused > 0 && accepted < 1 && least < 1e-3);
}

/* Q returns to that of a corner, sigma does not. */
CLAIM(a_corner_with_another_tilt_is_refused)
{
    rwedge_contact *contact =
        APPLY(create(0.4, F), {0.5, 0.1, 0, 0}, {0.5, 0.1, 0.2, 0.02}, {0.5, 0.1, -0.1, -0.03});
    refuse(contact, 0.5, 0.1, 0.2, 0.025, RWEDGE_EPATH);
    apply(contact, 0.5, 0.1, 0.2, 0.02);
}

/* The ring that is added has one D only where the tilt stays as it is. */
CLAIM(rings_with_shear_need_a_constant_tilt)
{
    rwedge_contact *hertz = create(6, F), *centred = create(0.4, F);
    apply(hertz, 0.5, 0.5, 0, 0);
    refuse(hertz, 0.6, 0.59, 0.03, 0, RWEDGE_EPATH);
    refuse(hertz, 0.6, 0.6, 0.03, 0.001, RWEDGE_EPATH);
    apply(hertz, 0.6, 0.6, 0.03, 0);
    assert_true(stick_zone_of(hertz).left == edges_of(hertz).left);
    refuse(hertz, 0.55, 0.54, 0.015, 0, RWEDGE_EPATH);
    apply(hertz, 0.55, 0.55, 0.015, 0); /* along the same line */
    assert_true(stick_zone_of(hertz).left == edges_of(hertz).left);
    APPLY(centred, {0.5, 0, 0, 0}, {0.5, 0, 0.1, 0.01}, {0.6, 0, 0.12, 0.01});
    refuse(centred, 0.7, 0.001, 0.13, 0.01, RWEDGE_EPATH);
    apply(centred, 0.62, 0, 0.2, 0.012); /* and slips */
    hertz = create(6, F);
    apply(hertz, 0.5, 0.5, 0.1, 0); /* from the first touch on */
    assert_close(shear(hertz, 1), 0.4 * F * pressure(hertz, 1), 1e-14);
}

/* What recedes leaves patches of the history at both edges at once, or not at all. */
CLAIM(recession_is_refused_where_it_passes_a_patch_at_one_edge)
{
    rwedge_contact *contact =
        APPLY(create(0.4, F), {0.5, 0.1, 0, 0}, {0.5, 0.1, 0.1, 0.01}, {0.6, 0.12, 0.1, 0.01});
    refuse(contact, 0.45, 0.09, 0.075, 0.01, RWEDGE_EPATH); /* past a corner */
    refuse(contact, 0.51, 0.06, 0.1, 0.01, RWEDGE_EPATH);   /* at one edge */
    apply(contact, 0.55, 0.1, 0.1, 0.01);
    apply(contact, 0.5, 0.1, 0.1, 0.01); /* to the corner, and on */
    APPLY(contact, {0.45, 0.09, 0.1, 0.01}, {0.2, 0.03, 0.04, 0.01});
}

static void assert_same_state(const rwedge_contact *first, const rwedge_contact *second)
{
    assert_within(edges_of(first).left, edges_of(second).left, 1e-14);
    assert_within(stick_zone_of(first).left, stick_zone_of(second).left, 1e-14);
    assert_within(stick_zone_of(first).right, stick_zone_of(second).right, 1e-14);
    assert_int_equal(first->memory.count, second->memory.count);
}

/* What recedes without slip to a patch of the history, and goes on, may do so in one step. */
CLAIM(recession_passes_a_patch_at_both_edges_at_once)
{
    static const double moments[] = {0, 0.2}, ends[] = {0.45, 0.3};
    for (int i = 0; i < 4; i++) {
        const double arm = moments[i / 2], P = ends[i % 2], Q = 0.1;
        rwedge_contact *direct = APPLY(create(0.4, F), {0.5, 0.5 * arm, 0, 0},
                                       {0.5, 0.5 * arm, Q, 0.01}, {0.6, 0.6 * arm, Q, 0.01});
        rwedge_contact *detour = copy_of(direct);
        apply(direct, P, P * arm, Q, 0.01);
        APPLY(detour, {0.5, 0.5 * arm, Q, 0.01}, {P, P * arm, Q, 0.01});
        assert_same_state(direct, detour);
    }
}

/* Each edge recedes and comes back, or the other way round, and stays beyond what carries shear. */
CLAIM(an_edge_that_turns_outside_of_the_shear_moves_nothing)
{
    for (int side = -1; side <= 1; side += 2) {
        rwedge_contact *contact = APPLY(create(0.4, 0.5), {0.1, 0, 0, 0}, {0.1, 0, 0.02, 0});
        const double b = rwedge_contact_half_width(contact), at_edge = slip(contact, 0.99 * b),
                     before = shear(contact, 0.3 * b);
        APPLY(contact, {1, -0.15 * side, 0.02, 0}, {1.31, 0.22 * side, 0.02, 0});
        assert_close(slip(contact, 0.99 * b), at_edge, 1e-12);
        assert_close(shear(contact, 0.3 * b), before, 1e-12);
    }
}

CLAIM(a_tilted_contact_slides)
{
    rwedge_contact *contact = APPLY(create(0.4, F), {0.5, 0.1, 0, 0}, {0.5, 0.1, 0.25, 0.01});
    double x = 0.2, w;
    assert_int_equal(rwedge_contact_stick_zone(contact, &x, &w), RWEDGE_EABSENT);
    assert_close(shear(contact, x), F * pressure(contact, x), 1e-15);
    assert_nan(rwedge_contact_dissipated_energy(contact));
    assert_int_equal(rwedge_contact_slip(contact, 1, &x, &w), RWEDGE_EPATH);
    apply(contact, 0.5, 0.1, 0.1, 0.005);
    apply(contact, 0.5, 0.1, 0.25, 0.005); /* slides again, over a front */
    assert_int_equal(contact->memory.count, 2);
}

/* With |Q| = f P there is one traction, whatever the way: also where the edges part, and where the
 * contact recedes. */
CLAIM(every_way_leads_to_sliding)
{
    static const double to[][4] = {{0.5, 0.2, 0.25, 0.01},
                                   {0.3, 0.06, -0.15, 0.02},
                                   {0.3, -0.06, 0.15, 0},
                                   {0.8, 0.1, 0.4, 1}};
    for (size_t i = 0; i < sizeof to / sizeof *to; i++) {
        rwedge_contact *contact = create(0.4, F), *fresh = create(0.4, F);
        APPLY(contact, {0.5, 0.1, 0, 0}, {0.5, 0.1, 0.25, 0.01});
        const double *l = to[i], sign = l[2] < 0 ? -1 : 1, P = l[0], M = l[1];
        apply(contact, P, M, l[2], l[3]);
        APPLY(fresh, {0, 0, 0, l[3]}, {P, M, 0, l[3]}, {P, M, l[2], l[3]});
        assert_int_equal(contact->memory.count, 2);
        assert_within(shear(contact, 0), sign * F * pressure(contact, 0), 1e-15);
        apply(contact, P, M, 0, l[3] - sign * 0.01);
        apply(fresh, P, M, 0, l[3] - sign * 0.01);
        assert_same_state(contact, fresh);
    }
}

CLAIM(a_moment_may_be_taken_away)
{
    rwedge_contact *contact = create(0.4, F), *fresh = create(0.4, F);
    APPLY(contact, {0.5, 0.05, 0, 0}, {0.4, 0, 0, 0}, {0.4, 0, 0.1, 0});
    APPLY(fresh, {0.4, 0, 0, 0}, {0.4, 0, 0.1, 0});
    assert_true(edges_of(contact).left == edges_of(fresh).left);
    assert_within(stick_zone_of(contact).left, stick_zone_of(fresh).left, 1e-14);
}

/* Without friction the history leaves nothing, and M may do what it will. */
CLAIM(without_friction_all_is_exact)
{
    rwedge_contact *contact =
        APPLY(create(0.4, 0), {0.5, 0.1, 0, 0}, {0.5, -0.3, 0, 2}, {0.3, 0.2, 0, -1});
    rwedge_contact *fresh = APPLY(create(0.4, 0), {0.3, 0.2, 0, 0});
    assert_true(edges_of(contact).left == edges_of(fresh).left);
    assert_int_equal(rwedge_contact_memory(contact), 1);
    assert_true(rwedge_contact_largest_tension_step(contact, 0) == HUGE_VAL);
    assert_string_equal(rwedge_contact_obstacle(contact, 0.2, 0.3, 0, 5), "");
    apply(contact, 0, 0, 0, 0);
}

/* On the way the front of slip has the tilt of a flank: it once divided by nothing. */
CLAIM(a_front_as_steep_as_a_flank_raises_nothing)
{
    rwedge_contact *contact = APPLY(create_wedge(0.5, 0.3, 1, 0.5), {4, 0, 0, 0});
    feclearexcept(FE_ALL_EXCEPT);
    refuse(contact, 2, 1e-16, 0.001, 2, RWEDGE_EPATH);
    assert_int_equal(fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW), 0);
}
