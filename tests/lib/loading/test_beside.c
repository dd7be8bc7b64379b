/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Slip and energy where the tractions alone have a closed form: they are computed beside it. */
#include "histories.h"

enum { PROGRAMMES = 15, LOADS = 8 };

static const double F = 0.5;

/* P, M, Q and sigma by chance; nothing slides. */
static rw_loads random_loads(uint64_t *seed)
{
    const double P = random_between(seed, 0.3, 0.7);
    return (rw_loads){P, random_between(seed, -0.03, 0.03), random_between(seed, -0.8, 0.8) * F * P,
                      random_between(seed, -0.2, 0.2)};
}

static rwedge_contact *pad_of(int number)
{
    return number % 3 == 0   ? create(0.4, F)
           : number % 3 == 1 ? create_flat(0, 10, A, F)
                             : create_flat(0.4, 10, A, F);
}

static double slip_in_middle(const rwedge_contact *contact)
{
    return slip(contact, rw_patch_middle(edges_of(contact)));
}

CLAIM(no_programme_loses_its_slip_or_its_energy)
{
    for (int number = 0; number < PROGRAMMES; number++) {
        uint64_t seed = (uint64_t)number + 1;
        rwedge_contact *contact = allowing(pad_of(number), 1e-3);
        double energy = 0;
        apply(contact, 0.5, 0, 0, 0);
        for (int i = 0; i < LOADS; i++) {
            const rw_loads to = random_loads(&seed);
            apply(contact, to.P, to.M, to.Q, to.sigma);
            assert_true(isfinite(slip_in_middle(contact)));
            assert_true(rwedge_contact_dissipated_energy(contact) >= energy);
            energy = rwedge_contact_dissipated_energy(contact);
        }
        apply(contact, 0, 0, 0, 0);
        assert_true(rwedge_contact_dissipated_energy(contact) >= energy);
    }
}

/* In phase: P, Q and sigma on one straight line, to and fro. */
static const rw_loads IN_PHASE[] = {
    {0.5, 0, 0, 0}, {0.55, 0, 0.15, 0.0394}, {0.45, 0, -0.05, 0.0079}, {0.55, 0, 0.15, 0.0394}};

CLAIM(tractions_keep_the_bits_of_their_closed_form)
{
    rwedge_contact *exact = create_flat(0, 10, A, F), *other = allowing(copy_of(exact), 1e-3);
    for (int i = 0; i < 4; i++) {
        const rw_loads to = IN_PHASE[i];
        apply(exact, to.P, to.M, to.Q, to.sigma);
        apply(other, to.P, to.M, to.Q, to.sigma);
        assert_same_shear(other, exact, 0);
        assert_true(rwedge_contact_error(other) == 0);
    }
    assert_nan(rwedge_contact_dissipated_energy(exact));
    assert_true(rwedge_contact_dissipated_energy(other) > 0);
}

/* In a cycle the slip at its end is that at its beginning, and each cycle dissipates as much. */
CLAIM(a_cycle_closes)
{
    rwedge_contact *contact = allowing(create_flat(0, 10, A, F), 1e-4);
    double before[2] = {0, 0}, slip_before[2] = {0, 0};
    APPLY(contact, IN_PHASE[0], IN_PHASE[1]);
    for (int cycle = 0; cycle < 3; cycle++) {
        APPLY(contact, IN_PHASE[2], IN_PHASE[1]);
        before[0] = before[1], slip_before[0] = slip_before[1];
        before[1] = rwedge_contact_dissipated_energy(contact);
        slip_before[1] = slip(contact, 0.9 * edges_of(contact).left);
    }
    const double energy =
        rwedge_contact_dissipated_energy(APPLY(contact, IN_PHASE[2], IN_PHASE[1]));
    assert_close(energy - before[1], before[1] - before[0], 1e-3);
    assert_close(slip(contact, 0.9 * edges_of(contact).left), slip_before[1], 1e-3);
}

