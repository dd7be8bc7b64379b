/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a contact refuses; a refusal leaves it unchanged. The ends of the domain. */
#include "histories.h"

#include <float.h>

CLAIM(a_refused_load_changes_nothing)
{
    const double f = 0.5, P = 0.2;
    rwedge_contact *contact = APPLY(create(0.1, f), {P, 0, 0, 0}, {P, 0, 0.05, 0});
    const struct {
        double P, Q;
        int32_t status;
    } loads[] = {
        {P, 0.1 * (1 + 1e-14), RWEDGE_ESLIDING},
        {P, -0.1 * (1 + 1e-14), RWEDGE_ESLIDING},
        {P, HUGE_VAL, RWEDGE_EDOMAIN},
        {P, NAN, RWEDGE_EDOMAIN},
        {NAN, 0, RWEDGE_EDOMAIN},
        {HUGE_VAL, 0, RWEDGE_EDOMAIN},
        {-1, 0, RWEDGE_EDOMAIN},
        {-0.1, 0, RWEDGE_EDOMAIN},
        {0, 1e-9, RWEDGE_ESLIDING},
        {9e-61, 0, RWEDGE_EDOMAIN},
        {1.1e60, 0.1, RWEDGE_EDOMAIN},
        {P, 9e-61, RWEDGE_EDOMAIN},
        {1e-10, 0, RWEDGE_ERANGE}, /* below 1e-8 of the last */
    };
    for (size_t i = 0; i < sizeof loads / sizeof *loads; i++)
        refuse(contact, loads[i].P, 0, loads[i].Q, 0, loads[i].status);
}

CLAIM(equality_is_full_sliding_to_rounding)
{
    uint64_t seed = 9;
    for (int i = 0; i < 1000; i++) {
        const double f = random_fraction(&seed), P = random_fraction(&seed);
        const double Q =
            f * P * (1 + (2 * random_fraction(&seed) - 1) * 4 * DBL_EPSILON) * (i % 2 ? 1 : -1);
        rwedge_contact *contact = APPLY(create(0.1, f), {P, 0, 0, 0}, {P, 0, Q, 0});
        assert_true(rwedge_contact_stick_half_width(contact) == 0);
        const double x = 0.3 * rwedge_contact_half_width(contact);
        assert_close(shear(contact, x), (i % 2 ? 1 : -1) * f * pressure(contact, x), 1e-15);
    }
}

/* In many steps all are rounded like the first: once refused, or a ring of rounding stuck. */
CLAIM(a_ramp_between_two_sliding_loads_slides)
{
    uint64_t seed = 3;
    for (int number = 0; number < 200; number++) {
        const double f = 0.05 + random_fraction(&seed), from = 0.1 + random_fraction(&seed),
                     to = from * 0.2 * random_fraction(&seed) + 1e-4, sign = number % 2 ? 1 : -1;
        rwedge_contact *contact = APPLY(create(0.1, f), {from, 0, sign * f * from, 0});
        for (int i = 1; i <= 49; i++) {
            const double t = i / 49.0;
            load(contact, from + t * (to - from), sign * (f * from + t * (f * to - f * from)));
            assert_true(rwedge_contact_stick_half_width(contact) == 0);
        }
        /* what does not slide is not taken for it: the rounding of the first load is over */
        load(contact, to, 0);
        load(contact, to, sign * f * to * (1 - 1e-14));
        assert_true(rwedge_contact_stick_half_width(contact) > 0);
    }
}

/* A ring that grows by roundings, with less shear than makes it slip: each of its steps alone might
 * be as steep as friction. */
CLAIM(a_ring_that_grows_by_roundings_does_not_slip)
{
    const double f = 0.5;
    rwedge_contact *contact = APPLY(create(0.1, f), {1, 0, 0, 0}, {1, 0, 0.2 * f, 0});
    for (int i = 1; i <= 3000; i++)
        load(contact, 1 + 2 * i * DBL_EPSILON, (0.2 + 0.6 * i * DBL_EPSILON) * f);
    assert_close(rw_memory_end(&contact->memory)->ratio, 0.3, 0.02);
    assert_true(rwedge_contact_stick_half_width(contact) == rwedge_contact_half_width(contact));
}

CLAIM(without_friction_there_is_no_tangential_load)
{
    rwedge_contact *contact = APPLY(create(0.1, 0), {0.2, 0, 0, 0});
    refuse(contact, 0.2, 0, 1e-60, 0, RWEDGE_ESLIDING);
    assert_true(shear(contact, 0.1) == 0 && slip(contact, 0.1) == 0);
}

CLAIM(what_a_separated_contact_has_not_is_absent)
{
    rwedge_contact *contact = create(0.4, 0.5);
    double out[4] = {7, 7, 7, 7};
    assert_int_equal(rwedge_contact_edges(contact, &out[0], &out[1]), RWEDGE_EABSENT);
    assert_int_equal(rwedge_contact_stick_zone(contact, &out[0], &out[1]), RWEDGE_EABSENT);
    assert_int_equal(rwedge_contact_edge_asymptotes(contact, &out[0], &out[1], &out[2], &out[3]),
                     RWEDGE_EABSENT);
    assert_int_equal(rwedge_contact_yield_factor(contact, 0.3, 1, &out[0], NULL, NULL),
                     RWEDGE_EABSENT);
    assert_true(out[0] == 7 && out[1] == 7 && out[2] == 7 && out[3] == 7);
    assert_true(rwedge_contact_largest_tension_step(contact, 1) == 0);
}

CLAIM(points_without_an_answer_write_nothing)
{
    rwedge_contact *sharp = create(0, 0.5), *contact = create(0.1, 0.5);
    double x[2] = {0.1, 0}, y[2] = {0, 0}, s[3][2] = {{7, 7}, {7, 7}, {7, 7}};
    /* separated: no apex yet */
    assert_ok(rwedge_contact_stresses(sharp, 2, x, y, s[0], s[1], s[2]));
    assert_true(s[0][1] == 0);
    s[0][0] = s[0][1] = s[1][0] = s[2][0] = 7;
    load(sharp, 0.2, 0);
    load(contact, 0.2, 0.05);
    assert_int_equal(rwedge_contact_tractions(sharp, 2, x, s[0], s[1]), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_stresses(sharp, 2, x, y, s[0], s[1], s[2]), RWEDGE_EDOMAIN);
    x[1] = 1.0001 * rwedge_contact_half_width(contact); /* beyond the edge nothing slips */
    assert_int_equal(rwedge_contact_slip(contact, 2, x, s[0]), RWEDGE_EDOMAIN);
    x[1] *= -1;
    assert_int_equal(rwedge_contact_slip(contact, 2, x, s[0]), RWEDGE_EDOMAIN);
    assert_true(s[0][0] == 7 && s[0][1] == 7 && s[1][0] == 7 && s[2][0] == 7);
}
