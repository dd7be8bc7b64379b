/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which loads are taken, and which are not: at the edges of what has a closed form. */
#include "histories.h"

static const double F = 0.5;

static rwedge_contact *example(void)
{
    return create_wedge(0.01, 1, 1e-5, 0.3);
}

static void assert_same_tractions(const rwedge_contact *one, const rwedge_contact *other,
                                  double tolerance)
{
    const rw_patch patch = rw_memory_end(&one->memory)->patch;
    for (double t = 0.005; t < 1; t += 0.0173) {
        const double x = patch.left + t * (patch.right - patch.left);
        assert_within(shear(one, x), shear(other, x), tolerance * fabs(pressure(one, x)));
    }
}

/* ---- Nothing slips without a change of shear ---- */

CLAIM(a_contact_without_shear_may_rock)
{
    rwedge_contact *rocked = example(), *fresh = example();
    const double moments[] = {300, -500, 0, 250};
    apply(rocked, 2000, 0, 0, 0);
    for (int i = 0; i < 4; i++)
        apply(rocked, 2000 - 100 * i, moments[i], 0, 0);
    assert_true(rwedge_contact_dissipated_energy(rocked) == 0);
    apply(fresh, 1700, 250, 0, 0);
    apply(rocked, 1700, 250, 150, 0);
    apply(fresh, 1700, 250, 150, 0);
    assert_same_tractions(rocked, fresh, 1e-14);
    const double x = 0.99 * rw_memory_end(&fresh->memory)->patch.right;
    assert_close(slip(rocked, x), slip(fresh, x), 1e-13);
}

/* The shear stays what it was, point by point, as long as the contact keeps the patch of 2000. */
CLAIM(a_contact_may_move_around_its_last_sheared_patch)
{
    rwedge_contact *contact = APPLY(example(), {2000, 0, 0, 0}, {2000, 0, 200, 0});
    const rwedge_contact *before = copy_of(contact);
    apply(contact, 6000, 0, 200, 0);
    const double loads[][2] = {{6000, 1500}, {5000, -3000}, {5600, 2500}, {3500, 500}};
    for (int i = 0; i < 4; i++) {
        apply(contact, loads[i][0], loads[i][1], 200, 0);
        assert_same_tractions(contact, before, 1e-13);
    }
    assert_true(rwedge_contact_dissipated_energy(contact) ==
                rwedge_contact_dissipated_energy(before));
    refuse(contact, 2500, 1800, 200, 0, RWEDGE_EPATH);
}

/* Both ends of the step have an edge outside of the patch, what is between has not. */
CLAIM(an_edge_may_not_come_inside_on_the_way)
{
    rwedge_contact *contact =
        APPLY(example(), {2000, 0, 0, 0}, {2000, 0, 200, 0}, {12000, 0, 200, 0}, {2001, 0, 200, 0});
    const rw_patch sheared = contact->memory.corners[2].patch;
    const double P = 12000;
    double kept = 0, lost = 12000; /* the moment that lets the left edge be where it was */
    while (lost - kept > 1e-6) {
        const double M = (kept + lost) / 2;
        const rw_patch patch = rw_patch_under_moment(&contact->geometry, P, M);
        *(patch.left < sheared.left ? &kept : &lost) = M;
    }
    rwedge_contact *one = copy_of(contact), *two = copy_of(contact);
    refuse(one, P, 0.999999 * kept, 200, 0, RWEDGE_EPATH);
    APPLY(two, {P, 0, 200, 0}, {P, 0.999999 * kept, 200, 0});
}

/* ---- Rounding ---- */

/* Each load is within rounding of the one before, not of the first. */
CLAIM(small_steps_of_p_do_not_get_lost)
{
    rwedge_contact *many = example(), *one = example();
    const double last = 1000 + 100 * 7 * 1.1369e-13;
    apply(many, 1000, 100, 0, 0);
    apply(one, 1000, 100, 0, 0);
    for (int n = 1; n <= 100; n++)
        apply(many, 1000 + n * 7 * 1.1369e-13, 100, 0, 0);
    apply(one, last, 100, 0, 0);
    const rw_patch of_many = rw_memory_end(&many->memory)->patch,
                   of_one = rw_memory_end(&one->memory)->patch;
    assert_within(of_many.right, of_one.right, 1e-15);
    assert_within(of_many.left, of_one.left, 1e-15);
    assert_true(of_one.right - 0.8978845608028654 > 1e-14);
}

CLAIM(rounding_of_q_under_a_moment_is_taken)
{
    static const double Q[] = {0, 200, 200.00000000001762, 199.99999999999085, 199.99999999999022};
    for (double M = 50; M < 500; M += 50) {
        rwedge_contact *contact = example();
        for (int i = 0; i < 5; i++)
            apply(contact, 2000, M, Q[i], 0);
    }
}

