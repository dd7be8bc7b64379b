/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The strain that a bulk tension makes: bodies of unequal compliance. */
#include "histories.h"

static const double F = 0.5;

static rwedge_contact *with_strain(double strain)
{
    rwedge_contact *contact = create(0.4, F);
    assert_ok(rwedge_contact_set_strain(contact, strain));
    return contact;
}

/* The strain alone matters to the tractions: twice the strain is half the tension. */
CLAIM(strain_takes_the_place_of_tension)
{
    rwedge_contact *like = create(0.4, F), *unlike = with_strain(A / 2);
    apply(like, 0, 0, 0, 0.02);
    apply(unlike, 0, 0, 0, 0.01);
    apply(like, 1, 0.1, 0, 0.02);
    apply(unlike, 1, 0.1, 0, 0.01);
    const double most = rwedge_contact_largest_tension_step(like, 0.2);
    assert_close(rwedge_contact_largest_tension_step(unlike, 0.2), most / 2, 1e-15);
    apply(like, 1, 0.1, 0.2, 0.02 + 0.9 * most);
    apply(unlike, 1, 0.1, 0.2, 0.01 + 0.45 * most);
    const rw_patch stuck = stick_zone_of(like), stuck_unlike = stick_zone_of(unlike);
    assert_close(stuck.left, stuck_unlike.left, 1e-14);
    assert_close(stuck.right, stuck_unlike.right, 1e-14);
    double p, of_like[4], of_unlike[4];
    const double x = stuck.right / 2;
    assert_ok(rwedge_contact_tractions(like, 1, &x, &p, &of_like[0]));
    assert_ok(rwedge_contact_tractions(unlike, 1, &x, &p, &of_unlike[0]));
    assert_close(of_unlike[0], of_like[0], 1e-13);
    assert_ok(
        rwedge_contact_edge_asymptotes(like, &of_like[0], &of_like[1], &of_like[2], &of_like[3]));
    assert_ok(rwedge_contact_edge_asymptotes(unlike, &of_unlike[0], &of_unlike[1], &of_unlike[2],
                                             &of_unlike[3]));
    for (int i = 0; i < 4; i++)
        assert_close(of_unlike[i], of_like[i], 1e-13);
}

/* A rigid half-plane does not stretch: any tension leaves no slip. */
CLAIM(a_tension_may_stretch_nothing)
{
    rwedge_contact *contact = APPLY(with_strain(0), {1, 0, 0, 0}, {1, 0, 0, 1e6});
    assert_true(rwedge_contact_largest_tension_step(contact, 0.1) == HUGE_VAL);
    assert_true(rwedge_contact_dissipated_energy(contact) == 0);
}

CLAIM(it_is_set_while_the_bodies_are_apart)
{
    rwedge_contact *contact = create(0.4, F);
    assert_int_equal(rwedge_contact_set_strain(contact, -1), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_set_strain(contact, NAN), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_set_strain(contact, HUGE_VAL), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_set_strain(contact, 1e60), RWEDGE_EDOMAIN); /* over A */
    apply(contact, 1, 0, 0, 0);
    assert_int_equal(rwedge_contact_set_strain(contact, A / 2), RWEDGE_EDOMAIN);
    apply(contact, 0, 0, 0, 0.02); /* is there before the contact, and slips nothing */
    assert_ok(rwedge_contact_set_strain(contact, A / 2));
    APPLY(contact, {1, 0, 0, 0.02}, {1, 0, 0.2, 0.02});
    assert_true(rw_patch_middle(stick_zone_of(contact)) == 0);
}
