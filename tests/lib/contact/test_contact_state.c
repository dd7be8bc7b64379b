/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A contact as numbers. */
#include "histories.h"

#include <string.h>

enum { MOST = 4096 };

static size_t state_of(const rwedge_contact *contact, double numbers[MOST])
{
    const size_t n = rwedge_contact_state_size(contact);
    assert_true(n <= MOST);
    assert_int_equal(rwedge_contact_state(contact, n, numbers), RWEDGE_OK);
    return n;
}

static rwedge_contact *restore(size_t n, const double numbers[])
{
    rwedge_contact *restored;
    assert_int_equal(rwedge_contact_restore(n, numbers, &restored), RWEDGE_OK);
    return restored;
}

static void assert_same(const rwedge_contact *one, const rwedge_contact *other)
{
    static double first[MOST], second[MOST];
    const size_t n = state_of(one, first);
    assert_int_equal(state_of(other, second), n);
    assert_memory_equal(first, second, n * sizeof *first);
}

/* Random histories, saved after each load. */
static void a_restored_contact_goes_on_to_the_same_bits(void **state)
{
    (void)state;
    static double numbers[MOST];
    for (int number = 0; number < 40; number++) {
        random_history history, of_restored;
        rwedge_contact *contact = begin(&history, number);
        for (int i = 0; i < 6; i++) {
            rwedge_contact *restored = restore(state_of(contact, numbers), numbers);
            assert_same(contact, restored);
            of_restored = history;
            go_on(&of_restored, restored);
            go_on(&history, contact);
            assert_same(contact, restored);
            const double x = 0.7 * rwedge_contact_half_width(contact);
            assert_true(shear(contact, x) == shear(restored, x) &&
                        slip(contact, x) == slip(restored, x));
            rwedge_contact_destroy(restored);
        }
        rwedge_contact_destroy(contact);
    }
}

static void moment_and_tension_are_in_it(void **state)
{
    (void)state;
    static double numbers[MOST];
    rwedge_contact *contact = create(0.4, 0.5);
    const double loads[][4] = {{0.5, 0.1, 0, 0}, {0.5, 0.1, 0.15, 0.02}, {0.45, 0.09, 0.15, 0.02}};
    for (size_t i = 0; i < sizeof loads / sizeof *loads; i++) {
        assert_int_equal(
            rwedge_contact_apply(contact, loads[i][0], loads[i][1], loads[i][2], loads[i][3]),
            RWEDGE_OK);
        rwedge_contact *restored = restore(state_of(contact, numbers), numbers);
        assert_same(contact, restored);
        double P, M, Q, sigma;
        assert_int_equal(rwedge_contact_loads(restored, &P, &M, &Q, &sigma), RWEDGE_OK);
        assert_true(P == loads[i][0] && M == loads[i][1] && Q == loads[i][2] &&
                    sigma == loads[i][3]);
        rwedge_contact_destroy(restored);
    }
    rwedge_contact_destroy(contact);
}

/* Each number, changed; each length but the right one. */
static void damage_is_noticed(void **state)
{
    (void)state;
    static double numbers[MOST];
    random_history history;
    rwedge_contact *contact = begin(&history, 3), *untouched = NULL;
    for (int i = 0; i < 5; i++)
        go_on(&history, contact);
    const size_t n = state_of(contact, numbers);
    for (size_t i = 0; i < n; i++) {
        const double kept = numbers[i];
        numbers[i] = isfinite(kept) ? nextafter(kept, 7) : 0;
        assert_int_equal(rwedge_contact_restore(n, numbers, &untouched), RWEDGE_EDOMAIN);
        numbers[i] = kept;
        assert_int_equal(rwedge_contact_restore(i, numbers, &untouched), RWEDGE_EDOMAIN);
    }
    assert_null(untouched);
    assert_int_equal(rwedge_contact_restore(n, NULL, &untouched), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_restore(n, numbers, NULL), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_state(contact, n + 1, numbers), RWEDGE_ERANGE);
    assert_int_equal(rwedge_contact_state(NULL, n, numbers), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_state(contact, n, NULL), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_state_size(NULL), 0);
    rwedge_contact_destroy(contact);
}

/* A state that was damaged on purpose, its sum of bits put right. */
static void sign(size_t n, double numbers[])
{
    uint64_t sum = 0xcbf29ce484222325;
    for (size_t i = 2; i < n; i++) {
        uint64_t bits;
        memcpy(&bits, &numbers[i], sizeof bits);
        sum = (sum ^ bits) * 0x100000001b3 ^ (sum >> 29);
    }
    numbers[1] = (double)(sum >> 12);
}