/* The same history at any size of the contact beside the rounding. Hertz' contact has no other
 * length. */
CLAIM(tiny_contacts_are_refused_what_small_ones_are)
{
    static const double Q[] = {0, -2.340588563211545, -3.5136028594429534, -3.9963298589392195},
                        sigma[] = {0, 22.465807666218144, 23.38291026065916, 34.496387747296794};
    int32_t last[2];
    for (int i = 0; i < 2; i++) {
        const double k = i == 0 ? 1 : 9e-13;
        rwedge_contact *contact = APPLY(example(), {15.707963267948966 * k * k, 0, 0, 0});
        for (int j = 1; j < 4; j++)
            last[i] = rwedge_contact_apply(contact, 15.707963267948966 * k * k, 0, Q[j] * k * k,
                                           sigma[j] * k);
    }
    assert_int_equal(last[0], RWEDGE_EPATH);
    assert_int_equal(last[1], RWEDGE_EPATH);
}

/* Beside the distance from the centre rounding leaves no width: of the contact, and of what
 * sticks. */
CLAIM(patches_without_a_width_are_out_of_range)
{
    rwedge_contact *contact = create_wedge(.015781919866758993, 1, 7.660340870436608e-06, .3);
    const double P = 4.268686012845966e-30, M = 3.761515666081952e-30;
    refuse(contact, P, M, 0, 0, RWEDGE_ERANGE);
    assert_ok(rwedge_contact_allow_error(contact, 1e-2));
    refuse(contact, P, M, 0, 1e-30, RWEDGE_ERANGE);
    const double load = 1.5707963267948967e-17, moment = 7.853981633974484e-18;
    contact = APPLY(example(), {load, moment, 0, 0});
    refuse(contact, load, moment, 4.712388980384643e-18, 0, RWEDGE_ERANGE);
}

/* ---- Parts of a step ---- */

static rw_loads random_loads(const rwedge_contact *contact, uint64_t *seed)
{
    rw_loads to = contact->loads;
    const double kind = random_fraction(seed), P = to.P;
    if (kind < 0.6) {
        const double times = kind < 0.3 ? 1 + 0.2 * random_fraction(seed) : 0.7 + kind / 2;
        to.P *= times;
        to.M = to.M * times +
               (random_fraction(seed) < 0.3 ? 0.05 * P * random_between(seed, -1, 1) : 0);
    }
    if (kind < 0.15) {
        to.Q += F * (to.P - P) * random_between(seed, -1, 1);
        return to;
    }
    to.Q = 0.95 * F * to.P * random_between(seed, -1, 1);
    to.sigma += rwedge_contact_largest_tension_step(contact, to.Q) * random_between(seed, -1, 1);
    return to;
}

/* Along random histories, a step that goes in parts goes in one, to the same tractions. */
CLAIM(a_step_that_goes_in_parts_goes_in_one)
{
    uint64_t seed = 11;
    int compared = 0;
    for (int number = 0; number < 60; number++) {
        rwedge_contact *contact = create(0.4 * (number % 4), F);
        const double P = 0.05 + random_fraction(&seed);
        apply(contact, P, 0.3 * P * random_between(&seed, -1, 1), 0, 0);
        for (int i = 0; i < 8; i++) {
            const rw_loads to = random_loads(contact, &seed);
            rwedge_contact *parts = copy_of(contact);
            const int32_t in_parts = try_parts(parts, to, 2 + number % 3, NULL),
                          in_one = try_load(contact, to);
            if (in_parts == RWEDGE_OK) {
                assert_ok(in_one);
                assert_same_tractions(contact, parts, 1e-9);
                compared++;
            }
        }
    }
    assert_true(compared > 100);
}

/* The third step reaches back over the first two at both edges. Halfway its front has passed the
 * older one at the right edge alone: those of Nowell and Hills (1987), whose halves reverse. */
CLAIM(a_line_may_pass_loads_without_a_closed_form)
{
    const double R = 178, f = 0.65, P = 488, compliance = rwedge_compliance(74100, .33, 74100, .33);
    rwedge_contact *contact =
        APPLY(create_wedge(0.1, 17.8, compliance, f), {P, 0, 0, 0}, {P, 0, 200, 100}, {P, 0, 0, 0});
    const double half = rwedge_contact_half_width(contact), strain = compliance / 4;
    const double older = half * sqrt(1 - 200 / (2 * f * P)),
                 older_middle = strain * 100 * R / f / 2;
    const double front = half * sqrt(1 - 125 / (2 * f * P)), middle = strain * 30 * R / f / 2;
    assert_true(middle + front < older_middle + older); /* inside of it at the right */
    assert_true(middle - front < older_middle - older); /* outside at the left */
    refuse(contact, P, 0, 125, 30, RWEDGE_EPATH);
    apply(contact, P, 0, 250, 60);
}
