/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The slip length at an edge, and what never slips between two loads. */
#include "histories.h"

static const double F = 0.5;

/* Of a pad that need not be loaded. */
static int32_t stick_between(const rwedge_contact *pad, rw_loads one, rw_loads two, double *left,
                             double *right)
{
    return rwedge_contact_permanent_stick(pad, one.P, one.M, one.Q, one.sigma, two.P, two.M, two.Q,
                                          two.sigma, left, right);
}

/* The slip length 2 K_T/(f K_N) of a small Q: to 0.1 % at Q/(fP) = 0.001, 9 % at 0.1. */
CLAIM(the_slip_length_is_that_of_the_asymptotes)
{
    static const double ratios[] = {0.001, 0.1}, within[] = {0.002, 0.1};
    for (int i = 0; i < 2; i++) {
        rwedge_contact *contact =
            APPLY(create(0.4, F), {0.5, 0.1, 0, 0}, {0.5, 0.1, ratios[i] * F * 0.5, 0});
        double left, right, shear_left, shear_right;
        assert_ok(
            rwedge_contact_edge_asymptotes(contact, &left, &right, &shear_left, &shear_right));
        assert_close(stick_zone_of(contact).left - edges_of(contact).left,
                     2 * shear_left / (F * left), within[i]);
        assert_close(edges_of(contact).right - stick_zone_of(contact).right,
                     2 * shear_right / (F * right), within[i]);
    }
}

/* The stick zone after the third half-cycle, whatever came first. */
CLAIM(what_never_slips_is_what_cycles_leave)
{
    rwedge_contact *contact =
        APPLY(create(0.4, F), {0.5, 0.1, 0, 0}, {0.5, 0.1, 0.2, 0.02}, {0.5, 0.1, -0.1, -0.03},
              {0.5, 0.1, 0.2, 0.02}, {0.5, 0.1, -0.1, -0.03});
    double left, right;
    assert_ok(stick_between(create(0.4, F), (rw_loads){0.5, 0.1, -0.1, -0.03},
                            (rw_loads){0.5, 0.1, 0.2, 0.02}, &left, &right));
    assert_within(stick_zone_of(contact).left, left, 1e-13);
    assert_within(stick_zone_of(contact).right, right, 1e-13);
}

/* The ring between P = 300 and 488 takes up the change of Q: the energy stays that of the first
 * load. */
CLAIM(the_whole_smaller_contact_may_stick)
{
    double left, right;
    rwedge_contact *contact = APPLY(create_wedge(.1, 17.8, 4.81e-5, .65), {300, 0, 0, 0});
    assert_ok(stick_between(contact, (rw_loads){300, 0, 140, 0}, (rw_loads){488, 0, 60, 0}, &left,
                            &right));
    assert_within(right, edges_of(contact).right, 1e-14 * right);
    assert_within(left, edges_of(contact).left, 1e-14 * right);
    apply(contact, 300, 0, 140, 0);
    const double energy = rwedge_contact_dissipated_energy(contact);
    for (int i = 0; i < 3; i++) {
        APPLY(contact, {488, 0, 60, 0}, {300, 0, 140, 0});
    }
    assert_true(rwedge_contact_dissipated_energy(contact) == energy);
}

/* Q may exceed f P by rounding, as everywhere. */
CLAIM(a_cycle_may_touch_sliding)
{
    double left, right, l, r;
    const rw_loads rests = {1000, 0, 0, 0};
    const rwedge_contact *pad = create(0.4, 0.3);
    assert_ok(
        stick_between(pad, (rw_loads){1000, 0, nextafter(300, 400), 0}, rests, &left, &right));
    assert_ok(stick_between(pad, (rw_loads){1000, 0, 300, 0}, rests, &l, &r));
    assert_within(right, r, 1e-15 * r);
}

CLAIM(cycles_without_a_permanent_stick_zone_say_why)
{
    static const struct {
        double f, v[8]; /* P, M, Q, sigma twice */
        int32_t status;
    } cases[] = {
        {0, {0.5, 0, 0, 0, 0.6, 0, 0, 1}, RWEDGE_EABSENT},
        {0, {0.5, 0, 0, 0, 0.6, 0, 0.1, 0}, RWEDGE_ESLIDING},
        {0, {0.5, 0, 0.1, 0, 0.6, 0, 0, 0}, RWEDGE_ESLIDING},
        {0.5, {0.5, 0, 0.3, 0, 0.6, 0, 0, 0}, RWEDGE_ESLIDING},
        {0.5, {0.5, 0, 0, 0, 0.6, 0, 0.4, 0}, RWEDGE_ESLIDING},
        {0.5, {0.5, 0, -0.25, 0, 0.5, 0, 0.25, 0}, RWEDGE_EABSENT},
        {0.5, {0.5, 0, 0, -1, 0.5, 0, 0.01, 1}, RWEDGE_EPATH},
        {0.5, {0.5, 0.3, 0, 0, 0.6, -0.3, 0.01, 0}, RWEDGE_EPATH},
        {0.5, {0.9, 0.3, 0, 0, 0.2, 0, 0.01, 0}, RWEDGE_EPATH}, /* an edge passes it on the way */
        {0.5, /* each is outside of the other at one edge */
         {0.92, 0.425, 0.1325, 0.0103, 0.847, -0.3315, -0.1325, -0.0103},
         RWEDGE_EPATH},
        {0.5, {0.9, 0, 0, 0, 0, 0, 0, 0}, RWEDGE_EABSENT},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const double *v = cases[i].v;
        double left = 7, right = 7;
        assert_int_equal(stick_between(create(0.4, cases[i].f), (rw_loads){v[0], v[1], v[2], v[3]},
                                       (rw_loads){v[4], v[5], v[6], v[7]}, &left, &right),
                         cases[i].status);
        assert_true(left == 7 && right == 7);
    }
}