/* A copy, and what is restored, go on to the same bits. */
CLAIM(what_is_beside_is_copied_and_restored)
{
    rwedge_contact *contact = allowing(create_flat(0, 10, A, F), 1e-3);
    apply_all(contact, 3, IN_PHASE);
    rwedge_contact *twins[] = {copy_of(contact), restored(state_of(contact))};
    apply_all(contact, 1, IN_PHASE + 3);
    for (int i = 0; i < 2; i++)
        assert_state(apply_all(twins[i], 1, IN_PHASE + 3), state_of(contact));
}

/* The energy of a cycle by its places, with the midpoint rule over the contact. */
static double energy_by_places(const rwedge_contact *contact, const rw_loads cycle[2])
{
    enum { STEPS = 400 };
    const double P[] = {cycle[0].P, cycle[1].P}, M[] = {cycle[0].M, cycle[1].M},
                 Q[] = {cycle[0].Q, cycle[1].Q}, sigma[] = {0, 0};
    rwedge_cycle *made = NULL;
    double x[STEPS], slip_range[STEPS], f1[STEPS], f2[STEPS], energy[STEPS], sum = 0;
    const rw_patch widest = edges_of(APPLY(copy_of(contact), cycle[0])); /* P and M are largest */
    const double left = widest.left, step = (widest.right - left) / STEPS;
    for (int i = 0; i < STEPS; i++)
        x[i] = left + (i + 0.5) * step;
    assert_ok(rwedge_cycle_create(contact, 2, P, M, Q, sigma, &made));
    const int32_t status = rwedge_cycle_friction(made, STEPS, x, slip_range, f1, f2, energy);
    rwedge_cycle_destroy(made);
    assert_ok(status);
    for (int i = 0; i < STEPS; i++)
        sum += energy[i] * step;
    return sum;
}

/* P varies by 20 %, with Q and a moment: every load was computed, and the energy was NaN. */
CLAIM(a_flat_pad_with_a_moment_under_a_varying_load_knows_its_energy)
{
    static const rw_loads cycle[2] = {{0.6, 0.03, 0.12, 0}, {0.4, -0.02, -0.08, 0}};
    rwedge_contact *contact = allowing(create_flat(0.4, 10, A, F), 1e-4);
    apply(contact, 0.5, 0, 0, 0);
    double before = 0, energy = 0;
    for (int i = 0; i < 4; i++) {
        before = energy;
        apply_all(contact, 2, cycle);
        energy = rwedge_contact_dissipated_energy(contact);
        assert_true(energy > before);
    }
    assert_close(energy - before, energy_by_places(contact, cycle), 0.01); /* 0.2 % of the cycle */
}

/* What is refused leaves the contact and what is beside it as they were. */
CLAIM(a_refusal_changes_nothing)
{
    rwedge_contact *contact = allowing(create_flat(0, 10, A, F), 1e-3);
    apply_all(contact, 3, IN_PHASE);
    const contact_state before = state_of(contact);
    assert_int_equal(rwedge_contact_apply(contact, 0.5, 0, 0.3, 0), RWEDGE_ESLIDING);
    assert_int_equal(rwedge_contact_apply(contact, 1e3, 0, 0, 0), RWEDGE_ERANGE);
    assert_state(contact, before);
}

/* Full sliding off the centre does not tell how far it slides. */
CLAIM(full_sliding_and_no_tolerance_lose_both)
{
    rwedge_contact *contact = allowing(create_flat(0, 10, A, F), 1e-3);
    apply_all(contact, 3, IN_PHASE);
    rwedge_contact *other = copy_of(contact);
    apply(contact, 0.5, 0, 0.25, 0.05);
    assert_nan(rwedge_contact_dissipated_energy(contact));
    assert_ok(rwedge_contact_allow_error(other, 0));
    assert_nan(rwedge_contact_dissipated_energy(other));
}