/* What still is a contact may be used. */
static void assert_refused_or_usable(size_t n, double numbers[])
{
    rwedge_contact *restored = NULL;
    sign(n, numbers);
    const int32_t status = rwedge_contact_restore(n, numbers, &restored);
    if (status == RWEDGE_OK) {
        double left, right;
        (void)rwedge_contact_edges(restored, &left, &right);
        (void)rwedge_contact_apply(restored, 0.5, 0, 0.01, 0);
        rwedge_contact_destroy(restored);
    } else {
        assert_int_equal(status, RWEDGE_EDOMAIN);
        assert_null(restored);
    }
}

static void damage_that_is_signed_does_no_harm(void **state)
{
    (void)state;
    static const double BAD[] = {NAN, HUGE_VAL, -HUGE_VAL, -1, 0, 0.5, 1, 2, 1e300};
    static double numbers[MOST];
    rwedge_contact *centred = create(0.4, 0.5), *tilted = create(0.4, 0.5), *none = create(0.4, 0);
    load(centred, 0.5, 0);
    load(centred, 0.5, 0.1);
    load(centred, 0.7, 0.1);
    load(centred, 0.7, -0.1);
    assert_int_equal(rwedge_contact_apply(tilted, 0.5, 0.1, 0, 0), RWEDGE_OK);
    assert_int_equal(rwedge_contact_apply(tilted, 0.5, 0.1, 0.1, 0.01), RWEDGE_OK);
    const rwedge_contact *contacts[] = {centred, tilted, none};
    for (int k = 0; k < 3; k++) {
        const size_t n = state_of(contacts[k], numbers);
        for (size_t i = 2; i < n; i++) {
            const double kept = numbers[i];
            for (size_t j = 0; j < sizeof BAD / sizeof *BAD; j++) {
                numbers[i] = BAD[j];
                assert_refused_or_usable(n, numbers);
            }
            numbers[i] = kept;
            assert_refused_or_usable(i + 1, numbers);
        }
        assert_refused_or_usable(n + 1, numbers);
    }
    const size_t n = state_of(none, numbers);
    numbers[2] = 1e-50; /* theta */
    numbers[4] = 1e50;  /* A: each is in the domain, theta/A is not */
    assert_refused_or_usable(n, numbers);
    rwedge_contact_destroy(centred);
    rwedge_contact_destroy(tilted);
    rwedge_contact_destroy(none);
}

/* A state of the first version, which did not hold the strain, is that of equal compliances. */
static void older_states_are_read(void **state)
{
    (void)state;
    enum { STRAIN = 2 + 13 }; /* its place */
    static double numbers[MOST];
    rwedge_contact *contact = create(0.4, 0.5);
    load(contact, 0.5, 0.1);
    const size_t n = state_of(contact, numbers);
    memmove(numbers + STRAIN, numbers + STRAIN + 1, (n - STRAIN - 1) * sizeof *numbers);
    numbers[0] = 1;
    sign(n - 1, numbers);
    rwedge_contact *restored = restore(n - 1, numbers);
    assert_same(restored, contact);
    rwedge_contact_destroy(restored);
    rwedge_contact_destroy(contact);
}

static void the_strain_is_in_it(void **state)
{
    (void)state;
    static double numbers[MOST];
    rwedge_contact *contact = create(0.4, 0.5);
    assert_int_equal(rwedge_contact_set_strain(contact, A), RWEDGE_OK);
    rwedge_contact *restored = restore(state_of(contact, numbers), numbers);
    load(contact, 1, 0);
    load(restored, 1, 0);
    assert_true(rwedge_contact_largest_tension_step(restored, 0.1) ==
                rwedge_contact_largest_tension_step(contact, 0.1));
    rwedge_contact_destroy(restored);
    rwedge_contact_destroy(contact);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_restored_contact_goes_on_to_the_same_bits),
        cmocka_unit_test(moment_and_tension_are_in_it),
        cmocka_unit_test(damage_is_noticed),
        cmocka_unit_test(damage_that_is_signed_does_no_harm),
        cmocka_unit_test(older_states_are_read),
        cmocka_unit_test(the_strain_is_in_it),
    };
    return RUN_CLAIMS("contact_state", tests);
}
